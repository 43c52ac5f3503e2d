// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LitData.h"

#include "TetrahedronSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkProbeFilter.h"
#include "vtkSMPTools.h"

#include <cmath>

namespace nephoscope
{
namespace
{
double fieldValue(vtkDataSet* data, const char* name, double otherwise)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : otherwise;
}

Vector difference(const SunMesh::Place& a, const SunMesh::Place& b)
{
  return { float(a[0] - b[0]), float(a[1] - b[1]), float(a[2] - b[2]) };
}

float lengthOf(const Vector& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

class GridMaker
{
public:
  GridMaker(const std::vector<SunMesh::Place>& places, LightGrid& grid, GridAxes& axes)
    : Places(places)
    , Grid(grid)
    , Axes(axes)
    , Stride{ 1, grid.Size[0], std::ptrdiff_t(grid.Columns()) }
  {
  }

  void Make()
  {
    this->Grid.Spacing.resize(this->Places.size());
    this->Axes.Axes.resize(this->Places.size());
    vtkSMPTools::For(0, this->Grid.Size[2], [this](vtkIdType begin, vtkIdType end) {
      for (int k = int(begin); k < end; ++k)
      {
        for (int j = 0; j < this->Grid.Size[1]; ++j)
        {
          for (int i = 0; i < this->Grid.Size[0]; ++i)
          {
            this->MakePoint({ i, j, k });
          }
        }
      }
    });
    this->Grid.Periodic = this->IsClosed();
  }

private:
  void MakePoint(const std::array<int, 3>& at)
  {
    const std::size_t p = at[0] + at[1] * this->Stride[1] + at[2] * this->Stride[2];
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isFirst = at[axis] == 0, isLast = at[axis] == this->Grid.Size[axis] - 1;
      const std::size_t from = p - (isFirst ? 0 : this->Stride[axis]),
                        to = p + (isLast ? 0 : this->Stride[axis]);
      Vector d = difference(this->Places[to], this->Places[from]);
      const float length = lengthOf(d);
      this->Grid.Spacing[p][axis] = length / std::max(int(!isFirst) + int(!isLast), 1);
      for (float& x : d)
      {
        x = length > 0 ? x / length : 0.0f;
      }
      this->Axes.Axes[p][axis] = d;
    }
  }

  bool IsClosed() const
  {
    const int n = this->Grid.Size[0];
    bool closed = n > 2;
    for (std::size_t row = 0; row < this->Places.size() && closed; row += n)
    {
      const float gap = lengthOf(difference(this->Places[row], this->Places[row + n - 1]));
      closed =
        gap <= 1e-3f * this->Grid.Spacing[row][0] + 1e-6f * std::abs(float(this->Places[row][0]));
    }
    return closed;
  }

  const std::vector<SunMesh::Place>& Places;
  LightGrid& Grid;
  GridAxes& Axes;
  const std::ptrdiff_t Stride[3];
};
}

Planet planetOf(vtkDataSet* data)
{
  const bool isGlobe = fieldValue(data, "GlobeGridProjection", 1) == 0;
  return { isGlobe ? fieldValue(data, "PlanetRadius", 0) : 0.0 };
}

std::vector<float> valuesOf(
  vtkDataSet* data, const std::string& name, double otherwise, double scale, vtkIdType& wrong)
{
  std::vector<float> values(
    static_cast<std::size_t>(data->GetNumberOfPoints()), static_cast<float>(otherwise));
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  for (std::size_t i = 0; array && i < values.size(); ++i)
  {
    const double value = scale * array->GetComponent(static_cast<vtkIdType>(i), 0);
    const bool valid = std::isfinite(value) && value >= 0 && value < 1e20;
    values[i] = valid ? static_cast<float>(value) : 0.0f;
    wrong += valid ? 0 : 1;
  }
  return values;
}

std::vector<SunMesh::Place> placesOf(vtkDataSet* data)
{
  std::vector<SunMesh::Place> places(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  return places;
}

std::vector<SunMesh::Tetrahedron> tetrahedraOf(
  vtkDataSet* data, const std::vector<std::int32_t>& merged)
{
  std::vector<SunMesh::Tetrahedron> tetrahedra;
  TetrahedronSource source(data);
  tetrahedra.reserve(5 * data->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    source.IsHidden(cell); // reads its points: what is hidden lets light through
    source.EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& t) {
      tetrahedra.push_back({ { merged[t[0]], merged[t[1]], merged[t[2]], merged[t[3]] } });
    });
  }
  return tetrahedra;
}

bool makeGrid(
  vtkDataSet* data, const std::vector<SunMesh::Place>& places, LightGrid& grid, GridAxes& axes)
{
  const ChessboardGrid chessboard = findChessboardGrid(data);
  if (chessboard.IsEmpty())
  {
    return false;
  }
  std::copy(chessboard.Size, chessboard.Size + 3, grid.Size);
  GridMaker(places, grid, axes).Make();
  return true;
}

vtkSmartPointer<vtkDataSet> sampled(vtkDataSet* data, vtkIdType points)
{
  double bounds[6];
  data->GetBounds(bounds);
  double volume = 1;
  double size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = std::max(bounds[2 * axis + 1] - bounds[2 * axis], 1e-6 * data->GetLength());
    volume *= size[axis];
  }
  const double step = std::cbrt(volume / points);
  vtkNew<vtkImageData> image;
  int dimensions[3];
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = std::max(8, static_cast<int>(size[axis] / step) + 1);
    spacing[axis] = size[axis] / (dimensions[axis] - 1);
  }
  image->SetDimensions(dimensions);
  image->SetSpacing(spacing);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(image);
  probe->SetSourceData(data);
  probe->Update();
  vtkSmartPointer<vtkDataSet> result;
  result = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  return result;
}
}
