// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The generating polygon, when each rank has nothing, the whole or a part of it.
#ifndef nephoscope_PolygonUnion_h
#define nephoscope_PolygonUnion_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace nephoscope
{
// Points and cells without arrays, to be sent; empty for null.
vtkSmartPointer<vtkPolyData> BarePolygons(vtkPolyData* polygon);

// One of those that are equal, as it is; parts that differ are joined: points at the same place
// become one, and so do polygons with the same corners, for ghost cells are copies.
vtkSmartPointer<vtkPolyData> UnitePolygons(
  const std::vector<vtkSmartPointer<vtkDataObject>>& parts);
}

#endif
