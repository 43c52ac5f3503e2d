// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EvenRays.h"

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
Place Between(const SunPoint& a, const SunPoint& b, double scale = 1)
{
  return { { scale * (b.X - a.X), scale * (b.Y - a.Y), scale * (b.Z - a.Z) } };
}

double LengthOf(const Place& v)
{
  return std::sqrt(Dot(v, v));
}

// The points of an even grid: the first one of each level, and the steps along both axes.
struct Lattice
{
  Place Steps[2];
  std::vector<SunPoint> Levels;

  Lattice(const ChessboardGrid& grid, const std::vector<SunPoint>& points)
  {
    const int nx = grid.Size[0], ny = grid.Size[1];
    this->Steps[0] = Between(points[0], points[grid.PointNumber(nx - 1, 0, 0)], 1.0 / (nx - 1));
    this->Steps[1] = Between(points[0], points[grid.PointNumber(0, ny - 1, 0)], 1.0 / (ny - 1));
    for (int k = 0; k < grid.Size[2]; ++k)
    {
      this->Levels.push_back(points[grid.PointNumber(0, 0, k)]);
    }
  }

  // Volume of a cell, positive or negative.
  double Volume(int layer) const
  {
    return Dot(
      Cross(this->Steps[0], this->Steps[1]), Between(this->Levels[layer], this->Levels[layer + 1]));
  }

  double ShortestStep() const
  {
    double shortest = std::min(LengthOf(this->Steps[0]), LengthOf(this->Steps[1]));
    for (std::size_t k = 1; k < this->Levels.size(); ++k)
    {
      shortest = std::min(shortest, LengthOf(Between(this->Levels[k - 1], this->Levels[k])));
    }
    return shortest;
  }

  bool IsRegular() const
  {
    const double area = LengthOf(Cross(this->Steps[0], this->Steps[1]));
    bool isRegular = area > 1e-6 * LengthOf(this->Steps[0]) * LengthOf(this->Steps[1]);
    for (int k = 0; k + 1 < int(this->Levels.size()); ++k)
    {
      const double height = LengthOf(Between(this->Levels[k], this->Levels[k + 1]));
      isRegular = isRegular && std::abs(this->Volume(k)) > 1e-6 * area * height &&
        (this->Volume(k) > 0) == (this->Volume(0) > 0);
    }
    return isRegular;
  }

  // How indices change per length along a ray.
  Place Slope(int layer) const
  {
    const Place &a = this->Steps[0], &b = this->Steps[1],
                c = Between(this->Levels[layer], this->Levels[layer + 1]);
    const double volume = this->Volume(layer);
    return { { Cross(b, c)[2] / volume, Cross(c, a)[2] / volume, Cross(a, b)[2] / volume } };
  }
};

template <typename Body>
void ForRows(const ChessboardGrid& grid, Body body)
{
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      body(j, k, grid.PointNumber(0, j, k));
    }
  }
}

// Adds the integral from where the rays are to a face.
void AddStretch(int count, const float* const (&rows)[4], const float (&weights)[4], float half,
  float* __restrict values, double* __restrict depths)
{
  const float *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3];
  const float wa = weights[0], wb = weights[1], wc = weights[2], wd = weights[3];
  for (int i = 0; i < count; ++i)
  {
    const float value = wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i];
    depths[i] += half * (values[i] + value);
    values[i] = value;
  }
}
}

bool EvenRays::Fits(const ChessboardGrid& grid, const std::vector<SunPoint>& points)
{
  if (grid.IsEmpty())
  {
    return false;
  }
  const Lattice lattice(grid, points);
  if (!lattice.IsRegular())
  {
    return false;
  }
  const double tolerance = 1e-4 * lattice.ShortestStep();
  const Place &a = lattice.Steps[0], &b = lattice.Steps[1];
  bool fits = true;
  ForRows(grid, [&](int j, int k, std::int64_t first) {
    const SunPoint& level = lattice.Levels[k];
    for (int i = 0; i < grid.Size[0] && fits; ++i)
    {
      const SunPoint& p = points[first + i];
      fits = std::abs(p.X - level.X - i * a[0] - j * b[0]) <= tolerance &&
        std::abs(p.Y - level.Y - i * a[1] - j * b[1]) <= tolerance &&
        std::abs(p.Z - level.Z - i * a[2] - j * b[2]) <= tolerance;
    }
  });
  return fits;
}

EvenRays::EvenRays(const ChessboardGrid& grid, const std::vector<SunPoint>& points)
  : Grid(grid)
  , Half((grid.Size[0] + 1) / 2)
{
  const Lattice lattice(grid, points);
  for (int layer = 0; layer + 1 < grid.Size[2]; ++layer)
  {
    Place slope = lattice.Slope(layer);
    const double most = std::max({ std::abs(slope[0]), std::abs(slope[1]), std::abs(slope[2]) });
    for (double& one : slope)
    {
      one = std::abs(one) < 1e-12 * most ? 0 : one; // rounding: along a plane of the grid
    }
    this->Slopes.push_back(slope);
  }
  this->SortFields(points);
}

void EvenRays::SortFields(const std::vector<SunPoint>& points)
{
  const std::size_t rows = 2 * std::size_t(this->Grid.Size[1]) * this->Grid.Size[2];
  this->Fields[0].assign(rows * this->Half, 0.0f);
  this->Fields[1] = this->Fields[0];
  this->IsClear.assign(rows, 1);
  this->CloudyLevels = { { this->Grid.Size[2], -1 } };
  ForRows(this->Grid, [&](int j, int k, std::int64_t first) {
    for (int i = 0; i < this->Grid.Size[0]; ++i)
    {
      const std::size_t row = this->RowNumber(i % 2, j, k);
      const nephoscope::Fields& values = points[first + i].Values;
      this->Fields[0][row * this->Half + i / 2] = values[0];
      this->Fields[1][row * this->Half + i / 2] = values[1];
      if (values[0] > 0)
      {
        this->IsClear[row] = 0;
        this->CloudyLevels[0] = std::min(this->CloudyLevels[0], k);
        this->CloudyLevels[1] = std::max(this->CloudyLevels[1], k);
      }
    }
  });
}

// Lengths in a layer at which a ray crosses planes through the points of the grid, and those of the
// faces between even vertices. All faces are in such planes; what they cross beside faces does no
// harm. The last one is the end of the ray in the layer.
std::vector<double> EvenRays::Crossings(
  const Place& at, const Place& slope, int level, bool isOdd) const
{
  double end = std::numeric_limits<double>::max();
  const auto endAt = [&](double distance, double rate) {
    end = rate != 0 ? std::min(end, distance / std::abs(rate)) : end;
  };
  endAt(1, slope[2]);
  endAt(this->Grid.Size[0] - 1 + std::abs(at[0]), slope[0]);
  endAt(this->Grid.Size[1] - 1 + std::abs(at[1]), slope[1]);
  std::vector<double> lengths;
  const auto cross = [&](double value, double rate) { // at whole numbers
    double whole = rate > 0 ? std::floor(value) + 1 : std::ceil(value) - 1;
    for (; rate != 0 && (whole - value) / rate<end; whole += rate> 0 ? 1 : -1)
    {
      lengths.push_back((whole - value) / rate);
    }
  };
  cross(at[0], slope[0]);
  cross(at[1], slope[1]);
  const double height = at[2] - level;
  for (const auto& [x, y, z] :
    { std::array<int, 3>{ 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } })
  {
    cross(0.5 * (x * at[0] + y * at[1] + z * height - int(isOdd)),
      0.5 * (x * slope[0] + y * slope[1] + z * slope[2]));
  }
  std::sort(lengths.begin(), lengths.end());
  lengths.push_back(end);
  return lengths;
}

// The weights of vertices at a place, in the tetrahedron that has `middle` inside.
EvenRays::Face EvenRays::FaceAt(const Place& middle, const Place& at, int level, bool isOdd) const
{
  Place cell, inside, here;
  for (int axis = 0; axis < 3; ++axis)
  {
    cell[axis] = std::floor(middle[axis]);
    inside[axis] = middle[axis] - cell[axis];
    here[axis] = at[axis] - cell[axis];
  }
  cell[2] = std::min(cell[2], this->Grid.Size[2] - 2.0); // along the last level
  inside[2] = middle[2] - cell[2];
  here[2] = at[2] - cell[2];
  Face face;
  int count = 0;
  const auto add = [&](int x, int y, int z, double weight) {
    if (weight > 1e-9 && count < 4)
    {
      Vertex& vertex = face.Vertices[count++];
      vertex.Offset[0] = int(cell[0]) + x;
      vertex.Offset[1] = int(cell[1]) + y;
      vertex.Offset[2] = int(cell[2]) + z;
      vertex.Weight = static_cast<float>(weight);
    }
  };
  const auto distance = [](const Place& place, const int(&corner)[3]) {
    return std::abs(place[0] - corner[0]) + std::abs(place[1] - corner[1]) +
      std::abs(place[2] - corner[2]);
  };
  const int first = int(cell[0]) + int(cell[1]) + int(cell[2]) - level + int(isOdd);
  for (int number = 0; number < 8; ++number)
  {
    const int corner[3] = { number & 1, number >> 1 & 1, number >> 2 & 1 };
    if ((first + corner[0] + corner[1] + corner[2]) % 2 != 0 && distance(inside, corner) < 1)
    {
      count = 0;
      add(corner[0], corner[1], corner[2], 1 - distance(here, corner));
      add(1 - corner[0], corner[1], corner[2], std::abs(here[0] - corner[0]));
      add(corner[0], 1 - corner[1], corner[2], std::abs(here[1] - corner[1]));
      add(corner[0], corner[1], 1 - corner[2], std::abs(here[2] - corner[2]));
      return face;
    }
  }
  for (int number = 0; number < 8; ++number)
  {
    const int even[3] = { number & 1, number >> 1 & 1, number >> 2 & 1 },
              across[3] = { 1 - even[0], 1 - even[1], 1 - even[2] };
    if ((first + even[0] + even[1] + even[2]) % 2 == 0)
    {
      add(even[0], even[1], even[2], 0.5 * (distance(here, across) - 1));
    }
  }
  return face;
}

std::vector<EvenRays::Face> EvenRays::FacesFrom(int level, bool isOdd) const
{
  std::vector<Face> faces(1);
  faces[0].Vertices[0].Offset[2] = level;
  faces[0].Vertices[0].Weight = 1;
  Place at{ { 0, 0, double(level) } };
  for (int k = level;;)
  {
    const int layers = int(this->Slopes.size()),
              forward = this->Slopes[0][2] > 0 ? 1
      : this->Slopes[0][2] < 0                 ? -1
                                               : 0;
    const int layer = forward < 0 ? k - 1 : forward > 0 ? k : std::min(k, layers - 1);
    if (layer < 0 || layer >= layers)
    {
      return faces;
    }
    const Place& slope = this->Slopes[layer];
    const std::vector<double> lengths = this->Crossings(at, slope, level, isOdd);
    double last = 0;
    for (const double length : lengths)
    {
      if (length - last > 1e-12 * lengths.back())
      {
        faces.push_back(
          this->FaceAt(at + (0.5 * (last + length)) * slope, at + length * slope, level, isOdd));
        faces.back().Half = static_cast<float>(0.5 * (length - last));
        last = length;
      }
    }
    at = at + last * slope;
    if (forward == 0 || std::abs(at[0]) > this->Grid.Size[0] ||
      std::abs(at[1]) > this->Grid.Size[1])
    {
      return faces;
    }
    k += forward;
    at[2] = k;
  }
}

bool EvenRays::IsAboveClouds(const Face& face) const
{
  const double forward = this->Slopes[0][2];
  const auto isBeyond = [&](const Vertex& vertex) {
    const int k = vertex.Offset[2];
    return vertex.Weight == 0 || (forward > 0 && k > this->CloudyLevels[1]) ||
      (forward < 0 && k < this->CloudyLevels[0]);
  };
  return std::all_of(face.Vertices.begin(), face.Vertices.end(), isBeyond);
}

// Until the rays leave the grid or the clouds, or are dark.
void EvenRays::Follow(const std::vector<Face>& faces, Span& span) const
{
  int low = 0, high = span.Count - 1; // rays that are still in the grid
  bool wasClear = this->IsClear[this->RowNumber(span.Start % 2, span.Row, span.Level)] != 0;
  for (std::size_t n = 1; n < faces.size() && !this->IsAboveClouds(faces[n - 1]); ++n)
  {
    std::ptrdiff_t starts[4] = { 0, 0, 0, 0 };
    float weights[4] = { 0, 0, 0, 0 };
    bool isClear = true;
    for (int v = 0; v < 4 && faces[n].Vertices[v].Weight > 0; ++v)
    {
      const Vertex& vertex = faces[n].Vertices[v];
      const int i = span.Start + vertex.Offset[0], j = span.Row + vertex.Offset[1];
      low = std::max(low, (1 - i) >> 1);
      high = std::min(high, (this->Grid.Size[0] - 1 - i) >> 1);
      if (low > high || j < 0 || j >= this->Grid.Size[1])
      {
        return;
      }
      const std::size_t row = this->RowNumber(i & 1, j, vertex.Offset[2]);
      starts[v] = std::ptrdiff_t(row * this->Half) + (i >> 1);
      weights[v] = vertex.Weight;
      isClear = isClear && this->IsClear[row] != 0;
    }
    for (int field = 0; field < 2 && !(isClear && wasClear); ++field)
    {
      const float* rows[4];
      for (int v = 0; v < 4; ++v)
      {
        rows[v] = this->Fields[field].data() + (weights[v] > 0 ? starts[v] : starts[0]) + low;
      }
      AddStretch(high - low + 1, rows, weights, faces[n].Half, &span.Values[field][low],
        &span.Depths[field][low]);
    }
    wasClear = isClear;
    const auto begin = span.Depths[1].begin();
    if (n % 16 == 0 &&
      std::all_of(begin + low, begin + high + 1, [](double depth) { return depth > darkDepth; }))
    {
      return;
    }
  }
}

void EvenRays::FindDepths(
  std::int32_t first, std::int32_t last, std::array<double, 2>* depths) const
{
  const int nx = this->Grid.Size[0], ny = this->Grid.Size[1];
  std::array<std::vector<Face>, 2> faces;
  Span span;
  for (std::int32_t p = first, level = -1; p < last;)
  {
    const int i = p % nx, count = std::min(nx - i, last - p);
    span.Row = p / nx % ny;
    span.Level = p / nx / ny;
    if (span.Level != level)
    {
      level = span.Level;
      faces = { { this->FacesFrom(level, false), this->FacesFrom(level, true) } };
    }
    for (int s = 0; s < std::min(2, count); ++s)
    {
      span.Start = i + s;
      span.Count = (count - s + 1) / 2;
      const std::size_t row = this->RowNumber(span.Start % 2, span.Row, level);
      for (int field = 0; field < 2; ++field)
      {
        const auto here = this->Fields[field].begin() + row * this->Half + span.Start / 2;
        span.Values[field].assign(here, here + span.Count);
        span.Depths[field].assign(span.Count, 0.0);
      }
      this->Follow(faces[this->IsOdd(span.Start, span.Row, level)], span);
      for (int t = 0; t < span.Count; ++t)
      {
        depths[p - first + s + 2 * t] = { { span.Depths[0][t], span.Depths[1][t] } };
      }
    }
    p += count;
  }
}
}
