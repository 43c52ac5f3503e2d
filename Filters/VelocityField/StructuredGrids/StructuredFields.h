// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The fields of image data, rectilinear and structured grids.
#ifndef nephoscope_StructuredFields_h
#define nephoscope_StructuredFields_h

#include "VelocityFields.h"

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{
// The number of points along each axis of a structured dataset; false if it is of another kind.
bool StructuredSize(vtkDataSet* data, int dimensions[3]);

// The field of a structured dataset with at least two points along each axis and a point array of
// three components.
std::unique_ptr<DataSetField> MakeStructuredField(vtkDataSet* data, vtkDataArray* velocity);
}

#endif
