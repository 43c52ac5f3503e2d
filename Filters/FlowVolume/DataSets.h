// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A data object, composite or not, as its datasets.
#ifndef nephoscope_DataSets_h
#define nephoscope_DataSets_h

#include "VelocityField.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{
// Those that have cells: the leaves of a composite dataset, or the dataset itself.
std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data);

// Diagonal of the bounds of all.
double DiagonalOf(const std::vector<vtkDataSet*>& sets);

vtkMTimeType NewestMTime(vtkDataObject* data);

// A copy that shares the arrays, and stays as it is when a reader fills its output anew.
vtkSmartPointer<vtkDataObject> SharedCopy(vtkDataObject* data);

// Why there is no velocity at a position: a sentence.
std::string WhyNoVelocity(const std::vector<vtkDataSet*>& sets, const Vector3& position);
}

#endif
