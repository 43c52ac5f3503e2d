// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSamples.h"

#include "HiddenSamples.h"
#include "HigherOrderCells.h"
#include "NeighborSpacing.h"
#include "RobustBounds.h"
#include "SplatNeedles.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace nephoscope
{
namespace
{
constexpr double sphere = 12.566370614359172;
constexpr double circle = 6.283185307179586;
// Points closer than this fraction of the bounds' diagonal coincide, to the rounding of float.
constexpr double samePlace = 2e-7;

// Which corners each corner has an edge to, and tetrahedra that fill the cell.
struct CellKind
{
  int Corners;
  int Neighbors[8][3];
  int NumberOfTetrahedra;
  int Tetrahedra[6][4];
};

constexpr CellKind tetrahedron{ 4, { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } }, 1,
  { { 0, 1, 2, 3 } } };
constexpr CellKind hexahedron{ 8,
  { { 1, 3, 4 }, { 0, 2, 5 }, { 1, 3, 6 }, { 0, 2, 7 }, { 0, 5, 7 }, { 1, 4, 6 }, { 2, 5, 7 },
    { 3, 4, 6 } },
  6,
  { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 },
    { 0, 5, 1, 6 } } };
constexpr CellKind wedge{ 6,
  { { 1, 2, 3 }, { 0, 2, 4 }, { 0, 1, 5 }, { 0, 4, 5 }, { 1, 3, 5 }, { 2, 3, 4 } }, 3,
  { { 0, 1, 2, 5 }, { 0, 1, 5, 4 }, { 0, 4, 5, 3 } } };

// Faces of a hexahedron, from each of their edges on, and the corners on the other side.
constexpr int collapsed[12][8] = { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 1, 2, 3, 0, 5, 6, 7, 4 },
  { 2, 3, 0, 1, 6, 7, 4, 5 }, { 3, 0, 1, 2, 7, 4, 5, 6 }, { 0, 4, 5, 1, 3, 7, 6, 2 },
  { 4, 5, 1, 0, 7, 6, 2, 3 }, { 5, 1, 0, 4, 6, 2, 3, 7 }, { 1, 0, 4, 5, 2, 3, 7, 6 },
  { 0, 3, 7, 4, 1, 2, 6, 5 }, { 3, 7, 4, 0, 2, 6, 5, 1 }, { 7, 4, 0, 3, 6, 5, 1, 2 },
  { 4, 0, 3, 7, 5, 1, 2, 6 } };

using Shares = std::vector<CellShare>;

vtkIdType placeOf(const std::vector<vtkIdType>& places, vtkIdType point)
{
  return places.empty() ? point : places[static_cast<std::size_t>(point)];
}

// Particles in one place stay apart: each is a sample of its own.
bool hasExtendedCells(vtkDataSet* data)
{
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    const int type = data->GetCellType(id);
    if (type != VTK_VERTEX && type != VTK_POLY_VERTEX && type != VTK_EMPTY_CELL)
    {
      return true;
    }
  }
  return false;
}

double diagonalOf(const MediumBounds& b)
{
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

// For every point the first that lies in its place; empty if all lie apart.
std::vector<vtkIdType> findPlaces(vtkDataSet* data)
{
  std::vector<vtkIdType> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    double x[3];
    data->GetPoint(id, x);
    if (std::isfinite(x[0] + x[1] + x[2]))
    {
      points->InsertNextPoint(x);
      ids.push_back(id);
    }
  }
  if (ids.empty())
  {
    return {};
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  std::vector<vtkIdType> merged(ids.size());
  locator->MergePoints(samePlace * diagonalOf(BulkOfPoints(data)), merged.data());
  std::vector<vtkIdType> places(static_cast<std::size_t>(data->GetNumberOfPoints()));
  std::iota(places.begin(), places.end(), 0);
  bool apart = true;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const vtkIdType first = merged[i] >= 0 ? ids[static_cast<std::size_t>(merged[i])] : ids[i];
    places[static_cast<std::size_t>(ids[i])] = first;
    apart = apart && first == ids[i];
  }
  return apart ? std::vector<vtkIdType>() : places;
}

// The shares of one cell for its corners, and the whole cell.
class CellShares
{
public:
  CellShares(vtkDataSet* data, Shares& shares, const std::vector<vtkIdType>& places, bool onCells)
    : Data(data)
    , All(shares)
    , Places(places)
    , OnCells(onCells)
  {
  }

  void Add(vtkIdType id)
  {
    this->Id = id;
    const int type = this->Data->GetCellType(id);
    if (type == VTK_EMPTY_CELL || type == VTK_VERTEX || type == VTK_POLY_VERTEX ||
      type == VTK_LINE || type == VTK_POLY_LINE)
    {
      return;
    }
    this->Data->GetCellPoints(id, this->Points);
    if (type == VTK_TETRA)
    {
      this->AddSolid(tetrahedron, this->Points->GetPointer(0));
    }
    else if (type == VTK_HEXAHEDRON)
    {
      this->AddHexahedron();
    }
    else if (type == VTK_VOXEL)
    {
      const vtkIdType* p = this->Points->GetPointer(0);
      const vtkIdType corners[8] = { p[0], p[1], p[3], p[2], p[4], p[5], p[7], p[6] };
      this->AddSolid(hexahedron, corners);
    }
    else if (type == VTK_WEDGE)
    {
      this->AddSolid(wedge, this->Points->GetPointer(0));
    }
    else if (type == VTK_PYRAMID)
    {
      this->AddPyramid(this->Points->GetPointer(0));
    }
    else if (type == VTK_QUAD) // parts would favour one diagonal
    {
      this->AddPolygon({ this->Points->begin(), this->Points->end() });
    }
    else if (type == VTK_PIXEL)
    {
      const vtkIdType* p = this->Points->GetPointer(0);
      this->AddPolygon({ p[0], p[1], p[3], p[2] });
    }
    else
    {
      this->AddByParts();
    }
  }

private:
  Vector3 Place(vtkIdType point) const
  {
    Vector3 x;
    this->Data->GetPoint(point, x.data());
    return x;
  }

  void Give(vtkIdType point, const CellShare& share)
  {
    if (!this->OnCells)
    {
      this->All[static_cast<std::size_t>(placeOf(this->Places, point))].Add(share);
      return;
    }
    CellShare whole = share;
    whole.Angle = whole.MeanAngle = whole.LatticeAngle = 0; // the share of all corners is the cell
    this->All[static_cast<std::size_t>(this->Id)].Add(whole);
  }

  // `times`: of parts of a cell that overlap.
  void AddSolid(const CellKind& kind, const vtkIdType* points, double times = 1)
  {
    Vector3 x[8];
    for (int i = 0; i < kind.Corners; ++i)
    {
      x[i] = this->Place(points[i]);
    }
    double volume = 0;
    for (int t = 0; t < kind.NumberOfTetrahedra; ++t)
    {
      const int* c = kind.Tetrahedra[t];
      volume += times * std::abs(signedVolume(x[c[0]], x[c[1]], x[c[2]], x[c[3]]));
    }
    SplatMatrix edges[8] = {};
    double angles[8], all = 0;
    for (int i = 0; i < kind.Corners; ++i)
    {
      Vector3 e[3];
      for (int k = 0; k < 3; ++k)
      {
        e[k] = x[kind.Neighbors[i][k]] - x[i];
        AddOuterProduct(edges[i], e[k]);
      }
      angles[i] = times * SolidAngle(e[0], e[1], e[2]) / sphere;
      all += angles[i];
    }
    for (int i = 0; i < kind.Corners && all > 0; ++i)
    {
      // Corners of tetrahedra have shares by their angles: what falls to a point then depends little on how space is cut into them.
      const double even = all / kind.Corners;
      CellShare share;
      share.Dimension = 3;
      share.Angle = angles[i];
      share.Tetrahedra = kind.Corners == 4;
      share.MeanAngle = kind.Corners == 4 ? angles[i] : even;
      share.LatticeAngle =
        kind.Corners == 6 ? 0.5 * (angles[i] + angles[(i + 3) % 6]) : share.MeanAngle;
      share.Size = volume * share.MeanAngle / all;
      AddWeighted(share.Edges, edges[i], share.MeanAngle);
      this->Give(points[i], share);
    }
  }

  // Half of it by each of the diagonals of its base.
  void AddPyramid(const vtkIdType* p)
  {
    const vtkIdType parts[4][4] = { { p[0], p[1], p[2], p[4] }, { p[0], p[2], p[3], p[4] },
      { p[0], p[1], p[3], p[4] }, { p[1], p[2], p[3], p[4] } };
    for (const auto& part : parts)
    {
      this->AddSolid(tetrahedron, part, 0.5);
    }
  }

  // Where two of its edges have no length, at an axis, it is a wedge.
  void AddHexahedron()
  {
    const vtkIdType* p = this->Points->GetPointer(0);
    const auto same = [&](int a, int b) {
      return placeOf(this->Places, p[a]) == placeOf(this->Places, p[b]);
    };
    for (const auto& c : collapsed)
    {
      if (same(c[0], c[1]) && same(c[4], c[5]))
      {
        const vtkIdType corners[6] = { p[c[0]], p[c[2]], p[c[3]], p[c[4]], p[c[6]], p[c[7]] };
        this->AddSolid(wedge, corners);
        return;
      }
    }
    this->AddSolid(hexahedron, p);
  }

  // A cell of two dimensions, one edge after the other.
  void AddPolygon(const std::vector<vtkIdType>& points)
  {
    const std::size_t count = points.size();
    double area = 0;
    const Vector3 first = this->Place(points[0]);
    for (std::size_t i = 2; i < count; ++i)
    {
      area += 0.5 * norm(cross(this->Place(points[i - 1]) - first, this->Place(points[i]) - first));
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector3 x = this->Place(points[i]);
      const Vector3 a = this->Place(points[(i + 1) % count]) - x;
      const Vector3 b = this->Place(points[(i + count - 1) % count]) - x;
      CellShare share;
      share.Dimension = 2;
      share.Size = area / static_cast<double>(count);
      share.Angle = std::atan2(norm(cross(a, b)), dot(a, b)) / circle;
      share.MeanAngle = 0.5 * (static_cast<double>(count) - 2) / static_cast<double>(count);
      share.LatticeAngle = count == 3 ? share.Angle : share.MeanAngle;
      SplatMatrix edges{}, normals{};
      AddOuterProduct(edges, a);
      AddOuterProduct(edges, b);
      AddOuterProduct(normals, normalized(cross(a, b)));
      AddWeighted(share.Edges, edges, share.MeanAngle);
      AddWeighted(share.Normals, normals, share.Size);
      this->Give(points[i], share);
    }
  }

  // Other cells are tetrahedra or triangles.
  void AddByParts()
  {
    this->Data->GetCell(this->Id, this->Cell);
    const int dimension = this->Cell->GetCellDimension();
    if (dimension < 2 || !triangulateCell(this->Cell, this->Points, this->Coordinates))
    {
      return;
    }
    const vtkIdType step = dimension + 1;
    for (vtkIdType i = 0; i + step <= this->Points->GetNumberOfIds(); i += step)
    {
      const vtkIdType* part = this->Points->GetPointer(i);
      if (dimension == 3)
      {
        this->AddSolid(tetrahedron, part);
      }
      else
      {
        this->AddPolygon({ part, part + 3 });
      }
    }
  }

  vtkDataSet* Data;
  Shares& All;
  const std::vector<vtkIdType>& Places;
  bool OnCells;
  vtkIdType Id = 0;
  vtkNew<vtkIdList> Points;
  vtkNew<vtkPoints> Coordinates;
  vtkNew<vtkGenericCell> Cell;
};
}

namespace
{
// One-sided points take the shape of the others of their cells.
void shareShapes(vtkDataSet* data, Shares& shares, const std::vector<vtkIdType>& places)
{
  std::map<vtkIdType, std::pair<SplatMatrix, int>> shapes; // sums
  vtkNew<vtkIdList> points;
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    data->GetCellPoints(id, points);
    for (const vtkIdType first : *points)
    {
      const vtkIdType a = placeOf(places, first);
      for (const vtkIdType second : *points)
      {
        const vtkIdType b = placeOf(places, second);
        const CellShare& other = shares[static_cast<std::size_t>(b)];
        if (shares[static_cast<std::size_t>(a)].IsOneSided() && other.Dimension == 3 &&
          !other.IsOneSided())
        {
          AddWeighted(shapes[a].first, other.Edges, 1 / other.MeanAngle);
          ++shapes[a].second;
        }
      }
    }
  }
  for (const auto& shape : shapes)
  {
    CellShare& share = shares[static_cast<std::size_t>(shape.first)];
    share.Edges = {};
    AddWeighted(share.Edges, shape.second.first, share.MeanAngle / shape.second.second);
  }
}
}

void CellSamples::Find(vtkDataSet* data, bool onCells)
{
  const vtkIdType count = onCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  Shares shares(static_cast<std::size_t>(count));
  const std::vector<vtkIdType> places =
    hasExtendedCells(data) ? findPlaces(data) : std::vector<vtkIdType>();
  this->Places = onCells ? std::vector<vtkIdType>() : places;
  CellShares cells(data, shares, places, onCells);
  const std::vector<unsigned char> hidden = FindHiddenCells(data);
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    if (hidden.empty() || !hidden[static_cast<std::size_t>(id)])
    {
      cells.Add(id);
    }
  }
  if (!onCells)
  {
    shareShapes(data, shares, places);
  }
  this->Shapes.clear();
  this->Parts.clear();
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    CellShare& share = shares[i];
    share.Angle = onCells && share.Dimension > 0 ? 1 : share.Angle; // nothing around it counts
    if (!(share.EdgeLength() > 0) || !std::isfinite(share.EdgeLength()))
    {
      continue;
    }
    this->Shapes.resize(shares.size(), std::array<float, 9>{});
    this->Parts.resize(shares.size(), 1.0f);
    this->Parts[i] = static_cast<float>((onCells ? 1.0 : share.Around()) * share.Fill());
    const SplatMatrix jacobian = share.Jacobian();
    for (std::size_t c = 0; c < 9; ++c)
    {
      this->Shapes[i][c] = static_cast<float>(jacobian[c / 3][c % 3]);
    }
  }
  if (!this->Shapes.empty())
  {
    WidenNeedles(data, onCells, places, hidden, { this->Shapes, this->Parts });
  }
}

bool CellSamples::Get(vtkIdType id, SplatMatrix& jacobian) const
{
  const auto i = static_cast<std::size_t>(id);
  if (this->Shapes.empty() || this->Shapes[i][0] == 0)
  {
    return false;
  }
  for (std::size_t c = 0; c < 9; ++c)
  {
    jacobian[c / 3][c % 3] = this->Shapes[i][c];
  }
  return true;
}

Vector3 CenterOfCell(vtkDataSet* data, vtkIdType id)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(id, corners);
  std::vector<Vector3> places;
  for (const vtkIdType corner : *corners)
  {
    Vector3 x;
    data->GetPoint(corner, x.data());
    if (std::find(places.begin(), places.end(), x) == places.end())
    {
      places.push_back(x);
    }
  }
  Vector3 sum{};
  for (const Vector3& x : places)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += x[c] / static_cast<double>(places.size());
    }
  }
  return sum;
}

} // namespace nephoscope
