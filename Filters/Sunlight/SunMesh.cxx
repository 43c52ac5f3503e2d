// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunMesh.h"

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace nephoscope
{
namespace
{
using Place = SunMesh::Place;

struct Face
{
  std::array<std::int32_t, 3> Points; // ascending
  std::int32_t Tetrahedron, Vertex;
};

constexpr std::int32_t none = -1;

// Which of the tetrahedra at odd corners of the cell beyond the face along an axis has the same odd point.
int mirrored(const std::array<int, 3>& corner, int axis)
{
  const int bits = (corner[0] | corner[1] << 1 | corner[2] << 2) ^ 1 << axis;
  const int order[8] = { 0, 0, 1, 1, 2, 2, 3, 3 }; // of 0, 3, 5, 6 and of 1, 2, 4, 7
  return order[bits];
}

Face faceOf(const SunMesh::Tetrahedron& t, std::int32_t number, int vertex)
{
  Face face{ { t[(vertex + 1) % 4], t[(vertex + 2) % 4], t[(vertex + 3) % 4] }, number, vertex };
  std::sort(face.Points.begin(), face.Points.end());
  return face;
}

// Twice the area of the triangle of the ray and two points, by their distances from it.
double area(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}
}

struct SunMesh::Ray
{
  double X, Y, Z;
  std::int32_t Inside = -1;           // the tetrahedron being left
  int Vertex = -1;                    // across from the face where it is left
  std::array<std::int32_t, 3> Face{}; // its points
  std::array<double, 3> Weights{};    // of its points, where the ray passes
  std::array<double, 2> Depths{ { 0, 0 } };

  std::array<double, 2> Beside(const Place& p) const { return { p[0] - this->X, p[1] - this->Y }; }

  // Weights of the points where the ray passes; false if it passes beside.
  bool Meet(const std::vector<Place>& places, const std::array<std::int32_t, 3>& face)
  {
    const auto a = this->Beside(places[face[0]]), b = this->Beside(places[face[1]]),
               c = this->Beside(places[face[2]]);
    const std::array<double, 3> parts = { area(b, c), area(c, a), area(a, b) };
    const double sum = parts[0] + parts[1] + parts[2];
    const bool inside = sum > 0 ? parts[0] >= 0 && parts[1] >= 0 && parts[2] >= 0
                                : parts[0] <= 0 && parts[1] <= 0 && parts[2] <= 0;
    if (!inside || sum == 0)
    {
      return false;
    }
    this->Face = face;
    this->Weights = { parts[0] / sum, parts[1] / sum, parts[2] / sum };
    return true;
  }

  double Height(const std::vector<Place>& places) const
  {
    return this->Weights[0] * places[this->Face[0]][2] +
      this->Weights[1] * places[this->Face[1]][2] + this->Weights[2] * places[this->Face[2]][2];
  }

  std::array<double, 2> Values(const std::vector<std::array<float, 2>>& fields) const
  {
    std::array<double, 2> values{ { 0, 0 } };
    for (int k = 0; k < 3; ++k)
    {
      values[0] += this->Weights[k] * fields[this->Face[k]][0];
      values[1] += this->Weights[k] * fields[this->Face[k]][1];
    }
    return values;
  }

  void Add(const std::array<double, 2>& before, const std::array<double, 2>& after, double length)
  {
    this->Depths[0] += 0.5 * (before[0] + after[0]) * length;
    this->Depths[1] += 0.5 * (before[1] + after[1]) * length;
  }
};

SunMesh::SunMesh(std::vector<Tetrahedron> tetrahedra, std::size_t numberOfPoints,
  const ChessboardGrid& grid, const Loop& loop)
  : Tetrahedra(std::move(tetrahedra))
  , Neighbours(this->Tetrahedra.size(), { { none, none, none, none } })
{
  if (!grid.IsEmpty())
  {
    this->FindNeighboursInGrid(grid, loop);
  }
  this->FindOtherNeighbours(numberOfPoints);
  this->FindTetrahedraOfPoints(numberOfPoints);
}

// With a vertex twice.
bool SunMesh::IsFlat(std::size_t tetrahedron) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
    t[2] == t[3];
}

// The tetrahedron between even corners borders on those at the odd ones; these on those at the same odd point in the next cells.
void SunMesh::FindNeighboursInGrid(const ChessboardGrid& grid, const Loop& loop)
{
  const std::int64_t steps[3] = { 1, grid.Size[0] - 1,
    std::int64_t(grid.Size[0] - 1) * (grid.Size[1] - 1) };
  const auto join = [this](std::int64_t from, int vertex, std::int64_t to) {
    if (!this->IsFlat(from) && !this->IsFlat(to))
    {
      this->Neighbours[from][vertex] = static_cast<std::int32_t>(to);
    }
  };
  const auto joinCell = [&](std::int64_t cell) {
    const auto index = grid.CellIndex(cell);
    const auto corners = grid.CornerTetrahedra(index);
    for (int k = 0; k < 4; ++k)
    {
      const std::int64_t own = ChessboardGrid::TetrahedraPerCell * cell + k + 1;
      join(own, 0, own - k - 1);
      join(own - k - 1, 3 - k,
        own); // corners ascend: the odd one is across from the even one counted from the other end
      for (int axis = 0; axis < 3; ++axis)
      {
        const int next = index[axis] + (corners[k].Corner[axis] ? 1 : -1);
        if (next >= 0 && next < grid.Size[axis] - 1)
        {
          const std::int64_t other = cell + (next - index[axis]) * steps[axis];
          join(own, axis + 1,
            ChessboardGrid::TetrahedraPerCell * other + 1 + mirrored(corners[k].Corner, axis));
        }
      }
    }
  };
  loop(grid.NumberOfCells(), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t cell = begin; cell < end; ++cell)
    {
      joinCell(cell);
    }
  });
}

// Faces sorted by their least point by counting, then compared with the few others of that point.
void SunMesh::FindOtherNeighbours(std::size_t numberOfPoints)
{
  std::vector<Face> found;
  for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
  {
    for (int v = 0; v < 4; ++v)
    {
      if (this->Neighbours[t][v] == none && !this->IsFlat(t))
      {
        found.push_back(faceOf(this->Tetrahedra[t], static_cast<std::int32_t>(t), v));
      }
    }
  }
  std::vector<std::int32_t> first(numberOfPoints + 1, 0);
  for (const Face& face : found)
  {
    ++first[face.Points[0] + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Face> faces(found.size());
  std::vector<std::int32_t> place(first.begin(), first.end() - 1);
  for (const Face& face : found)
  {
    faces[place[face.Points[0]]++] = face;
  }
  for (std::size_t p = 0; p < numberOfPoints; ++p)
  {
    std::sort(faces.begin() + first[p], faces.begin() + first[p + 1],
      [](const Face& a, const Face& b) { return a.Points < b.Points; });
  }
  for (std::size_t f = 0; f + 1 < faces.size(); ++f)
  {
    if (faces[f].Points == faces[f + 1].Points)
    {
      this->Neighbours[faces[f].Tetrahedron][faces[f].Vertex] = faces[f + 1].Tetrahedron;
      this->Neighbours[faces[f + 1].Tetrahedron][faces[f + 1].Vertex] = faces[f].Tetrahedron;
    }
  }
}

void SunMesh::FindTetrahedraOfPoints(std::size_t numberOfPoints)
{
  std::vector<bool> flat(this->Tetrahedra.size());
  this->First.assign(numberOfPoints + 1, 0);
  for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
  {
    flat[t] = this->IsFlat(t);
    for (const std::int32_t p : this->Tetrahedra[t])
    {
      this->First[p + 1] += flat[t] ? 0 : 1;
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  this->OfPoint.resize(this->First.back());
  std::vector<std::int32_t> place(this->First.begin(), this->First.end() - 1);
  for (std::size_t t = 0; t < this->Tetrahedra.size(); ++t)
  {
    for (const std::int32_t p : this->Tetrahedra[t])
    {
      if (!flat[t])
      {
        this->OfPoint[place[p]++] = static_cast<std::int32_t>(t);
      }
    }
  }
}

void SunMesh::Turn(const std::vector<Place>& places, const Place& towardsSun)
{
  const Place helper = std::abs(towardsSun[2]) < 0.9 ? Place{ { 0, 0, 1 } } : Place{ { 1, 0, 0 } };
  Place x = cross(helper, towardsSun);
  const double length = std::sqrt(dot(x, x));
  x = { x[0] / length, x[1] / length, x[2] / length };
  const Place y = cross(towardsSun, x);
  this->Up = { { x[2], y[2], towardsSun[2] } };
  this->Places.resize(places.size());
  std::transform(places.begin(), places.end(), this->Places.begin(), [&](const Place& p) {
    return Place{ { dot(p, x), dot(p, y), dot(p, towardsSun) } };
  });
}

double SunMesh::HeightOf(const Place& place) const
{
  return this->OnGlobe ? std::sqrt(dot(place, place)) : dot(place, this->Up);
}

void SunMesh::FindCeiling(const std::vector<std::array<float, 2>>& fields, bool onGlobe)
{
  this->OnGlobe = onGlobe;
  this->Ceiling = -std::numeric_limits<double>::max();
  for (const Tetrahedron& t : this->Tetrahedra)
  {
    if (fields[t[0]][0] + fields[t[1]][0] + fields[t[2]][0] + fields[t[3]][0] > 0)
    {
      for (const std::int32_t p : t)
      {
        this->Ceiling = std::max(this->Ceiling, this->HeightOf(this->Places[p]));
      }
    }
  }
}

// Where the way goes above the ceiling for good.
double SunMesh::EndOfWay(double x, double y) const
{
  constexpr double never = std::numeric_limits<double>::max();
  if (this->OnGlobe)
  {
    const double rest = this->Ceiling * this->Ceiling - x * x - y * y;
    return this->Ceiling > 0 && rest > 0 ? std::sqrt(rest) : -never;
  }
  const double height = x * this->Up[0] + y * this->Up[1];
  return this->Up[2] > 0 ? (this->Ceiling - height) / this->Up[2] : never;
}

// The ray passes a little beside the point, since columns of grids often lie in its direction: by a billionth of an edge, to one side or, at the
// boundary of the mesh, to another.
bool SunMesh::Start(Ray& ray, std::int32_t point) const
{
  static const double sides[4][2] = { { 0.85, 0.53 }, { -0.53, 0.85 }, { -0.85, -0.53 },
    { 0.53, -0.85 } };
  const Place& place = this->Places[point];
  double size = 0;
  for (std::int32_t k = this->First[point]; k < this->First[point + 1]; ++k)
  {
    for (const std::int32_t p : this->Tetrahedra[this->OfPoint[k]])
    {
      size = std::max(
        size, std::abs(this->Places[p][0] - place[0]) + std::abs(this->Places[p][1] - place[1]));
    }
  }
  for (const auto& side : sides)
  {
    ray.X = place[0] + 1e-9 * size * side[0];
    ray.Y = place[1] + 1e-9 * size * side[1];
    ray.Z = place[2];
    for (std::int32_t k = this->First[point]; k < this->First[point + 1]; ++k)
    {
      const std::int32_t number = this->OfPoint[k];
      const Tetrahedron& t = this->Tetrahedra[number];
      const int v = static_cast<int>(std::find(t.begin(), t.end(), point) - t.begin());
      if (ray.Meet(this->Places, { { t[(v + 1) % 4], t[(v + 2) % 4], t[(v + 3) % 4] } }) &&
        ray.Height(this->Places) > ray.Z)
      {
        ray.Inside = number;
        ray.Vertex = v;
        return true;
      }
    }
  }
  return false;
}

void SunMesh::Walk(Ray& ray, const std::vector<std::array<float, 2>>& fields) const
{
  std::array<double, 2> before = ray.Values(fields);
  double z = ray.Height(this->Places);
  const double end = this->EndOfWay(ray.X, ray.Y);
  for (std::size_t steps = 0; steps < this->Tetrahedra.size() && z < end; ++steps)
  {
    const std::int32_t next = this->Neighbours[ray.Inside][ray.Vertex];
    if (next < 0)
    {
      return;
    }
    const Tetrahedron& t = this->Tetrahedra[next];
    const auto entered = ray.Face;
    bool found = false;
    for (int v = 0; v < 4 && !found; ++v)
    {
      const bool isAhead = std::find(entered.begin(), entered.end(), t[v]) != entered.end();
      if (isAhead && ray.Meet(this->Places, { { t[(v + 1) % 4], t[(v + 2) % 4], t[(v + 3) % 4] } }))
      {
        ray.Inside = next;
        ray.Vertex = v;
        found = true;
      }
    }
    if (!found)
    {
      return;
    }
    const std::array<double, 2> after = ray.Values(fields);
    const double height = ray.Height(this->Places);
    ray.Add(before, after, height - z);
    before = after;
    z = height;
  }
}

std::array<double, 2> SunMesh::DepthsFrom(
  std::int32_t point, const std::vector<std::array<float, 2>>& fields) const
{
  Ray ray;
  const Place& place = this->Places[point];
  if (place[2] >= this->EndOfWay(place[0], place[1]) || !this->Start(ray, point))
  {
    return { { 0, 0 } };
  }
  const std::array<double, 2> here = { { fields[point][0], fields[point][1] } };
  ray.Add(here, ray.Values(fields), ray.Height(this->Places) - ray.Z);
  this->Walk(ray, fields);
  return { { std::max(ray.Depths[0], 0.0), std::max(ray.Depths[1], 0.0) } };
}

std::vector<std::int32_t> mergedPoints(const std::vector<SunMesh::Place>& places)
{
  double largest = 0;
  for (const Place& p : places)
  {
    for (const double x : p)
    {
      largest = std::isfinite(x) ? std::max(largest, std::abs(x)) : largest;
    }
  }
  const double step = std::max(largest, 1e-300) * 1e-9;
  std::size_t size = 1024;
  while (size < 2 * places.size())
  {
    size *= 2;
  }
  std::vector<std::int32_t> heads(size, none), next(places.size(), none), merged(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::uint64_t key = 0;
    for (const double x : places[i])
    {
      key = (key ^ static_cast<std::uint64_t>(std::isfinite(x) ? std::llround(x / step) : 0)) *
        0x9E3779B97F4A7C15ull;
      key ^= key >> 32;
    }
    std::int32_t& head = heads[key & (size - 1)];
    std::int32_t j = head;
    while (j != none &&
      !(std::abs(places[j][0] - places[i][0]) + std::abs(places[j][1] - places[i][1]) +
          std::abs(places[j][2] - places[i][2]) <=
        3 * step))
    {
      j = next[j];
    }
    merged[i] = j == none ? static_cast<std::int32_t>(i) : j;
    if (j == none)
    {
      next[i] = head;
      head = static_cast<std::int32_t>(i);
    }
  }
  return merged;
}
}
