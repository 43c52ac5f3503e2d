// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LitData.h"

#include "EvenRays.h"
#include "GridRays.h"
#include "OwnThreads.h"
#include "SunMesh.h"
#include "TetrahedronSource.h"
#include "Vector3.h"

#include "vtkBoundingBox.h"
#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProbeFilter.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nephoscope
{
namespace
{
Vector Difference(const Place& a, const Place& b)
{
  return { float(a[0] - b[0]), float(a[1] - b[1]), float(a[2] - b[2]) };
}

float LengthOf(const Vector& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

class GridMaker
{
public:
  GridMaker(std::vector<Place> places, LightGrid& grid, GridAxes& axes)
    : Places(std::move(places))
    , Grid(grid)
    , Axes(axes)
    , Stride{ 1, grid.Size[0], std::ptrdiff_t(grid.Columns()) }
  {
  }

  void Make()
  {
    this->Grid.Step.resize(this->Places.size());
    this->Axes.Axes.resize(this->Places.size());
    this->ForLevels([this](const std::array<int, 3>& at) { this->MakePoint(at); });
    this->ForLevels([this](const std::array<int, 3>& at) { this->WidenPole(at); });
    this->Grid.Closed[0] = this->IsClosed();
  }

private:
  template <typename Body>
  void ForLevels(Body body)
  {
    InParallel(this->Grid.Size[2], [this, &body](vtkIdType begin, vtkIdType end) {
      for (int k = int(begin); k < end; ++k)
      {
        for (int j = 0; j < this->Grid.Size[1]; ++j)
        {
          for (int i = 0; i < this->Grid.Size[0]; ++i)
          {
            body({ i, j, k });
          }
        }
      }
    });
  }

  std::size_t NumberOf(const std::array<int, 3>& at) const
  {
    return at[0] + at[1] * this->Stride[1] + at[2] * this->Stride[2];
  }

  void MakePoint(const std::array<int, 3>& at)
  {
    const std::size_t p = this->NumberOf(at);
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isFirst = at[axis] == 0, isLast = at[axis] == this->Grid.Size[axis] - 1;
      const std::size_t before = p - (isFirst ? 0 : this->Stride[axis]),
                        after = p + (isLast ? 0 : this->Stride[axis]);
      this->Grid.Step[p][axis] = isLast
        ? LengthOf(Difference(this->Places[p], this->Places[before]))
        : LengthOf(Difference(this->Places[after], this->Places[p]));
      Vector d = Difference(this->Places[after], this->Places[before]);
      const float length = LengthOf(d);
      for (float& x : d)
      {
        x = length > 0 ? x / length : 0.0f;
      }
      this->Axes.Axes[p][axis] = d;
    }
  }

  // The points of a pole are in one place; each is that of a wedge, whose mean width is a quarter
  // of that of the next row.
  void WidenPole(const std::array<int, 3>& at)
  {
    const std::size_t p = this->NumberOf(at);
    const int n = this->Grid.Size[1];
    if (at[1] == 0 || at[1] == n - 1)
    {
      const std::size_t q = at[1] == 0 ? p + this->Stride[1] : p - this->Stride[1];
      float& step = this->Grid.Step[p][0];
      step = std::max(step, 0.25f * this->Grid.Step[q][0]);
    }
  }

  bool IsClosed() const
  {
    const int n = this->Grid.Size[0];
    bool closed = n > 2;
    for (std::size_t row = 0; row < this->Places.size() && closed; row += n)
    {
      const float gap = LengthOf(Difference(this->Places[row], this->Places[row + n - 1]));
      closed =
        gap <= 1e-3f * this->Grid.Step[row][0] + 1e-6f * std::abs(float(this->Places[row][0]));
    }
    return closed;
  }

  const std::vector<Place> Places; // in the order of the grid
  LightGrid& Grid;
  GridAxes& Axes;
  const std::ptrdiff_t Stride[3];
};
}

std::vector<float> ValuesOf(
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

std::vector<Place> PlacesOf(vtkDataSet* data)
{
  std::vector<Place> places(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  return places;
}

bool HasCellsInSpace(vtkDataSet* data)
{
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    cell->SetCellType(data->GetCellType(i));
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

namespace
{
// What ghost flags hide is not there. Cells that other ranks draw, and refined ones, are.
class HiddenCells
{
public:
  explicit HiddenCells(vtkDataSet* data)
    : Cells(data->GetCellGhostArray())
    , Points(data->GetPointGhostArray())
  {
  }

  /** One for each cell; empty: none are hidden. */
  std::vector<bool> Flags(vtkDataSet* data) const
  {
    std::vector<bool> flags;
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0, n = this->HasAny() ? data->GetNumberOfCells() : 0; cell < n; ++cell)
    {
      data->GetCellPoints(cell, points);
      flags.push_back(this->Has(cell, points));
    }
    return flags;
  }

  bool HasAny() const
  {
    return has(this->Cells, vtkDataSetAttributes::HIDDENCELL) ||
      has(this->Points, vtkDataSetAttributes::HIDDENPOINT);
  }

  bool Has(vtkIdType cell, vtkIdList* points) const
  {
    const auto isHidden = [this](vtkIdType p) {
      return (this->Points->GetValue(p) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    };
    return (this->Cells && (this->Cells->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0) ||
      (this->Points && std::any_of(points->begin(), points->end(), isHidden));
  }

private:
  static bool has(vtkUnsignedCharArray* ghosts, unsigned char flag)
  {
    const vtkIdType count = ghosts ? ghosts->GetNumberOfValues() : 0;
    const unsigned char* values = ghosts ? ghosts->GetPointer(0) : nullptr;
    return std::any_of(
      values, values + count, [flag](unsigned char one) { return (one & flag) != 0; });
  }

  vtkUnsignedCharArray* Cells;
  vtkUnsignedCharArray* Points;
};

std::unique_ptr<SunMesh> SunMeshOf(
  vtkDataSet* data, const HiddenCells& hidden, const std::vector<std::int32_t>& merged)
{
  std::vector<SunMesh::Tetrahedron> tetrahedra;
  tetrahedra.reserve(5 * data->GetNumberOfCells());
  TetrahedronSource source(data);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    source.IsHidden(cell); // reads its points
    if (!hidden.Has(cell, source.GetPoints()))
    {
      source.EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& t) {
        tetrahedra.push_back({ { merged[t[0]], merged[t[1]], merged[t[2]], merged[t[3]] } });
      });
    }
  }
  return std::make_unique<SunMesh>(std::move(tetrahedra), merged);
}
}

std::unique_ptr<SunPaths> SunPathsOf(vtkDataSet* data, const std::vector<Place>& places,
  const std::vector<Fields>& fields, const Place& sun, bool repeats)
{
  const Loop loop = [](std::int64_t count, const auto& body) {
    InParallel(count, [&body](vtkIdType begin, vtkIdType end) { body(begin, end); });
  };
  const HiddenCells hidden(data);
  const bool mayCoincide = !repeats && !vtkImageData::SafeDownCast(data);
  std::vector<std::int32_t> merged =
    mayCoincide ? MergedPoints(places) : std::vector<std::int32_t>();
  std::vector<SunPoint> points = SunPoints(places, fields, merged, sun, loop);
  const ChessboardGrid grid = FindChessboardGrid(data);
  if (!repeats && !hidden.HasAny() && EvenRays::Fits(grid, points))
  {
    return std::make_unique<EvenRays>(grid, points);
  }
  auto rays =
    std::make_unique<GridRays>(grid, grid.IsEmpty() ? std::vector<bool>() : hidden.Flags(data));
  if (repeats)
  {
    rays->Repeat();
  }
  if (!grid.IsEmpty() && rays->Connect(merged))
  {
    rays->Turn(std::move(points));
    return rays;
  }
  if (!mayCoincide)
  {
    merged.resize(places.size());
    std::iota(merged.begin(), merged.end(), 0);
  }
  std::unique_ptr<SunMesh> mesh = SunMeshOf(data, hidden, merged);
  mesh->Turn(std::move(points));
  return mesh;
}

bool MakeGrid(vtkDataSet* data, const Planet& planet, const std::vector<Place>& places,
  LightGrid& grid, GridAxes& axes)
{
  const ChessboardGrid chessboard = FindChessboardGrid(data);
  if (chessboard.IsEmpty())
  {
    return false;
  }
  axes.Order = UprightOrder(
    { { int(chessboard.Size[0]), int(chessboard.Size[1]), int(chessboard.Size[2]) } },
    [&places](std::size_t p) { return places[p]; },
    [&planet](const Place& place) { return planet.UpAt(place); });
  std::copy(axes.Order.GetSizes().begin(), axes.Order.GetSizes().end(), grid.Size);
  GridMaker(axes.Order.Of(places), grid, axes).Make();
  return true;
}

SampleFrame::SampleFrame(const Planet& planet, const std::vector<Place>& places)
  : Ground(planet)
  , Horizon(planet.Horizon())
{
  std::array<double, 2> sum{ { 0, 0 } };
  for (const Place& p : places)
  {
    const double r = std::hypot(p[0], p[1]);
    sum[0] += r > 0 ? p[0] / r : 0;
    sum[1] += r > 0 ? p[1] / r : 0;
  }
  this->Middle = std::atan2(sum[1], sum[0]);
}

Place SampleFrame::FromPlace(const Place& place) const
{
  if (!this->IsOnGlobe())
  {
    return { { Dot(this->Horizon[0], place), Dot(this->Horizon[1], place),
      Dot(this->Horizon[2], place) } };
  }
  const double r = std::sqrt(Dot(place, place)), pi = vtkMath::Pi();
  const double longitude = std::atan2(place[1], place[0]) - this->Middle;
  return { { longitude - 2 * pi * std::round(longitude / (2 * pi)),
    r > 0 ? std::asin(std::max(-1.0, std::min(1.0, place[2] / r))) : 0, r } };
}

Place SampleFrame::ToPlace(const Place& c) const
{
  if (!this->IsOnGlobe())
  {
    return this->Ground.FromHorizon(c);
  }
  const double longitude = c[0] + this->Middle, across = c[2] * std::cos(c[1]);
  return { { across * std::cos(longitude), across * std::sin(longitude), c[2] * std::sin(c[1]) } };
}

vtkSmartPointer<vtkImageData> SampleFrame::MakeImage(
  const std::vector<Place>& places, double points, bool hasClearSides) const
{
  vtkBoundingBox box;
  for (const Place& p : places)
  {
    box.AddPoint(this->FromPlace(p).data());
  }
  const double nearlyAll = 0.97 * vtkMath::Pi(),
               shortest = this->IsOnGlobe() ? 1e-6 : 1e-6 * box.GetDiagonalLength();
  double least[3], size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    least[axis] = box.GetMinPoint()[axis];
    size[axis] = std::max(box.GetLength(axis),
      this->IsOnGlobe() && axis == 2 ? shortest * box.GetMaxPoint()[2] : shortest);
  }
  const double height = size[2] / (this->IsOnGlobe() ? box.GetMaxPoint()[2] : 1.0);
  for (int axis = 0; axis < 2 && hasClearSides; ++axis)
  {
    const double limit = this->IsOnGlobe() ? vtkMath::Pi() / (axis + 1) : VTK_DOUBLE_MAX,
                 margin = std::min(0.5 * size[axis], height),
                 most = std::min(least[axis] + size[axis] + margin, limit);
    least[axis] = std::max(least[axis] - margin, -limit);
    size[axis] = most - least[axis];
  }
  if (this->IsOnGlobe() && least[0] < -nearlyAll && least[0] + size[0] > nearlyAll)
  {
    least[0] = -vtkMath::Pi();
    size[0] = 2 * vtkMath::Pi();
  }
  // As many levels as a cube would have, or more; around a globe half as many. The rest beside one
  // another.
  const double levels = std::max(std::cbrt(points) * (this->IsOnGlobe() ? 0.5 : 1.0), 2.0);
  const double step = std::sqrt(size[0] * size[1] * levels / points);
  int dimensions[3];
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double wanted = axis == 2 ? levels : std::min(size[axis] / step, points / levels / 2);
    dimensions[axis] = std::max(3, static_cast<int>(wanted) + 1);
    const double inset =
      this->IsOnGlobe() ? 0 : 1e-7 * size[axis]; // rounding puts no point outside of the data
    least[axis] += inset;
    spacing[axis] = (size[axis] - 2 * inset) / (dimensions[axis] - 1);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(dimensions);
  image->SetSpacing(spacing);
  image->SetOrigin(least);
  return image;
}

vtkSmartPointer<vtkDataSet> SampleFrame::Sampled(vtkDataSet* data, vtkImageData* image) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(image->GetNumberOfPoints());
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    Place c;
    image->GetPoint(p, c.data());
    points->SetPoint(p, this->ToPlace(c).data());
  }
  vtkNew<vtkStructuredGrid> grid;
  int dimensions[3];
  image->GetDimensions(dimensions);
  grid->SetDimensions(dimensions);
  grid->SetPoints(points);
  vtkNew<vtkProbeFilter> probe;
  const bool isUpright = !this->IsOnGlobe() && this->Horizon[2][2] == 1;
  probe->SetInputData(isUpright ? static_cast<vtkDataSet*>(image) : grid);
  probe->SetSourceData(data);
  probe->Update();
  return vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
}

bool SampleFrame::FillSides(vtkDataSet* sampled, vtkImageData* image)
{
  const auto* mask = vtkCharArray::SafeDownCast(
    sampled->GetPointData()->GetArray(vtkNew<vtkProbeFilter>()->GetValidPointMaskArrayName()));
  int dimensions[3];
  image->GetDimensions(dimensions);
  vtkIdType all = 0, filled = 0;
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    const vtkIdType i = p % dimensions[0], j = p / dimensions[0] % dimensions[1];
    const bool isSide = i == 0 || j == 0 || i == dimensions[0] - 1 || j == dimensions[1] - 1;
    all += isSide ? 1 : 0;
    filled += isSide && mask && mask->GetValue(p) != 0 ? 1 : 0;
  }
  return 2 * filled >= all;
}

}
