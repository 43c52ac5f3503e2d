// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A density of cells, averaged over the cells at each point; kept until the cells or the density
// change.
#ifndef nephoscope_PointDensity_h
#define nephoscope_PointDensity_h

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace nephoscope
{
class PointDensity
{
public:
  // One value for each point of the grid, 0 at points without cells. Densities that are no finite
  // numbers do not count.
  const std::vector<double>& Of(vtkUnstructuredGrid* grid, vtkDataArray* density);

private:
  void Average(vtkUnstructuredGrid* grid, vtkDataArray* density);

  // Modification times are never used twice in a process: they tell that nothing has changed, also
  // not to other objects.
  vtkMTimeType CellsTime = 0;
  vtkMTimeType DensityTime = 0;
  std::vector<double> Values;
};
}

#endif
