// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatShapes.h"

#include "CellCenter.h"
#include "EllipsoidSplat.h"
#include "HiddenSamples.h"
#include "NeighborSpacing.h"
#include "PointPlaces.h"
#include "RobustBounds.h"
#include "SplatSamples.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
// Parts of the longest edge: cells at the poles, and the like, keep a thickness; cells of weather
// models may be as thin as the second.
constexpr double flatShare = 0.02, thinnest = 1e-4;

constexpr int jacobianSize = 9;

vtkDataArray* SizeArrayOf(vtkDataSet* data, const SplatSampling& sampling)
{
  vtkDataArray* array = sampling.SizeArrayName.empty()
    ? nullptr
    : AttributesOf(data, sampling.OnCells)->GetArray(sampling.SizeArrayName.c_str());
  const vtkIdType count = sampling.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  const bool fits =
    array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == count;
  return fits ? array : nullptr;
}

using Bounds = std::array<double, 6>;

void AddSplat(Bounds& bounds, const Vector3& place, const SplatMatrix& jacobian, double radius)
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

vtkFieldData* AttributesOf(vtkDataSet* data, bool onCells)
{
  return onCells ? static_cast<vtkFieldData*>(data->GetCellData()) : data->GetPointData();
}

SplatShapes::SplatShapes(vtkDataSet* data, const SplatSampling& sampling)
  : Data(data)
  , OnCells(sampling.OnCells)
  , Grid(data, sampling.OnCells)
  , SizesAreVolumes(sampling.SizesAreVolumes)
  , Hidden(FindHiddenSamples(data, sampling.OnCells, sampling.Frame.WithNeighbors))
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
    this->ShapeArray = AttributesOf(data, this->OnCells)->GetArray(sampling.ShapeArrayName.c_str());
    const int components = this->ShapeArray ? this->ShapeArray->GetNumberOfComponents() : 0;
    const bool fits = (components == jacobianSize || components == jacobianSize + 1) &&
      this->ShapeArray->GetNumberOfTuples() == this->Count;
    this->ShapeArray = fits ? this->ShapeArray : nullptr;
    auto* floats = vtkFloatArray::FastDownCast(this->ShapeArray);
    this->ShapeNumbers = floats ? floats->GetPointer(0) : nullptr;
  }
  if (this->Grid.IsGrid() && !this->OnCells && !this->ShapeArray)
  {
    this->Grid.SetHiddenCells(FindHiddenCells(data));
  }
  if (this->ShapeArray || this->Grid.IsGrid())
  {
    return;
  }
  this->SizeArray = SizeArrayOf(data, sampling);
  if (this->SizeArray || (!(this->CellSize > 0) && this->FindVoxels()))
  {
    return;
  }
  if (sampling.FromCells && !(this->CellSize > 0))
  {
    this->Cells.Find(sampling.Mesh ? sampling.Mesh : data, this->OnCells);
  }
  this->Spaced = !(this->CellSize > 0) && this->Cells.IsEmpty();
  if (!this->OnCells && this->Cells.IsEmpty() && vtkPolyData::SafeDownCast(data))
  {
    this->FindRepeated();
  }
  if (this->Spaced && sampling.FromNeighbors && !this->OnCells)
  {
    this->Spacing = FindNeighborSpacing(data);
  }
  if (!this->Cells.IsComplete()) // else it is not used
  {
    this->Voxel = BallOfEdge(this->CellSize > 0 ? this->CellSize : this->FindMeanSpacing());
  }
}

std::string SplatShapes::Check(vtkDataSet* data, const SplatSampling& sampling)
{
  const bool asked =
    !sampling.SizeArrayName.empty() && !GridSamples(data, sampling.OnCells).IsGrid();
  if (!asked || SizeArrayOf(data, sampling))
  {
    return std::string();
  }
  const std::string kind = sampling.OnCells ? "cell" : "point";
  return "No " + kind + " array of one component named '" + sampling.SizeArrayName +
    "' for the size of splats: give its name with SetCellSizeArrayName, or an empty one for sizes from the data.";
}

double SplatShapes::SizeOf(vtkIdType id) const
{
  const double size = this->SizeArray->GetComponent(id, 0);
  return this->SizesAreVolumes ? std::cbrt(size) : size;
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
  return this->IsSized(id) && this->IsShown(id);
}

bool SplatShapes::IsSized(vtkIdType id) const
{
  return !this->SizeArray || (this->SizeOf(id) > 0 && std::isfinite(this->SizeOf(id)));
}

// Neither hidden nor repeated, nor of a cell that is nothing.
bool SplatShapes::IsShown(vtkIdType id) const
{
  const bool repeated = this->Grid.IsRepeated(id) || this->Cells.IsRepeated(id) ||
    (!this->Repeated.empty() && this->Repeated[static_cast<std::size_t>(id)]);
  const bool nothing =
    this->Cells.IsNothing(id) || (this->ShapeArray && this->ShareInShown(id) == 0.0);
  return !repeated && !nothing &&
    (this->Hidden.empty() || !this->Hidden[static_cast<std::size_t>(id)]);
}

Vector3 PlaceOf(vtkDataSet* data, const GridSamples& grid, bool onCells, vtkIdType id)
{
  if (grid.IsGrid())
  {
    return grid.Position(id);
  }
  if (onCells)
  {
    return CenterOfCell(data, id);
  }
  Vector3 place;
  data->GetPoint(id, place.data());
  return place;
}

double SplatShapes::NumberOfShape(vtkIdType id, int number) const
{
  return this->ShapeNumbers
    ? this->ShapeNumbers[id * this->ShapeArray->GetNumberOfComponents() + number]
    : this->ShapeArray->GetComponent(id, number);
}

// Without an array of shapes, and not lengthened.
SplatMatrix SplatShapes::OwnJacobian(vtkIdType id) const
{
  if (this->Grid.IsGrid())
  {
    return this->Grid.Jacobian(id);
  }
  if (this->SizeArray)
  {
    return BallOfEdge(this->SizeOf(id));
  }
  if (!this->Spacing.empty())
  {
    return BallOfEdge(this->Spacing[static_cast<std::size_t>(id)]);
  }
  SplatMatrix jacobian;
  return this->Cells.Get(id, jacobian) ? jacobian : this->Voxel;
}

SplatMatrix SplatShapes::Jacobian(vtkIdType id) const
{
  SplatMatrix jacobian = this->OwnJacobian(id);
  double scale = this->RadiusFactor;
  if (this->ShapeArray)
  {
    for (int i = 0; i < jacobianSize; ++i)
    {
      jacobian[static_cast<std::size_t>(i) / 3][static_cast<std::size_t>(i) % 3] =
        this->NumberOfShape(id, i);
    }
  }
  else if (this->Scale)
  {
    scale *= this->Scale->GetComponent(id, 0);
  }
  for (Vector3& column : jacobian)
  {
    for (double& component : column)
    {
      component *= scale;
    }
  }
  return WithoutFlatColumns(jacobian, flatShare, thinnest);
}

double SplatShapes::Share(vtkIdType id) const
{
  const bool ofGrid = !this->ShapeArray && this->Grid.IsGrid();
  return (ofGrid ? this->Grid.ShareInGrid(id) : 1.0) * this->ShareInShown(id);
}

double SplatShapes::ShareInShown(vtkIdType id) const
{
  if (this->ShapeArray)
  {
    return this->ShapeArray->GetNumberOfComponents() > jacobianSize
      ? this->NumberOfShape(id, jacobianSize)
      : 1.0;
  }
  return this->Grid.IsGrid() ? this->Grid.ShareInShown(id) * this->Grid.ShareInShape(id)
                             : this->Cells.Share(id);
}

// Filters that cut cells may leave several points in one place, and not the same number of them in
// a piece and in the whole.
void SplatShapes::FindRepeated()
{
  const std::vector<vtkIdType> places = FindPlaces(this->Data);
  std::vector<unsigned char> taken(places.size(), 0);
  this->Repeated.assign(places.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto place = static_cast<std::size_t>(places[i]);
    const bool shown = this->Hidden.empty() || !this->Hidden[i];
    this->Repeated[i] = taken[place];
    taken[place] |= static_cast<unsigned char>(shown);
  }
}

// Parts that are few and far away do not count: else all splats would grow with their distance.
double SplatShapes::FindMeanSpacing() const
{
  const MediumBounds bounds =
    RobustBoundsOfPlaces(this->Data->GetNumberOfPoints(), [&](vtkIdType point, double* x) {
      this->Data->GetPoint(point, x);
      return std::isfinite(x[0] + x[1] + x[2]);
    });
  std::size_t count = 0;
  for (vtkIdType id = 0; id < this->Count; ++id)
  {
    count += this->IsVisible(id) && HoldsPlace(bounds, this->Place(id).data()) ? 1 : 0;
  }
  return MeanSpacing(bounds.data(), std::max<std::size_t>(count, 1));
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
      const Vector3 place = shapes.Place(id);
      if (shapes.IsVisible(id) && IsFinite(place))
      {
        jacobian = shapes.HaveOneShape() ? jacobian : shapes.Jacobian(id);
        AddSplat(part, place, jacobian, kernelRadius);
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
