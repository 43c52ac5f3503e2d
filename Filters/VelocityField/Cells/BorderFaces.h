// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces between the cells that have a velocity and what lies beyond them.
#ifndef nephoscope_BorderFaces_h
#define nephoscope_BorderFaces_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{
// Corners of a face, one after the other around it; the last is -1 in a triangle.
using FaceCorners = std::array<vtkIdType, 4>;

// The border of the visible cells at whose corners `velocity`, on points, is finite, in an order
// that depends on the dataset alone. Faces inside may be among them. Polygons are fans of
// triangles; curved faces are known by their corners.
std::vector<FaceCorners> BorderFaces(vtkDataSet* data, vtkDataArray* velocity);

// Whether every point and cell has a velocity.
bool HasVelocityEverywhere(vtkDataSet* data, vtkDataArray* velocity);
}

#endif
