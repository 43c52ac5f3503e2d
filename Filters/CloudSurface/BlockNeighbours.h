// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The grids of a group that abut. Each is extended by layers of ghost cells from its neighbours, so
// that smoothed fields and gradients agree on common faces, and surfaces have no crack there.
#ifndef nephoscope_BlockNeighbours_h
#define nephoscope_BlockNeighbours_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

class vtkDataArray;
class vtkDataObject;

namespace nephoscope
{
class BlockNeighbours
{
public:
  // Replaces the previous result. Grids of an AMR overlap instead of abutting, so nothing is found.
  void Find(vtkDataObject* group, int layers);

  // The grid with its ghost cells; the grid itself where it has no neighbour.
  vtkDataSet* Extended(vtkDataSet* grid) const;

private:
  void FindAmong(const std::vector<vtkDataSet*>& grids, int layers);

  std::map<vtkDataSet*, vtkSmartPointer<vtkDataSet>> Found;
};

// The values at the points of `grid`, from an array on `extended`, which is the grid with its ghost
// cells.
vtkSmartPointer<vtkDataArray> WithoutGhosts(
  vtkDataSet* grid, vtkDataSet* extended, vtkDataArray* array);
}

#endif
