// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AreaPick.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <queue>

namespace nephoscope
{
namespace
{
constexpr int tileSize = 8; // pixels

/** A tetrahedron in the picture. */
struct Projected
{
  std::int64_t Tetrahedron;
  double Depth;             // least of its vertices
  std::array<int, 4> Place; // first and last column and row of pixels
};

double Apply(const Vector4& row, const Vector3& p)
{
  return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
}

std::array<Vector3, 4> VerticesOf(const CellGeometry& geometry, std::int64_t tetrahedron)
{
  std::array<Vector3, 4> p;
  const auto numbers = geometry.PointNumbers(tetrahedron);
  for (std::size_t k = 0; k < 4; ++k)
  {
    p[k] = geometry.Position(static_cast<std::int32_t>(numbers[k]));
  }
  return p;
}

struct Range
{
  float Low = std::numeric_limits<float>::infinity(), High = -Low;
  bool HasNoNumber = false;
  void Add(float value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
    this->HasNoNumber = this->HasNoNumber || std::isnan(value);
  }
};

/** Tells which tetrahedra no ray loses light in. */
class ClearParts
{
public:
  ClearParts(const CellGeometry& geometry, const PickMedium& medium)
    : Geometry(geometry)
    , Medium(medium)
    , PerCell(!geometry.Hexahedra.empty() ? geometry.TetrahedraPerHexahedron()
          : geometry.Grid.IsEmpty()       ? 1
                                          : ChessboardGrid::TetrahedraPerCell)
  {
  }

  bool Contain(std::int64_t tetrahedron) const
  {
    const auto number = static_cast<std::size_t>(tetrahedron / this->PerCell);
    const std::size_t table = this->Medium.TablesOfTetrahedra.empty()
      ? 0
      : static_cast<std::size_t>(this->Medium.TablesOfTetrahedra[number]);
    Range opacity, contoured;
    // The field of a whole cell has the bounds of all its vertices.
    const std::int64_t first =
      this->Medium.Scalar ? tetrahedron / this->PerCell * this->PerCell : tetrahedron;
    const std::int64_t end = this->Medium.Scalar ? first + this->PerCell : tetrahedron + 1;
    for (std::int64_t part = first; part < end; ++part)
    {
      for (const std::int64_t p : this->Geometry.PointNumbers(part))
      {
        opacity.Add(this->Opacity(number, static_cast<std::size_t>(p)));
        contoured.Add(this->Contoured(number, static_cast<std::size_t>(p)));
      }
    }
    return !opacity.HasNoNumber && !this->HasSurface(contoured) &&
      this->Medium.Tables[table].IsTransparent(opacity.Low, opacity.High);
  }

private:
  float Color(std::size_t number, std::size_t point) const
  {
    return this->Geometry.CellScalars.empty() ? this->Geometry.Points[point].Scalar
                                              : this->Geometry.CellScalars[number];
  }

  float Opacity(std::size_t number, std::size_t point) const
  {
    return this->Geometry.HasOpacityScalars
      ? this->Geometry.OpacityScalars[this->Geometry.OpacityOnCells ? number : point]
      : this->Color(number, point);
  }

  float Contoured(std::size_t number, std::size_t point) const
  {
    return this->Medium.Contoured ? (*this->Medium.Contoured)[point] : this->Color(number, point);
  }

  bool HasSurface(const Range& range) const
  {
    return std::any_of(this->Medium.Surfaces.begin(), this->Medium.Surfaces.end(),
      [&](const PickMedium::Surface& surface) {
        return range.HasNoNumber || (range.Low <= surface.Value && range.High >= surface.Value);
      });
  }

  const CellGeometry& Geometry;
  const PickMedium& Medium;
  std::int64_t PerCell;
};

/** Where the vertices lie in the picture; the whole of it if one is not in front of the eye. */
Projected Project(
  const std::array<Vector3, 4>& vertices, std::int64_t tetrahedron, const PickArea& area)
{
  constexpr double margin = 0.01; // of a pixel, for rounding
  Projected result{ tetrahedron, std::numeric_limits<double>::infinity(), {} };
  std::array<double, 2> low = { { 1e9, 1e9 } }, high = { { -1e9, -1e9 } };
  bool isBehind = false;
  for (const Vector3& p : vertices)
  {
    result.Depth = std::min(result.Depth, Apply(area.ToDepth, p));
    const double w = Apply(area.ToW, p);
    isBehind = isBehind || !(w > 1e-9);
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const double at = std::min(std::max(Apply(area.ToPixels[axis], p) / w, -1e9), 1e9);
      low[axis] = std::min(low[axis], at - margin);
      high[axis] = std::max(high[axis], at + margin);
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const int last = area.Size[axis] - 1;
    result.Place[2 * axis] = isBehind ? 0 : std::max(static_cast<int>(std::floor(low[axis])), 0);
    result.Place[2 * axis + 1] =
      isBehind ? last : std::min(static_cast<int>(std::floor(high[axis])), last);
  }
  return result;
}

std::vector<Projected> ProjectAll(
  const CellGeometry& geometry, const std::function<PickMedium()>& makeMedium, const PickArea& area)
{
  const PickMedium medium = makeMedium();
  const ClearParts clear(geometry, medium);
  std::vector<Projected> all;
  std::mutex mutex;
  vtkSMPTools::For(0, geometry.CountTetrahedra(), [&](vtkIdType begin, vtkIdType end) {
    std::vector<Projected> some;
    for (vtkIdType i = begin; i < end; ++i)
    {
      if (geometry.IsHidden(i))
      {
        continue;
      }
      const Projected one = Project(VerticesOf(geometry, i), i, area);
      if (one.Place[0] <= one.Place[1] && one.Place[2] <= one.Place[3] && !clear.Contain(i))
      {
        some.push_back(one);
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    all.insert(all.end(), some.begin(), some.end());
  });
  return all;
}

/** Lists of what each tile shows. */
class Tiles
{
public:
  Tiles(const std::vector<Projected>& all, const PickArea& area)
    : Area(area)
    , Columns((area.Size[0] + tileSize - 1) / tileSize)
    , Rows((area.Size[1] + tileSize - 1) / tileSize)
    , Begins(static_cast<std::size_t>(Columns * Rows) + 1, 0)
  {
    this->ForEach(all, [&](std::size_t tile, std::size_t) { ++this->Begins[tile + 1]; });
    for (std::size_t tile = 0; tile + 1 < this->Begins.size(); ++tile)
    {
      this->Begins[tile + 1] += this->Begins[tile];
    }
    this->Members.resize(this->Begins.back());
    std::vector<std::size_t> next = this->Begins;
    this->ForEach(
      all, [&](std::size_t tile, std::size_t number) { this->Members[next[tile]++] = number; });
  }

  int Count() const { return this->Columns * this->Rows; }

  /** First and last column and row of pixels. */
  std::array<int, 4> Place(int tile) const
  {
    const int x = tile % this->Columns * tileSize, y = tile / this->Columns * tileSize;
    return { { x, std::min(x + tileSize, this->Area.Size[0]) - 1, y,
      std::min(y + tileSize, this->Area.Size[1]) - 1 } };
  }

  /** Copies, from front to back. */
  std::vector<Projected> Sorted(const std::vector<Projected>& all, int tile) const
  {
    std::vector<Projected> members;
    for (std::size_t i = this->Begins[static_cast<std::size_t>(tile)];
         i < this->Begins[static_cast<std::size_t>(tile) + 1]; ++i)
    {
      members.push_back(all[this->Members[i]]);
    }
    std::sort(members.begin(), members.end(), [](const Projected& a, const Projected& b) {
      return std::make_pair(a.Depth, a.Tetrahedron) < std::make_pair(b.Depth, b.Tetrahedron);
    });
    return members;
  }

private:
  template <typename Visit>
  void ForEach(const std::vector<Projected>& all, Visit visit) const
  {
    for (std::size_t number = 0; number < all.size(); ++number)
    {
      const std::array<int, 4>& place = all[number].Place;
      const auto tileOf = [&](std::size_t side) { return place[side] / tileSize; };
      for (int row = tileOf(2); row <= tileOf(3); ++row)
      {
        for (int column = tileOf(0); column <= tileOf(1); ++column)
        {
          visit(static_cast<std::size_t>(row * this->Columns + column), number);
        }
      }
    }
  }

  const PickArea& Area;
  int Columns, Rows;
  std::vector<std::size_t> Begins, Members;
};

struct IsBehind
{
  bool operator()(const PickCrossing& a, const PickCrossing& b) const { return IsBefore(b, a); }
};

/** One ray, through what may be in its way. */
PickedCell PickAmong(const std::vector<Projected>& members, int x, int y,
  const CellGeometry& geometry, const PickMedium& medium, const PickArea& area, double left)
{
  const PickRay ray = area.Ray(x, y);
  const SidesOfRay sides(ray);
  const double start = Apply(area.ToDepth, ray.Start);
  const double slope = Apply(area.ToDepth, ray.Direction) - area.ToDepth[3];
  std::priority_queue<PickCrossing, std::vector<PickCrossing>, IsBehind> found;
  // What lies in front of a depth is known once all that begins there has been tested.
  const auto walkTo = [&](double parameter) {
    PickedCell picked;
    while (picked.Tetrahedron < 0 && !found.empty() &&
      0.5 * (found.top().Begin + found.top().End) < parameter)
    {
      picked = WalkCrossing(geometry, medium, ray, found.top(), left);
      found.pop();
    }
    return picked;
  };
  for (const Projected& one : members)
  {
    if (x < one.Place[0] || x > one.Place[1] || y < one.Place[2] || y > one.Place[3])
    {
      continue;
    }
    const PickedCell picked = walkTo((one.Depth - start) / slope);
    if (picked.Tetrahedron >= 0)
    {
      return picked;
    }
    const std::array<Vector3, 4> vertices = VerticesOf(geometry, one.Tetrahedron);
    PickCrossing crossing;
    crossing.Tetrahedron = one.Tetrahedron;
    if (!sides.Miss(vertices) && FindCrossing(vertices, ray, crossing))
    {
      found.push(crossing);
    }
  }
  return walkTo(std::numeric_limits<double>::infinity());
}
} // namespace

std::vector<PickedCell> PickCells(const CellGeometry& geometry,
  const std::function<PickMedium()>& makeMedium, const PickArea& area, double opticalDepth)
{
  const std::vector<Projected> all = ProjectAll(geometry, makeMedium, area);
  const Tiles tiles(all, area);
  std::vector<PickedCell> picked(
    static_cast<std::size_t>(area.Size[0]) * static_cast<std::size_t>(area.Size[1]));
  vtkSMPTools::For(0, tiles.Count(), 16, [&](vtkIdType begin, vtkIdType end) {
    const PickMedium medium = makeMedium();
    for (int tile = static_cast<int>(begin); tile < static_cast<int>(end); ++tile)
    {
      const std::vector<Projected> members = tiles.Sorted(all, tile);
      const std::array<int, 4> place = tiles.Place(tile);
      for (int y = place[2]; y <= place[3] && !members.empty(); ++y)
      {
        for (int x = place[0]; x <= place[1]; ++x)
        {
          const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(area.Size[0]) +
            static_cast<std::size_t>(x);
          picked[pixel] = PickAmong(members, x, y, geometry, medium, area, opticalDepth);
        }
      }
    }
  });
  return picked;
}

} // namespace nephoscope
