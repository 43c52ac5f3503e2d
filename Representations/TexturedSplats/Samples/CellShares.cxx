// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellShares.h"

#include "CellKinds.h"
#include "CellMoments.h"
#include "CellTaper.h"
#include "CornerShares.h"
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

  HexahedronCorners CornersAt(const vtkIdType* points) const
  {
    HexahedronCorners x;
    std::transform(
      points, points + 8, x.begin(), [this](vtkIdType point) { return this->Place(point); });
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

  // `edge`: of a cube or square of the cell's size; `squares`: of its length. Cells without an
  // extent give nothing.
  void GiveAll(
    double edge, double squares, const vtkIdType* points, const CellShare* shares, int count)
  {
    CellShare nothing;
    nothing.Dimension = 1;
    const bool empty = std::isfinite(edge) && !HasExtent(edge, std::sqrt(squares), this->Rounding);
    for (int i = 0; i < count; ++i)
    {
      this->Give(points[i], empty ? nothing : shares[i]);
    }
  }

  // `times`: of parts of a cell that overlap; `weights`: the parts of the volume that are nearest
  // to each corner, if not by their angles.
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
    CellShare shares[8];
    const double squares = SharesOfSolid(kind, x, volume, times, weights, shares);
    this->GiveAll(std::cbrt(volume), squares, points, shares, kind.Corners);
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

  void AddQuadraticHexahedron()
  {
    const vtkIdType* p = this->Points->GetPointer(0);
    const auto x = this->CornersAt(p);
    const double volume = MomentsOf(hexahedron, x.data()).GetSize();
    CellShare shares[20];
    const double squares = SharesOfQuadraticHexahedron(x, volume, shares);
    this->GiveAll(std::cbrt(volume), squares, p, shares, 20);
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
    // All of it falls to a sample on the cell.
    const auto weights = OctantsOfHexahedron(this->CornersAt(p));
    this->AddSolid(hexahedron, p, 1, this->OnCells ? nullptr : weights.data());
    this->AddTaper(p);
  }

  void AddTaper(const vtkIdType* p)
  {
    const CellTaper taper(this->CornersAt(p).data());
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
      this->AddNeed(place, taper.AtCorner(i), angleInLattice);
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
    std::vector<Vector3> x(points.size());
    std::transform(points.begin(), points.end(), x.begin(),
      [this](vtkIdType point) { return this->Place(point); });
    std::vector<CellShare> shares(points.size());
    const SurfaceExtent extent = SharesOfPolygon(x, shares);
    this->GiveAll(std::sqrt(extent.Area), extent.Squares, points.data(), shares.data(),
      static_cast<int>(points.size()));
  }

  // Other cells are tetrahedra or triangles.
  void AddByParts()
  {
    this->Data->GetCell(this->Id, this->Cell);
    const int dimension = this->Cell->GetCellDimension();
    if (dimension < 2 || !TriangulateCell(this->Cell, this->Points, this->Coordinates))
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

bool HasHexahedra(vtkDataSet* data)
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
  if (!onCells && count < VTK_INT_MAX && HasHexahedra(data))
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

} // namespace nephoscope
