// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTetrahedra.h"

#include "HigherOrderCells.h"
#include "LinearCellFaces.h"

#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
// A part smaller than this fraction of the cell means that the apex lies in the plane of a face.
constexpr double leastShare = 1e-6;
// A cell with less than this fraction of the surrounding cube has a volume only through rounding.
constexpr double flatShare = 1e-14;
// Two ways to divide a convex cell have the same volume up to this.
constexpr double roundingShare = 1e-9;
// Sine of the least angle of a triangle that is not flat.
constexpr double flatAngle = 1e-8;

struct Volumes
{
  double Sum = 0;
  double Absolute = 0;
  double Least = 0; // absolute
  bool OneSign = true;
};

Volumes Measure(const std::vector<CellTetrahedra::Tetrahedron>& parts)
{
  Volumes result;
  for (const auto& part : parts)
  {
    const double size = std::abs(part.Volume);
    result.Least = result.Absolute == 0 ? size : std::min(result.Least, size);
    result.Sum += part.Volume;
    result.Absolute += size;
  }
  result.OneSign = std::abs(result.Sum) >= (1 - roundingShare) * result.Absolute;
  return result;
}
}

CellTetrahedra::CellTetrahedra(vtkDataSet* data)
  : Data(data)
  , Grid(vtkUnstructuredGrid::SafeDownCast(data))
  , CellGhosts(data->GetCellGhostArray())
  , PointGhosts(data->GetPointGhostArray())
{
  this->Dimensions.fill(-1);
}

CellTetrahedra::Kind CellTetrahedra::Load(vtkIdType cell)
{
  this->Cell = cell;
  this->CellType = this->Data->GetCellType(cell);
  if (this->CellType == VTK_EMPTY_CELL)
  {
    return Kind::Hidden;
  }
  this->Data->GetCellPoints(cell, this->PointIds);
  if (this->IsHidden())
  {
    return Kind::Hidden;
  }
  return this->DimensionOf(this->CellType) == 3 ? Kind::Solid : Kind::Flat;
}

bool CellTetrahedra::IsHidden() const
{
  constexpr unsigned char hidden =
    vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  if (this->CellGhosts && (this->CellGhosts->GetValue(this->Cell) & hidden))
  {
    return true;
  }
  const vtkIdType* ids = this->PointIds->GetPointer(0);
  return this->PointGhosts &&
    std::any_of(ids, ids + this->PointIds->GetNumberOfIds(), [this](vtkIdType id) {
      return (this->PointGhosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    });
}

int CellTetrahedra::DimensionOf(int cellType)
{
  signed char& dimension = this->Dimensions[static_cast<std::size_t>(cellType & 255)];
  if (dimension < 0)
  {
    this->AnyCell->SetCellType(cellType);
    dimension = static_cast<signed char>(this->AnyCell->GetCellDimension());
  }
  return dimension;
}

void CellTetrahedra::Locate()
{
  this->Places.resize(static_cast<std::size_t>(this->Size()));
  for (int i = 0; i < this->Size(); ++i)
  {
    this->Data->GetPoint(this->Point(i), this->Places[i].data());
  }
}

double CellTetrahedra::ShortestDistance() const
{
  double least = 0;
  for (int i = 0; i < this->Size(); ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      const double distance = std::hypot(this->Places[i][0] - this->Places[j][0],
        this->Places[i][1] - this->Places[j][1], this->Places[i][2] - this->Places[j][2]);
      least = distance > 0 && (least == 0 || distance < least) ? distance : least;
    }
  }
  return least;
}

double CellTetrahedra::Volume(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return TripleProduct(b - a, c - a, d - a);
}

bool CellTetrahedra::Divide()
{
  this->Locate();
  this->Parts.clear();
  this->FaceStream.clear();
  this->CentreVertex = -1;
  if (this->CellType == VTK_TETRA)
  {
    this->Parts.push_back({ { { 0, 1, 2, 3 } },
      Volume(this->Places[0], this->Places[1], this->Places[2], this->Places[3]) });
    return true;
  }
  this->ReadFaces();
  return this->FaceStream.empty() ? this->DivideByVTK() : this->DivideLinear();
}

void CellTetrahedra::ReadFaces()
{
  this->FaceStream.clear();
  const FaceList<int> faces = LinearCellFaces(this->CellType);
  if (faces.Begin)
  {
    this->FaceStream.assign(faces.Begin, faces.End);
  }
  else if (this->CellType == VTK_POLYHEDRON && this->Grid)
  {
    this->ReadPolyhedronFaces();
  }
  if (!this->FaceStream.empty())
  {
    this->RankVertices();
    this->MergeRepeatedVertices();
    this->TurnFaces();
  }
}

void CellTetrahedra::ReadPolyhedronFaces()
{
  // Number of faces, then size, points, size, points, ...
  this->Grid->GetFaceStream(this->Cell, this->Stream);
  const vtkIdType* ids = this->PointIds->GetPointer(0);
  const vtkIdType* end = ids + this->Size();
  const vtkIdType length = this->Stream->GetNumberOfIds();
  for (vtkIdType i = 1; i < length;)
  {
    const vtkIdType size = this->Stream->GetId(i++);
    this->FaceStream.push_back(static_cast<int>(size));
    for (vtkIdType k = 0; k < size; ++k, ++i)
    {
      this->FaceStream.push_back(
        static_cast<int>(std::find(ids, end, this->Stream->GetId(i)) - ids));
    }
  }
}

double CellTetrahedra::Extent() const
{
  double largest = 0;
  for (const Vector3& place : this->Places)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      largest = std::max(largest, std::abs(place[axis] - this->Places[0][axis]));
    }
  }
  return largest;
}

void CellTetrahedra::RankVertices()
{
  const std::size_t size = this->Places.size();
  this->Order.resize(size);
  this->Ranks.resize(size);
  this->Representatives.resize(size);
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::sort(this->Order.begin(), this->Order.end(), [this](int a, int b) {
    return this->Places[a] != this->Places[b] ? this->Places[a] < this->Places[b]
                                              : this->Point(a) < this->Point(b);
  });
  for (std::size_t r = 0; r < size; ++r)
  {
    const int vertex = this->Order[r];
    const bool repeats = r > 0 && this->Places[this->Order[r - 1]] == this->Places[vertex];
    this->Ranks[vertex] = static_cast<int>(r);
    this->Representatives[vertex] = repeats ? this->Representatives[this->Order[r - 1]] : vertex;
  }
}

FaceKey CellTetrahedra::KeyOf(const int* begin, const int* end) const
{
  FaceKey key = { { -1, -1, -1, -1 } };
  if (end - begin >= static_cast<std::ptrdiff_t>(key.size()))
  {
    std::vector<vtkIdType> points;
    std::transform(
      begin, end, std::back_inserter(points), [this](int vertex) { return this->Point(vertex); });
    std::sort(points.begin(), points.end());
    std::copy_n(points.begin(), key.size(), key.begin());
  }
  return key;
}

// Where a row of a grid shrinks to a pole, vertices of a cell coincide. They become one.
void CellTetrahedra::MergeRepeatedVertices()
{
  bool repeats = false;
  for (int i = 0; i < this->Size(); ++i)
  {
    repeats = repeats || this->Representatives[i] != i;
  }
  if (!repeats)
  {
    return;
  }
  std::size_t to = 0;
  for (std::size_t from = 0; from < this->FaceStream.size();)
  {
    const int size = this->FaceStream[from++];
    const std::size_t start = to++;
    for (int k = 0; k < size; ++k, ++from)
    {
      const int vertex = this->Representatives[this->FaceStream[from]];
      const auto begin = this->FaceStream.begin() + static_cast<std::ptrdiff_t>(start) + 1;
      const auto end = this->FaceStream.begin() + static_cast<std::ptrdiff_t>(to);
      if (std::find(begin, end, vertex) == end)
      {
        this->FaceStream[to++] = vertex;
      }
    }
    this->FaceStream[start] = static_cast<int>(to - start) - 1;
  }
  this->FaceStream.resize(to);
}

Vector3 CellTetrahedra::Mean() const
{
  Vector3 sum = { { 0, 0, 0 } };
  for (int vertex : this->Order) // an order that does not depend on numbering
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += this->Places[vertex][axis] / this->Size();
    }
  }
  return sum;
}

// Each face begins with the vertex of its fan.
void CellTetrahedra::TurnFaces()
{
  const auto less = [this](int a, int b) { return this->Ranks[a] < this->Ranks[b]; };
  for (std::size_t i = 0; i < this->FaceStream.size();
       i += static_cast<std::size_t>(this->FaceStream[i]) + 1)
  {
    int* begin = this->FaceStream.data() + i + 1;
    int* end = begin + this->FaceStream[i];
    std::rotate(begin, std::min_element(begin, end, less), end);
    if (this->HasFlatTriangle(begin, end))
    {
      this->TurnToFullFan(begin, end);
    }
  }
}

// Vertices lie on one line. If all fans have a flat triangle, the face keeps that of its least
// vertex, which comes first.
void CellTetrahedra::TurnToFullFan(int* begin, int* end) const
{
  std::vector<int> byRank(begin, end);
  std::sort(
    byRank.begin(), byRank.end(), [this](int a, int b) { return this->Ranks[a] < this->Ranks[b]; });
  for (int vertex : byRank)
  {
    std::rotate(begin, std::find(begin, end, vertex), end);
    if (!this->HasFlatTriangle(begin, end))
    {
      return;
    }
  }
  std::rotate(begin, std::find(begin, end, byRank.front()), end);
}

bool CellTetrahedra::HasFlatTriangle(const int* begin, const int* end) const
{
  bool flat = false;
  EmitFan(begin, end - begin > 3 ? end : begin + 1, [&](int a, int b, int c) {
    const Vector3& x = this->Places[a];
    const Vector3 u = this->Places[b] - x;
    const Vector3 v = this->Places[c] - x;
    const Vector3 n = Cross(u, v);
    flat = flat || !(Dot(n, n) > flatAngle * flatAngle * Dot(u, u) * Dot(v, v));
  });
  return flat;
}

// False if a face has the apex, but is cut as a fan from another vertex.
bool CellTetrahedra::ConeFrom(int apex)
{
  this->Parts.clear();
  bool fits = true;
  this->VisitFaces([&](const int* begin, const int* end) {
    if (begin == end || *begin == apex)
    {
      return;
    }
    fits = fits && std::find(begin, end, apex) == end;
    EmitFan(begin, end, [&](int a, int b, int c) {
      this->Parts.push_back({ { { apex, a, b, c } },
        Volume(this->Places[apex], this->Places[a], this->Places[b], this->Places[c]) });
    });
  });
  return fits;
}

bool CellTetrahedra::DivideLinear()
{
  const bool fits = this->ConeFrom(this->Order.front());
  const Volumes corner = Measure(this->Parts);
  const bool isFlat = corner.Absolute <= flatShare * std::pow(this->Extent(), 3);
  if (isFlat || (fits && corner.OneSign && corner.Least > leastShare * corner.Absolute))
  {
    return true;
  }
  this->CentreVertex = this->Size();
  this->Places.push_back(this->Mean());
  this->ConeFrom(this->CentreVertex);
  const Volumes centre = Measure(this->Parts);
  // Faces that do not all turn outward give both signs in a convex cell too, yet one volume.
  return centre.OneSign ||
    std::abs(centre.Absolute - corner.Absolute) <= roundingShare * centre.Absolute;
}

// Higher-order and other 3-D cells: as VTK triangulates them.
bool CellTetrahedra::DivideByVTK()
{
  this->Data->GetCell(this->Cell, this->AnyCell);
  if (!TriangulateCell(this->AnyCell, this->Stream, this->TrianglePoints))
  {
    return false;
  }
  const vtkIdType* named = this->Stream->GetPointer(0);
  const vtkIdType count = this->Stream->GetNumberOfIds();
  const vtkIdType* ids = this->PointIds->GetPointer(0);
  const vtkIdType* end = ids + this->Size();
  std::vector<int> vertices;
  // vtkConvexPointSet of VTK 9.2 names its own points, from 0 on.
  for (bool own : { false, true })
  {
    vertices.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto vertex =
        own ? static_cast<int>(named[i]) : static_cast<int>(std::find(ids, end, named[i]) - ids);
      if (vertex < this->Size() && this->IsAt(vertex, this->TrianglePoints->GetPoint(i)))
      {
        vertices.push_back(vertex);
      }
    }
    if (static_cast<vtkIdType>(vertices.size()) == count)
    {
      break;
    }
  }
  for (std::size_t i = 0; i + 3 < vertices.size(); i += 4)
  {
    const std::array<int, 4> v = { { vertices[i], vertices[i + 1], vertices[i + 2],
      vertices[i + 3] } };
    this->Parts.push_back({ v,
      Volume(this->Places[v[0]], this->Places[v[1]], this->Places[v[2]], this->Places[v[3]]) });
  }
  return !this->Parts.empty();
}

// Up to the rounding of points in float.
bool CellTetrahedra::IsAt(int vertex, const double x[3]) const
{
  const Vector3& place = this->Places[vertex];
  return std::equal(place.begin(), place.end(), x,
    [](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); });
}

} // namespace nephoscope
