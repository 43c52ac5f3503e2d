// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlankedCells.h"

#include "HiddenCells.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"

#include <cmath>

namespace nephoscope
{
namespace
{
double SizeOf(vtkDataSet* data, vtkIdType cell)
{
  double bounds[6], lengths[3];
  data->GetCellBounds(cell, bounds);
  vtkBoundingBox(bounds).GetLengths(lengths);
  return std::cbrt(lengths[0] * lengths[1] * lengths[2]);
}
}

double SmallestSize(const std::vector<double>& sizes)
{
  double smallest = 0.0;
  for (const double size : sizes)
  {
    smallest = size > 0.0 && (smallest == 0.0 || size < smallest) ? size : smallest;
  }
  return smallest;
}

double SmallestBlankedCell(const std::vector<vtkDataSet*>& sets)
{
  std::vector<double> sizes;
  for (vtkDataSet* data : sets)
  {
    const HiddenCells blanked(data, vtkDataSetAttributes::HIDDENCELL);
    for (vtkIdType cell = 0; blanked.Any() && cell < data->GetNumberOfCells(); ++cell)
    {
      if (blanked[cell])
      {
        sizes.push_back(SizeOf(data, cell));
      }
    }
  }
  return SmallestSize(sizes);
}
}
