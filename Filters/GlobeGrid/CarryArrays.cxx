// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CarryArrays.h"

#include "LonLatLevelGrid.h"
#include "OwnThreads.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nephoscope
{
namespace
{
constexpr double fillValue = 1e30;

// Values of 1e30 and more, netCDF's own 9.97e36 among them, stand for missing ones: NaN.
void EraseFillValues(vtkDataArray* array)
{
  if (!array || (array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE))
  {
    return;
  }
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    double range[2];
    array->GetFiniteRange(range, c);
    for (vtkIdType id = 0;
         (range[0] <= -fillValue || range[1] >= fillValue) && id < array->GetNumberOfTuples(); ++id)
    {
      if (std::abs(array->GetComponent(id, c)) >= fillValue)
      {
        array->SetComponent(id, c, std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
}

// sources[i]: the input tuple of output tuple i.
void CarryArrays(
  vtkDataSetAttributes* input, const std::vector<vtkIdType>& sources, vtkDataSetAttributes* output)
{
  const auto count = static_cast<vtkIdType>(sources.size());
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* from = input->GetAbstractArray(a);
    auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->CopyComponentNames(from);
    to->SetNumberOfTuples(count);
    auto copy = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        to->SetTuple(i, sources[i], from);
      }
    };
    if (vtkDataArray::SafeDownCast(from) && !vtkBitArray::SafeDownCast(from))
    {
      InParallel(count, copy);
    }
    else
    {
      copy(
        0, count); // neighbouring bits share a byte; variant and string arrays are not for threads
    }
    EraseFillValues(vtkDataArray::SafeDownCast(to));
    output->AddArray(to);
    // Ids are no longer unique once the seam is closed, so they stay plain arrays.
    const int attribute = input->IsArrayAnAttribute(a);
    if (attribute >= 0 && attribute != vtkDataSetAttributes::GLOBALIDS &&
      attribute != vtkDataSetAttributes::PEDIGREEIDS)
    {
      output->SetActiveAttribute(from->GetName(), attribute);
    }
  }
}
}

void CarryPointArrays(const LonLatLevelGrid& grid, const GridOrder& order, const int extent[6],
  vtkDataSetAttributes* output)
{
  std::vector<vtkIdType> sources;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        sources.push_back(grid.Id(order.InputPoint(i, j, k)));
      }
    }
  }
  CarryArrays(grid.PointAttributes(), sources, output);
}

void CarryCellArrays(const LonLatLevelGrid& grid, const GridOrder& order, const int extent[6],
  vtkDataSetAttributes* output)
{
  if (!grid.CellAttributes() || grid.CellAttributes()->GetNumberOfArrays() == 0)
  {
    return;
  }
  const std::array<int, 3>& size = grid.Dimensions();
  const vtkIdType columns = std::max(size[0] - 1, 1);
  const vtkIdType rows = std::max(size[1] - 1, 1);
  int last[3]; // a flat axis has one layer of cells
  for (int axis = 0; axis < 3; ++axis)
  {
    last[axis] = std::max(extent[2 * axis + 1] - 1, extent[2 * axis]);
  }
  std::vector<vtkIdType> sources;
  for (int k = extent[4]; k <= last[2]; ++k)
  {
    for (int j = extent[2]; j <= last[1]; ++j)
    {
      for (int i = extent[0]; i <= last[0]; ++i)
      {
        const std::array<int, 3> cell = order.InputCell(i, j, k);
        sources.push_back(cell[0] + columns * (cell[1] + rows * cell[2]));
      }
    }
  }
  CarryArrays(grid.CellAttributes(), sources, output);
}
}
