// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Cell arrays as point arrays.
#ifndef nephoscope_CellAverages_h
#define nephoscope_CellAverages_h

#include "vtkSmartPointer.h"

class vtkDataSet;

namespace nephoscope
{
// The dataset with its cell arrays as point arrays too: a point has the mean of the cells around
// it, as vtkCellDataToPointData makes it, but hidden cells do not count. Cell arrays take the place
// of point arrays of the same name. A linear field stays linear inside a uniform grid, not on its
// boundary.
vtkSmartPointer<vtkDataSet> WithCellArraysOnPoints(vtkDataSet* data);
}

#endif
