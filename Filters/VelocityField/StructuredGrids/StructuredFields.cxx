// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredFields.h"

#include "CurvilinearCells.h"
#include "RectilinearCells.h"
#include "StructuredField.h"
#include "UniformCells.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

namespace nephoscope
{
namespace
{
// Calls `use(keeper, values)` with the values as they are stored, where they are floats or doubles
// one tuple after the other; else with a copy in doubles.
template <typename Use>
auto WithReals(vtkDataArray* array, const Use& use)
{
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    return use(array, const_cast<const float*>(floats->GetPointer(0)));
  }
  vtkSmartPointer<vtkDataArray> keeper = array;
  auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array);
  if (!doubles)
  {
    auto copy = vtkSmartPointer<vtkDoubleArray>::New();
    copy->DeepCopy(array);
    keeper = copy;
    doubles = copy;
  }
  return use(keeper, const_cast<const double*>(doubles->GetPointer(0)));
}

template <typename Cells>
std::unique_ptr<DataSetField> MakeField(vtkDataSet* data, Cells cells, vtkDataArray* velocity)
{
  return WithReals(
    velocity, [&](vtkDataArray* keeper, const auto* values) -> std::unique_ptr<DataSetField> {
      using Value = std::remove_const_t<std::remove_pointer_t<decltype(values)>>;
      return std::make_unique<StructuredField<Cells, Value>>(
        data, std::move(cells), keeper, values);
    });
}

GridSize SizeOf(vtkDataSet* data)
{
  GridSize size;
  StructuredSize(data, size.Points.data());
  return size;
}

UniformCells CellsOf(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  const int first[3] = { extent[0], extent[2], extent[4] };
  Vector3 origin;
  image->TransformIndexToPhysicalPoint(first, origin.data());
  const vtkMatrix4x4* matrix = image->GetPhysicalToIndexMatrix();
  std::array<Vector3, 3> toIndex;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      toIndex[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
        matrix->GetElement(row, column);
    }
  }
  return { SizeOf(image), origin, toIndex };
}

RectilinearAxis AxisOf(vtkDataArray* coordinates)
{
  std::vector<double> values(static_cast<std::size_t>(coordinates->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = coordinates->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return RectilinearAxis(std::move(values));
}
}

bool StructuredSize(vtkDataSet* data, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(dimensions);
    return true;
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(dimensions);
    return true;
  }
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(data))
  {
    curvilinear->GetDimensions(dimensions);
    return true;
  }
  return false;
}

std::unique_ptr<DataSetField> MakeStructuredField(vtkDataSet* data, vtkDataArray* velocity)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    return MakeField(data, CellsOf(image), velocity);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    RectilinearCells cells({ AxisOf(grid->GetXCoordinates()), AxisOf(grid->GetYCoordinates()),
      AxisOf(grid->GetZCoordinates()) });
    return MakeField(data, std::move(cells), velocity);
  }
  vtkDataArray* points = vtkStructuredGrid::SafeDownCast(data)->GetPoints()->GetData();
  return WithReals(
    points, [&](vtkDataArray* keeper, const auto* positions) -> std::unique_ptr<DataSetField> {
      using Coordinate = std::remove_const_t<std::remove_pointer_t<decltype(positions)>>;
      CurvilinearCells<Coordinate> cells(
        SizeOf(data), positions, std::make_shared<vtkSmartPointer<vtkDataArray>>(keeper));
      return MakeField(data, std::move(cells), velocity);
    });
}
}
