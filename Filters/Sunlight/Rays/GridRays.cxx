// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridRays.h"

#include "GridWalk.h"
#include "SunRay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
// Rows that are one point, at both ends of each level.
std::vector<bool> GridRays::FindPoles(
  const ChessboardGrid& grid, const std::vector<std::int32_t>& merged)
{
  std::vector<bool> poles(2 * grid.Size[2]);
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (const int side : { 0, 1 })
    {
      const auto row = merged.begin() + grid.PointNumber(0, side * (grid.Size[1] - 1), k);
      poles[2 * k + side] =
        std::all_of(row, row + grid.Size[0], [row](std::int32_t p) { return p == *row; });
    }
  }
  return poles;
}

bool GridRays::IsPole(const Index& at) const
{
  const int last = this->Grid.Size[1] - 1;
  return !this->Poles.empty() && (at[1] == 0 || at[1] == last) &&
    this->Poles[2 * at[2] + (at[1] == last)];
}

bool GridRays::IsFitting(const std::vector<std::int32_t>& merged) const
{
  const int n = this->Grid.Size[0];
  std::int64_t p = 0;
  for (Index at{ { 0, 0, 0 } }; at[2] < this->Grid.Size[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < this->Grid.Size[1]; ++at[1])
    {
      const std::int64_t row = p;
      const bool isPole = this->IsPole(at);
      for (int i = 0; i < n; ++i, ++p)
      {
        if (merged[p] != (isPole || (this->Closed[0] && i == n - 1) ? row : p))
        {
          return false;
        }
      }
    }
  }
  return !this->Closed[0] || n % 2 == 1;
}

bool GridRays::Connect(const std::vector<std::int32_t>& merged)
{
  if (!merged.empty())
  {
    const std::int64_t middle = this->Grid.PointNumber(0, this->Grid.Size[1] / 2, 0);
    this->Closed[0] =
      this->Grid.Size[0] > 3 && merged[middle + this->Grid.Size[0] - 1] == merged[middle];
    this->Poles = FindPoles(this->Grid, merged);
  }
  return merged.empty() || this->IsFitting(merged);
}

void GridRays::Turn(std::vector<SunPoint> points)
{
  this->Points = std::move(points);
  for (int axis = 0; axis < 2 && this->IsRepeated; ++axis)
  {
    Index last{ { 0, 0, 0 } };
    last[axis] = this->Grid.Size[axis] - 1;
    const SunPoint &a = this->Points[0],
                   &b = this->Points[this->Grid.PointNumber(last[0], last[1], last[2])];
    this->Periods[axis] = { { b.X - a.X, b.Y - a.Y, b.Z - a.Z } };
  }
  this->Clouds = LastClouds(this->Points);
  for (std::int64_t cell = 0; cell < this->Grid.NumberOfCells(); ++cell)
  {
    if (this->IsHidden(cell))
    {
      continue;
    }
    const Index c = this->Grid.CellIndex(cell);
    const std::int64_t first = this->Grid.PointNumber(c[0], c[1], c[2]), row = this->Grid.Size[0],
                       level = row * this->Grid.Size[1];
    this->Clouds.Add(this->Points,
      std::array<std::int64_t, 8>{ { first, first + 1, first + row, first + row + 1, first + level,
        first + level + 1, first + level + row, first + level + row + 1 } });
  }
}

bool GridRays::HasPoint(int index, int axis) const
{
  return this->Closed[axis] || (index >= 0 && index < this->Grid.Size[axis]);
}

int GridRays::Wrapped(int index, int axis) const
{
  const int n = this->Grid.Size[axis] - 1;
  return !this->Closed[axis] ? index : index < 0 ? index + n : index >= n ? index - n : index;
}

SunPoint GridRays::PointAt(const Index& at) const
{
  const Index stored{ { this->Wrapped(at[0], 0), this->Wrapped(at[1], 1), at[2] } };
  SunPoint point = this->Points[this->Grid.PointNumber(stored[0], stored[1], stored[2])];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double turn = at[axis] > stored[axis] ? 1 : at[axis] < stored[axis] ? -1 : 0;
    point.X += turn * this->Periods[axis][0];
    point.Y += turn * this->Periods[axis][1];
    point.Z += turn * this->Periods[axis][2];
  }
  return point;
}

// The longest edge at a point, across the direction of the sun.
double GridRays::SizeAt(const Index& at) const
{
  double size = 0;
  const SunPoint& here = this->PointAt(at);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { -1, 1 })
    {
      Index beside = at;
      beside[axis] += side;
      if (this->HasPoint(beside[axis], axis))
      {
        const SunPoint& there = this->PointAt(beside);
        size = std::max(size, std::abs(there.X - here.X) + std::abs(there.Y - here.Y));
      }
    }
  }
  return size;
}

struct GridRays::Path
{
  SunRay Ray;
  GridWalk Walk;
  double End = 0;
  std::int64_t Left = 0; // steps, in case that rounding leads around an edge for ever

  bool GoesOn()
  {
    return this->Ray.Height() < this->End && !this->Ray.IsDark() && this->Walk.Inside() &&
      --this->Left > 0;
  }
};

// In the tetrahedra of the cell on these sides of the point.
bool GridRays::BeginIn(const Index& at, const Index& side, Path& path) const
{
  constexpr int odd = GridWalk::odd;
  const auto moved = [&](int x, int y, int z) {
    return Index{ { at[0] + x * side[0], at[1] + y * side[1], at[2] + z * side[2] } };
  };
  std::array<int, 3> lowest;
  for (int axis = 0; axis < 3; ++axis)
  {
    lowest[axis] = this->Wrapped(at[axis] + (side[axis] < 0 ? -1 : 0), axis);
  }
  const bool isThere = !this->IsHidden(lowest[0] +
    (this->Grid.Size[0] - 1) * (lowest[1] + std::int64_t(this->Grid.Size[1] - 1) * lowest[2]));
  const auto goes = [&](const Index& oddVertex, const Index& towards, Index labels, bool isBetween,
                      const Index& a, const Index& b, const Index& c) {
    const int turn = path.Ray.Start(this->PointAt(a), this->PointAt(b), this->PointAt(c), isThere);
    if (turn < 0)
    {
      std::swap(labels[1], labels[2]);
    }
    if (turn != 0)
    {
      path.Walk = GridWalk(this->Grid, this->Closed, oddVertex, towards, labels, isBetween);
      this->Follow(path);
    }
    return turn != 0;
  };
  if ((at[0] + at[1] + at[2] + this->Grid.OddOffset) % 2 == 1)
  {
    return goes(at, side, { 0, 1, 2 }, true, moved(1, 0, 0), moved(0, 1, 0), moved(0, 0, 1));
  }
  const Index inward{ { -side[0], -side[1], -side[2] } };
  return goes(moved(1, 1, 1), inward, { 0, 1, 2 }, false, moved(0, 1, 1), moved(1, 0, 1),
           moved(1, 1, 0)) ||
    goes(
      moved(1, 0, 0), side, { odd, 1, 2 }, false, moved(1, 0, 0), moved(1, 1, 0), moved(1, 0, 1)) ||
    goes(
      moved(0, 1, 0), side, { odd, 2, 0 }, false, moved(0, 1, 0), moved(0, 1, 1), moved(1, 1, 0)) ||
    goes(
      moved(0, 0, 1), side, { odd, 0, 1 }, false, moved(0, 0, 1), moved(1, 0, 1), moved(0, 1, 1));
}

// Edges that go towards the sun tell where the ray probably begins.
bool GridRays::BeginBeside(const Index& at, Path& path) const
{
  int probable = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    Index beside = at;
    ++beside[axis];
    const bool isUp =
      this->HasPoint(beside[axis], axis) && this->PointAt(beside).Z > this->PointAt(at).Z;
    probable |= isUp ? 1 << axis : 0;
  }
  for (int number = 0; number < 8; ++number)
  {
    const int bits = number ^ probable;
    const Index side{ { bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1 } };
    if (this->HasPoint(at[0] + side[0], 0) && this->HasPoint(at[1] + side[1], 1) &&
      this->HasPoint(at[2] + side[2], 2) && this->BeginIn(at, side, path))
    {
      return true;
    }
  }
  return false;
}

// Moves the ray across a seam, to where the grid is stored.
void GridRays::Follow(Path& path) const
{
  const Index turns = path.Walk.TakeTurns();
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::array<double, 3>& period = this->Periods[axis];
    path.Ray.Move(turns[axis] * period[0], turns[axis] * period[1], turns[axis] * period[2]);
  }
}

bool GridRays::Begin(std::int32_t point, Path& path) const
{
  const int nx = this->Grid.Size[0], ny = this->Grid.Size[1];
  Index at{ { this->Wrapped(point % nx, 0), this->Wrapped(point / nx % ny, 1), point / nx / ny } };
  const SunPoint& here = this->PointAt(at);
  path.End = this->Clouds.HeightAt(here.X, here.Y);
  path.Left = this->Grid.NumberOfCells();
  if (this->IsRepeated) // rays to a low sun must end
  {
    path.End = std::numeric_limits<double>::max();
    path.Left = std::int64_t(100) * (this->Grid.Size[0] + this->Grid.Size[1] + this->Grid.Size[2]);
  }
  if (here.Z >= path.End)
  {
    return false;
  }
  const double size = 1e-9 * this->SizeAt(at);
  for (const auto& side : sidesOfRay)
  {
    path.Ray = SunRay(here, size * side[0], size * side[1]);
    for (int i = 0, n = this->IsPole(at) ? nx - 1 : 1; i < n; ++i)
    {
      at[0] = n > 1 ? i : at[0];
      if (this->BeginBeside(at, path))
      {
        return path.GoesOn();
      }
    }
  }
  return false;
}

std::array<double, 2> GridRays::DepthsFrom(std::int32_t point) const
{
  Path path;
  for (bool goesOn = this->Begin(point, path); goesOn; goesOn = path.GoesOn())
  {
    const bool isThere = !this->IsHidden(path.Walk.CellNumber());
    path.Walk.Leave(path.Ray.Step(this->Points[path.Walk.Vertex()], isThere));
    if (path.Walk.HasTurned())
    {
      this->Follow(path);
    }
  }
  return path.Ray.Depths();
}
}
