// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contours any structured grid with vtkFlyingEdges3D, which is for images: in the space of the
// indices, where every structured grid is one, with the positions as one more array to interpolate.
#ifndef nephoscope_IndexSpaceContour_h
#define nephoscope_IndexSpaceContour_h

#include "SmoothingPlan.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;
class vtkPolyData;

namespace nephoscope
{
struct IndexSpaceSurface
{
  vtkSmartPointer<vtkPolyData> Surface; // its points are indices
  vtkDataArray* Positions = nullptr;    // of its points
  vtkDataArray* Values = nullptr;       // the contour value at each point
  // Arrays of the grid that are interpolated: index in its point data, and the result. The others
  // (text, bits, ids) are not here.
  struct Carried
  {
    int Source;
    vtkDataArray* Result;
  };
  std::vector<Carried> Arrays;
};

// `field`: one number for each point; where it is not a number, points on edges to it have no place
// either. `skip`: index of the point array that the field takes the place of. `cells`: first and
// last cell (not point) along each axis, from 0; a ring that closes in space has one more than the
// stored points tell.
IndexSpaceSurface ContourInIndexSpace(vtkDataSet* grid, const SmoothingPlan& plan,
  const std::vector<double>& field, const std::array<int, 6>& cells,
  const std::vector<double>& values, int skip);

// Number of cells along the axis.
int CellsAlong(const SmoothingPlan& plan, int axis);
}

#endif
