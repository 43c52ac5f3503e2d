// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A data object, composite or not, as its datasets.
#ifndef nephoscope_DataSets_h
#define nephoscope_DataSets_h

#include "VelocityField.h"
#include "vtkNephoscopeFiltersVelocityFieldModule.h" // for export macro

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkBoundingBox;
class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{
// Those that have cells: the leaves of a composite dataset, or the dataset itself.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data);

// Bounds of the points at finite places; not valid where there are none.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT vtkBoundingBox FiniteBounds(vtkDataSet* set);
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT vtkBoundingBox BoundsOf(const std::vector<vtkDataSet*>& sets);

VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT vtkMTimeType NewestMTime(vtkDataObject* data);

// A copy that shares the arrays, and stays as it is when a reader fills its output anew.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT vtkSmartPointer<vtkDataObject> SharedCopy(vtkDataObject* data);

// Why there is no velocity at a position in a cell: a sentence. Empty if it is in no cell.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::string WhyNoVelocityInside(const std::vector<vtkDataSet*>& sets, const Vector3& position);

// The same for a position in no cell of data with these bounds.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::string WhyOutside(const vtkBoundingBox& box, const Vector3& position);
}

#endif
