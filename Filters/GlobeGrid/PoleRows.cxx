// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PoleRows.h"

#include "LonLatLevelGrid.h"
#include "MissingValue.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

namespace nephoscope
{
namespace
{
// Writes the value of the ring below the added row (j, k) to all points of that row, which begin at
// `firstId`.
void FillRow(vtkDataArray* from, vtkDataArray* to, const LonLatLevelGrid& grid,
  const GridOrder& order, int j, int k, vtkIdType firstId, int count)
{
  const bool floating = to->GetDataType() == VTK_FLOAT || to->GetDataType() == VTK_DOUBLE;
  const int columns = DistinctColumns(order);
  std::vector<double> values;
  for (int c = 0; c < to->GetNumberOfComponents(); ++c)
  {
    values.clear();
    for (int i = 0; i < columns; ++i)
    {
      const double value = from->GetComponent(grid.Id(order.InputPoint(i, j, k)), c);
      if (!IsMissing(value))
      {
        values.push_back(value);
      }
    }
    if (values.empty())
    {
      continue; // the missing values of the ring are there already
    }
    const double mean = RingValue(values, floating);
    for (int i = 0; i < count; ++i)
    {
      to->SetComponent(firstId + i, c, mean);
    }
  }
}
}

std::array<bool, 2> MissingPoles(const LonLatLevelGrid& grid)
{
  const int rows = grid.Dimensions()[1];
  std::array<bool, 2> missing = { false, false };
  for (const bool last : { false, true })
  {
    double outer = 0.0;
    double next = 0.0;
    if (rows > 1 && grid.RowLatitude(last ? rows - 1 : 0, outer) &&
      grid.RowLatitude(last ? rows - 2 : 1, next) && IsLastRing(outer, next))
    {
      missing[outer > 0.0 ? 1 : 0] = true;
    }
  }
  return missing;
}

void FillPoleRows(const LonLatLevelGrid& grid, const GridOrder& order, const int extent[6],
  vtkDataSetAttributes* output)
{
  const int columns = extent[1] - extent[0] + 1;
  const vtkIdType rows = extent[3] - extent[2] + 1;
  for (int a = 0; a < grid.PointAttributes()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* from = grid.PointAttributes()->GetArray(a);
    vtkDataArray* to = from && from->GetName() ? output->GetArray(from->GetName()) : nullptr;
    for (int k = extent[4]; to && k <= extent[5]; ++k)
    {
      for (const int j : { 0, order.OutputDimensions[1] - 1 })
      {
        if (order.AddedPole(j) != 0 && j >= extent[2] && j <= extent[3])
        {
          FillRow(from, to, grid, order, j, k, columns * (j - extent[2] + rows * (k - extent[4])),
            columns);
        }
      }
    }
  }
}
}
