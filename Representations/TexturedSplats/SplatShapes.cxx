// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatShapes.h"

#include "EllipsoidSplat.h"
#include "SplatSamples.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double flatShare =
  0.02; // of the longest edge: cells at the poles, and grids one sample thick, keep a thickness

bool isFinite(const SplatVector& place)
{
  return std::isfinite(place[0] + place[1] + place[2]);
}

vtkFieldData* attributesOf(vtkDataSet* data, bool onCells)
{
  return onCells ? static_cast<vtkFieldData*>(data->GetCellData()) : data->GetPointData();
}

SplatVector centerOfCell(vtkDataSet* data, vtkIdType id)
{
  double bounds[6];
  data->GetCellBounds(id, bounds);
  return { { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) } };
}

using Bounds = std::array<double, 6>;

void addSplat(Bounds& bounds, const SplatVector& place, const SplatMatrix& jacobian, double radius)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The image of a ball under J reaches as far along an axis as that row of J is long.
    const double row = std::sqrt(jacobian[0][axis] * jacobian[0][axis] +
      jacobian[1][axis] * jacobian[1][axis] + jacobian[2][axis] * jacobian[2][axis]);
    bounds[2 * axis] = std::min(bounds[2 * axis], place[axis] - radius * row);
    bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], place[axis] + radius * row);
  }
}
}

SplatShapes::SplatShapes(vtkDataSet* data, const SplatSampling& sampling)
  : Data(data)
  , OnCells(sampling.OnCells)
  , WithDuplicates(sampling.Frame.WithNeighbors)
  , Grid(data, sampling.OnCells)
  , Ghosts(sampling.OnCells ? data->GetCellGhostArray() : data->GetPointGhostArray())
  , Count(sampling.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints())
  , CellSize(sampling.CellSize)
  , RadiusFactor(sampling.RadiusFactor)
{
  if (this->OnCells && this->Count > 0)
  {
    double bounds[6];
    data->GetCellBounds(0, bounds); // so that calls from threads find it prepared
  }
  if (!sampling.ShapeArrayName.empty())
  {
    this->ShapeArray = attributesOf(data, this->OnCells)->GetArray(sampling.ShapeArrayName.c_str());
    const bool fits = this->ShapeArray && this->ShapeArray->GetNumberOfComponents() == 9 &&
      this->ShapeArray->GetNumberOfTuples() == this->Count;
    this->ShapeArray = fits ? this->ShapeArray : nullptr;
  }
  if (this->ShapeArray || this->Grid.IsGrid() || (!(this->CellSize > 0) && this->FindVoxels()))
  {
    return;
  }
  this->Spaced = !(this->CellSize > 0);
  const double edge = this->CellSize > 0 ? this->CellSize : this->FindMeanSpacing();
  this->Voxel = { { { { edge, 0, 0 } }, { { 0, edge, 0 } }, { { 0, 0, edge } } } };
}

// Whether the samples are voxels of a sparse volume; then their shape is found.
bool SplatShapes::FindVoxels()
{
  vtkDataArray* matrix = this->Data->GetFieldData()->GetArray("IndexToWorld");
  if (this->OnCells || !matrix || matrix->GetNumberOfComponents() != 16 ||
    matrix->GetNumberOfTuples() != 1)
  {
    return false;
  }
  for (int column = 0; column < 3; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      this->Voxel[column][row] = matrix->GetComponent(0, 4 * row + column);
    }
  }
  const double volume = std::abs(Determinant(this->Voxel));
  if (!(volume > 0) || !std::isfinite(volume))
  {
    return false;
  }
  for (int row = 0; row < 3; ++row)
  {
    this->FirstVoxel[row] = matrix->GetComponent(0, 4 * row + 3);
  }
  this->Voxels = true;
  vtkDataArray* scale = this->Data->GetPointData()->GetArray("VoxelScale");
  this->Scale = scale && scale->GetNumberOfComponents() == 1 ? scale : nullptr;
  return true;
}

bool SplatShapes::IsVisible(vtkIdType id) const
{
  const int hidden =
    this->OnCells ? int(vtkDataSetAttributes::HIDDENCELL) : int(vtkDataSetAttributes::HIDDENPOINT);
  const int duplicate = this->OnCells ? int(vtkDataSetAttributes::DUPLICATECELL)
                                      : int(vtkDataSetAttributes::DUPLICATEPOINT);
  const int left = this->WithDuplicates ? hidden : hidden | duplicate;
  return !this->Ghosts || !(this->Ghosts->GetValue(id) & left);
}

SplatVector PlaceOf(vtkDataSet* data, const GridSamples& grid, bool onCells, vtkIdType id)
{
  if (grid.IsGrid())
  {
    return grid.Position(id);
  }
  if (onCells)
  {
    return centerOfCell(data, id);
  }
  SplatVector place;
  data->GetPoint(id, place.data());
  return place;
}

SplatMatrix SplatShapes::Jacobian(vtkIdType id) const
{
  SplatMatrix jacobian = this->Grid.IsGrid() ? this->Grid.Jacobian(id) : this->Voxel;
  double scale = this->RadiusFactor;
  if (this->ShapeArray)
  {
    for (int i = 0; i < 9; ++i)
    {
      jacobian[static_cast<std::size_t>(i) / 3][static_cast<std::size_t>(i) % 3] =
        this->ShapeArray->GetComponent(id, i);
    }
  }
  else if (this->Scale)
  {
    scale *= this->Scale->GetComponent(id, 0);
  }
  for (SplatVector& column : jacobian)
  {
    for (double& component : column)
    {
      component *= scale;
    }
  }
  return WithoutFlatColumns(jacobian, flatShare);
}

double SplatShapes::FindMeanSpacing() const
{
  double bounds[6];
  FindPlaceBounds(this->Data, bounds);
  std::size_t count = 0;
  for (vtkIdType id = 0; id < this->Count; ++id)
  {
    count += this->IsVisible(id) && isFinite(this->Place(id)) ? 1 : 0;
  }
  return MeanSpacing(bounds, std::max<std::size_t>(count, 1));
}

void FindSplatBounds(const SplatShapes& shapes, double kernelRadius, double bounds[6])
{
  constexpr double far = VTK_DOUBLE_MAX;
  vtkSMPThreadLocal<Bounds> parts(Bounds{ { far, -far, far, -far, far, -far } });
  vtkSMPTools::For(0, shapes.GetNumberOfIds(), [&](vtkIdType begin, vtkIdType end) {
    Bounds& part = parts.Local();
    SplatMatrix jacobian = shapes.Jacobian(begin);
    for (vtkIdType id = begin; id < end; ++id)
    {
      const SplatVector place = shapes.Place(id);
      if (shapes.IsVisible(id) && isFinite(place))
      {
        jacobian = shapes.HaveOneShape() ? jacobian : shapes.Jacobian(id);
        addSplat(part, place, jacobian, kernelRadius);
      }
    }
  });
  vtkMath::UninitializeBounds(bounds);
  Bounds all{ { far, -far, far, -far, far, -far } };
  for (const Bounds& part : parts)
  {
    for (std::size_t i = 0; i < 6; ++i)
    {
      all[i] = i % 2 ? std::max(all[i], part[i]) : std::min(all[i], part[i]);
    }
  }
  if (all[0] <= all[1])
  {
    std::copy(all.begin(), all.end(), bounds);
  }
}

} // namespace nephoscope
