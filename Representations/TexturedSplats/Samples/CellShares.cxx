// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellShares.h"

#include "CellKinds.h"
#include "CellMoments.h"
#include "CellTaper.h"
#include "HigherOrderCells.h"
#include "PointPlaces.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double sphere = 12.566370614359172;
constexpr double lattice = 1.0 / 8; // the angle of a hexahedron's corner
constexpr double circle = 6.283185307179586;

// The shares of one cell for its corners, and the whole cell.
class ShareFinder
{
public:
  ShareFinder(
    vtkDataSet* data, CellShares& found, const std::vector<vtkIdType>& places, bool onCells)
    : Data(data)
    , Found(found)
    , Places(places)
    , OnCells(onCells)
    , Rounding(RoundingOfPlaces(data))
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
    this->Whole = CellMoments(this->Place(this->Points->GetId(0)));
    this->AddCell(type);
    if (this->OnCells && this->Whole.GetSize() > 0)
    {
      this->Found.Covariances.resize(this->Found.Shares.size(), {});
      AddTo(this->Found.Covariances[static_cast<std::size_t>(id)], this->Whole.GetCovariance(), 1);
    }
  }

private:
  void AddCell(int type)
  {
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
    else if (type == VTK_QUADRATIC_HEXAHEDRON && !this->OnCells)
    {
      this->AddQuadraticHexahedron();
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
      this->Found.Shares[static_cast<std::size_t>(PlaceOfPoint(this->Places, point))].Add(share);
      return;
    }
    CellShare whole = share;
    whole.Angle = whole.MeanAngle = whole.LatticeAngle = 0; // the share of all corners is the cell
    this->Found.Shares[static_cast<std::size_t>(this->Id)].Add(whole);
  }

  // Where there is no other cell, the sample is nothing.
  void GiveNothing(const vtkIdType* points, int count)
  {
    CellShare nothing;
    nothing.Dimension = 1;
    for (int i = 0; i < count; ++i)
    {
      this->Give(points[i], nothing);
    }
  }

  // `times`: of parts of a cell that overlap; `weights`: the parts of the volume that are nearest to each corner, if not by their angles.
  void AddSolid(const CellKind& kind, const vtkIdType* points, double times = 1,
    const double* weights = nullptr)
  {
    Vector3 x[8];
    for (int i = 0; i < kind.Corners; ++i)
    {
      x[i] = this->Place(points[i]);
    }
    this->AddRings(kind, points);
    const double before = this->Whole.GetSize();
    for (int t = 0; t < kind.NumberOfTetrahedra; ++t)
    {
      const int* c = kind.Tetrahedra[t];
      this->Whole.AddTetrahedron(x[c[0]], x[c[1]], x[c[2]], x[c[3]], times);
    }
    const double volume = this->Whole.GetSize() - before;
    SplatMatrix edges[8] = {};
    double angles[8], all = 0, squares = 0;
    for (int i = 0; i < kind.Corners; ++i)
    {
      Vector3 e[3];
      for (int k = 0; k < 3; ++k)
      {
        e[k] = x[kind.Neighbors[i][k]] - x[i];
        AddOuterProduct(edges[i], e[k]);
        squares += dot(e[k], e[k]) / kind.Corners;
      }
      angles[i] = times * SolidAngle(e[0], e[1], e[2]) / sphere;
      all += angles[i];
    }
    if (std::isfinite(volume) && !HasExtent(std::cbrt(volume), std::sqrt(squares), this->Rounding))
    {
      this->GiveNothing(points, kind.Corners);
      return;
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
      share.Size = volume * (weights ? weights[i] : share.MeanAngle / all);
      AddWeighted(share.Edges, edges[i], share.MeanAngle);
      this->Give(points[i], share);
    }
  }

  void AddRings(const CellKind& kind, const vtkIdType* points)
  {
    for (int i = 0; i < kind.Corners && !this->Found.Rings.empty(); ++i)
    {
      const auto place = [&](int corner) {
        return static_cast<int>(PlaceOfPoint(this->Places, points[corner]));
      };
      CornerRing& ring = this->Found.Rings[static_cast<std::size_t>(place(i))];
      if (kind.Corners == 8)
      {
        const int* next = kind.Neighbors[i];
        ring.Add({ place(next[0]), place(next[1]), place(next[2]) });
      }
      else
      {
        ring.Break();
      }
    }
  }

  // Without points in its faces and its middle, its parts would leave gaps there. Its corners, and the middles of its edges along each axis, are four lattices, each
  // with one sample for each cell: each sample has the shape of a whole cell, and a quarter of its volume. Curved edges count as straight ones.
  void AddQuadraticHexahedron()
  {
    const vtkIdType* p = this->Points->GetPointer(0);
    Vector3 x[8];
    for (int i = 0; i < 8; ++i)
    {
      x[i] = this->Place(p[i]);
    }
    const double volume = momentsOf(hexahedron, x).GetSize();
    SplatMatrix edges[8] = {};
    double squares = 0;
    for (int i = 0; i < 8; ++i)
    {
      for (const int next : hexahedron.Neighbors[i])
      {
        AddOuterProduct(edges[i], x[next] - x[i]);
        squares += dot(x[next] - x[i], x[next] - x[i]) / 8;
      }
    }
    if (std::isfinite(volume) && !HasExtent(std::cbrt(volume), std::sqrt(squares), this->Rounding))
    {
      this->GiveNothing(p, 20);
      return;
    }
    const auto give = [&](vtkIdType point, double part, const SplatMatrix& here) {
      CellShare share;
      share.Dimension = 3;
      share.Angle = share.MeanAngle = share.LatticeAngle = part;
      share.Size = 0.25 * part * volume;
      share.Overlaps = true;
      AddWeighted(share.Edges, here, part);
      this->Give(point, share);
    };
    for (int i = 0; i < 8; ++i)
    {
      give(p[i], lattice, edges[i]);
    }
    for (int i = 0; i < 12; ++i)
    {
      SplatMatrix both{};
      AddWeighted(both, edges[hexahedronEdges[i][0]], 0.5);
      AddWeighted(both, edges[hexahedronEdges[i][1]], 0.5);
      give(p[8 + i], 2 * lattice, both);
    }
    for (int i = 0; i < 20 && !this->Found.Rings.empty(); ++i)
    {
      this->Found.Rings[static_cast<std::size_t>(PlaceOfPoint(this->Places, p[i]))].Break();
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
      return PlaceOfPoint(this->Places, p[a]) == PlaceOfPoint(this->Places, p[b]);
    };
    for (const auto& c : collapsed)
    {
      if (same(c[0], c[1]) && same(c[4], c[5]))
      {
        const vtkIdType corners[6] = { p[c[0]], p[c[2]], p[c[3]], p[c[4]], p[c[6]], p[c[7]] };
        // A quarter of a triangle is nearer to its tip than to its base.
        constexpr double weights[6] = { 1.0 / 8, 3.0 / 16, 3.0 / 16, 1.0 / 8, 3.0 / 16, 3.0 / 16 };
        this->AddSolid(wedge, corners, 1, weights);
        this->AddTaper(p);
        return;
      }
    }
    double weights[8];
    if (!this->OnCells) // to which all of it falls
    {
      this->FindOctants(p, weights);
    }
    this->AddSolid(hexahedron, p, 1, this->OnCells ? nullptr : weights);
    this->AddTaper(p);
  }

  // The part of a hexahedron's volume that is nearest to each of its corners, by the volume that its edges span in the middle of that part.
  void FindOctants(const vtkIdType* p, double weights[8])
  {
    constexpr double threes[4] = { 1, 3, 9, 27 };
    double spanned[8], sum = 0;
    for (int i = 0; i < 8; ++i)
    {
      const Vector3 x = this->Place(p[i]);
      const int* next = hexahedron.Neighbors[i];
      spanned[i] = std::abs(tripleProduct(
        this->Place(p[next[0]]) - x, this->Place(p[next[1]]) - x, this->Place(p[next[2]]) - x));
    }
    for (int i = 0; i < 8; ++i)
    {
      weights[i] = 0;
      for (int j = 0; j < 8; ++j)
      {
        // One after the other around each of both ends, so that corners that differ by 2 there are across from each other.
        const int around = (i - j) & 3;
        const int steps = (around == 2 ? 2 : around & 1) + int(i / 4 != j / 4);
        weights[i] += spanned[j] * threes[3 - steps];
      }
      sum += weights[i];
    }
    for (int i = 0; i < 8; ++i)
    {
      weights[i] = sum > 0 && std::isfinite(sum) ? weights[i] / sum : 1.0 / 8;
    }
  }

  void AddTaper(const vtkIdType* p)
  {
    Vector3 x[8];
    for (int i = 0; i < 8; ++i)
    {
      x[i] = this->Place(p[i]);
    }
    const CellTaper taper(x);
    if (!taper.ReachesApex())
    {
      return;
    }
    this->Found.Tapers.resize(this->Found.Shares.size(), {});
    if (this->OnCells)
    {
      this->AddNeed(static_cast<std::size_t>(this->Id), taper.AtMiddle(), 1);
      return;
    }
    for (int i = 0; i < 8; ++i)
    {
      const auto place = static_cast<std::size_t>(PlaceOfPoint(this->Places, p[i]));
      this->AddNeed(place, taper.AtCorner(i), lattice);
    }
  }

  void AddNeed(std::size_t sample, const TaperNeed& need, double weight)
  {
    AddTo(this->Found.Tapers[sample], need.More, weight);
    this->Found.Tapers[sample][6] += static_cast<float>(weight * need.Squares);
  }

  template <std::size_t size>
  static void AddTo(std::array<float, size>& sum, const SplatMatrix& m, double weight)
  {
    const double numbers[6] = { m[0][0], m[0][1], m[0][2], m[1][1], m[1][2], m[2][2] };
    for (std::size_t i = 0; i < 6; ++i)
    {
      sum[i] += static_cast<float>(weight * numbers[i]);
    }
  }

  // A cell of two dimensions, one edge after the other.
  void AddPolygon(const std::vector<vtkIdType>& points)
  {
    const std::size_t count = points.size();
    double area = 0, squares = 0;
    const Vector3 first = this->Place(points[0]);
    for (std::size_t i = 2; i < count; ++i)
    {
      area += 0.5 * norm(cross(this->Place(points[i - 1]) - first, this->Place(points[i]) - first));
      squares =
        std::max(squares, dot(this->Place(points[i]) - first, this->Place(points[i]) - first));
    }
    if (std::isfinite(area) && !HasExtent(std::sqrt(area), std::sqrt(squares), this->Rounding))
    {
      this->GiveNothing(points.data(), static_cast<int>(count));
      return;
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
  CellShares& Found;
  const std::vector<vtkIdType>& Places;
  bool OnCells;
  double Rounding;
  vtkIdType Id = 0;
  CellMoments Whole{ Vector3{} };
  vtkNew<vtkIdList> Points;
  vtkNew<vtkPoints> Coordinates;
  vtkNew<vtkGenericCell> Cell;
};

bool hasHexahedra(vtkDataSet* data)
{
  bool found = false;
  for (vtkIdType id = 0; id < data->GetNumberOfCells() && !found; ++id)
  {
    const int type = data->GetCellType(id);
    found = type == VTK_HEXAHEDRON || type == VTK_VOXEL;
  }
  return found;
}
} // namespace

CellShares FindCellShares(vtkDataSet* data, bool onCells, const std::vector<vtkIdType>& places,
  const std::vector<unsigned char>& hidden)
{
  const vtkIdType count = onCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  CellShares found;
  found.Shares.resize(static_cast<std::size_t>(count));
  if (!onCells && count < VTK_INT_MAX && hasHexahedra(data))
  {
    found.Rings.resize(found.Shares.size());
  }
  ShareFinder finder(data, found, places, onCells);
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    if (hidden.empty() || !hidden[static_cast<std::size_t>(id)])
    {
      finder.Add(id);
    }
  }
  return found;
}

namespace
{
// Null for other types; tetrahedra and voxels have the mean of their corners.
const CellKind* kindOf(int type)
{
  return type == VTK_HEXAHEDRON ? &hexahedron
    : type == VTK_WEDGE         ? &wedge
    : type == VTK_PYRAMID       ? &pyramid
                                : nullptr;
}
}

Vector3 CenterOfCell(vtkDataSet* data, vtkIdType id)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(id, corners);
  if (const CellKind* kind = kindOf(data->GetCellType(id)))
  {
    Vector3 x[8];
    for (int i = 0; i < kind->Corners; ++i)
    {
      data->GetPoint(corners->GetId(i), x[i].data());
    }
    const CellMoments moments = momentsOf(*kind, x);
    if (moments.GetSize() > 0 && std::isfinite(moments.GetSize()))
    {
      return moments.GetCenter();
    }
  }
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
