// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A polygonal face cut into triangles, identically for both of its cells.
 *
 * 1. The canonical cycle: of all starting vertices and both directions, the one whose sequence of
 *    vertices is least in the order of coordinates. Both cells get the same result, and all further
 *    steps depend only on it, to the last bit.
 * 2. The fan from its first, least vertex, which is how the mapper and CellDecomposition.h cut a
 *    face, if every triangle has an area and looks the way the face does.
 * 3. Else (a face that is not convex, or with a vertex in the middle of an edge) ears are cut off:
 *    each time the ear whose smallest height is largest, so that no triangle is thinner than it
 *    must be (Meisters1975 shows that there always is an ear).
 *    Faces with holes come as one cycle that runs through a bridge to the hole and back.
 * 4. Else, if the face is so warped that it crosses itself when it is pressed flat, the triangles
 *    of least area in space (BarequetSharir1995).
 *
 * Vertices are compared and measured in the plane of the face's area-weighted mean normal.
 */
#ifndef nephoscope_FaceTriangulation_h
#define nephoscope_FaceTriangulation_h

#include "Tetrahedron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nephoscope
{

using Triangle = std::array<int, 3>;

class FaceTriangulation
{
public:
  /**
   * `face`: vertices by rank in the order of coordinates; `position(vertex)`: coordinates.
   * Triangles are wound as the face is.
   * Returns false where the face crosses itself, or has no area.
   */
  template <typename Position>
  bool Cut(const int* face, int size, Position position)
  {
    this->Triangles.clear();
    const bool reversed = this->MakeCanonical(face, size);
    if (!this->Project(position) || !(this->TryFan() || this->CutEars() || this->CutSmallest()))
    {
      this->Triangles.clear();
      return false;
    }
    if (reversed)
    {
      for (Triangle& t : this->Triangles)
      {
        std::swap(t[1], t[2]);
      }
    }
    return true;
  }

  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  bool IsFan() const { return this->Fan; }

private:
  using Place = std::array<double, 2>;
  // A triangle below this part of the face's area has none.
  static constexpr double smallestArea = 1e-9;
  // A face that crosses itself is an error unless it is warped by more than this part of the root
  // of its area.
  static constexpr double smallestWarp = 1e-3;

  // Returns whether the canonical direction is against the face's own.
  bool MakeCanonical(const int* face, int size)
  {
    const int least = *std::min_element(face, face + size);
    this->Cycle.clear();
    bool reversed = false;
    std::vector<int> candidate(static_cast<std::size_t>(size));
    for (int start = 0; start < size; ++start)
    {
      for (int step = -1; face[start] == least && step <= 1; step += 2)
      {
        for (int k = 0; k < size; ++k)
        {
          candidate[static_cast<std::size_t>(k)] = face[(start + step * k + size) % size];
        }
        if (this->Cycle.empty() || candidate < this->Cycle)
        {
          this->Cycle = candidate;
          reversed = step < 0;
        }
      }
    }
    return reversed;
  }

  template <typename Position>
  bool Project(Position position)
  {
    const std::size_t n = this->Cycle.size();
    std::vector<Vector3>& relative = this->Relative;
    relative.resize(n);
    Vector3 normal{ { 0, 0, 0 } };
    for (std::size_t k = 0; k < n; ++k)
    {
      relative[k] = Difference(position(this->Cycle[k]), position(this->Cycle[0]));
    }
    for (std::size_t k = 0; k < n; ++k)
    {
      const Vector3 twice = Cross(relative[k], relative[(k + 1) % n]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        normal[axis] += twice[axis];
      }
    }
    this->TwiceArea = std::sqrt(Dot(normal, normal));
    if (!(this->TwiceArea > 0))
    {
      return false;
    }
    // Two axes that complete the normal; the first is across its smallest component.
    std::size_t smallest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
    {
      smallest = std::abs(normal[axis]) < std::abs(normal[smallest]) ? axis : smallest;
    }
    Vector3 unit{ { 0, 0, 0 } };
    unit[smallest] = 1;
    Vector3 u = Cross(unit, normal);
    const double length = std::sqrt(Dot(u, u));
    u = { { u[0] / length, u[1] / length, u[2] / length } };
    const Vector3 across = Cross(normal, u);
    const Vector3 v{ { across[0] / this->TwiceArea, across[1] / this->TwiceArea,
      across[2] / this->TwiceArea } };
    this->Places.resize(n);
    double low = 0, high = 0; // above the first vertex
    for (std::size_t k = 0; k < n; ++k)
    {
      const double height = Dot(relative[k], normal) / this->TwiceArea;
      low = std::min(low, height);
      high = std::max(high, height);
      this->Places[k] = { { Dot(relative[k], u), Dot(relative[k], v) } };
    }
    this->Warp = high - low;
    return true;
  }

  // Dynamic programming: Best[i][j] is the least area over the vertices i ... j, Middle[i][j] the
  // third vertex of the triangle at (i, j).
  bool CutSmallest()
  {
    this->Triangles.clear();
    if (this->Warp < smallestWarp * std::sqrt(this->TwiceArea))
    {
      return false;
    }
    const std::size_t n = this->Cycle.size();
    std::vector<std::vector<double>> best(n, std::vector<double>(n, 0.0));
    std::vector<std::vector<std::size_t>> middle(n, std::vector<std::size_t>(n, 0));
    for (std::size_t span = 2; span < n; ++span)
    {
      for (std::size_t i = 0; i + span < n; ++i)
      {
        const std::size_t j = i + span;
        best[i][j] = 1e300;
        for (std::size_t k = i + 1; k < j; ++k)
        {
          const double area = best[i][k] + best[k][j] + this->AreaInSpace(i, k, j);
          middle[i][j] = area < best[i][j] ? k : middle[i][j];
          best[i][j] = std::min(area, best[i][j]);
        }
      }
    }
    std::vector<std::array<std::size_t, 2>> left = { { { 0, n - 1 } } };
    while (!left.empty())
    {
      const auto [i, j] = left.back();
      left.pop_back();
      if (j - i < 2)
      {
        continue;
      }
      const std::size_t k = middle[i][j];
      this->Triangles.push_back({ { this->Cycle[i], this->Cycle[k], this->Cycle[j] } });
      left.push_back({ { i, k } });
      left.push_back({ { k, j } });
    }
    return true;
  }

  double AreaInSpace(std::size_t a, std::size_t b, std::size_t c) const
  {
    const Vector3 twice = Cross(Difference(this->Relative[b], this->Relative[a]),
      Difference(this->Relative[c], this->Relative[a]));
    return std::sqrt(Dot(twice, twice));
  }

  // Twice the area of three corners of the cycle, positive where they run as the face does.
  double Area(std::size_t a, std::size_t b, std::size_t c) const
  {
    const Place &p = this->Places[a], &q = this->Places[b], &r = this->Places[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  bool TryFan()
  {
    const std::size_t n = this->Cycle.size();
    this->Fan = true;
    for (std::size_t k = 1; k + 1 < n && this->Fan; ++k)
    {
      this->Fan = this->Area(0, k, k + 1) > smallestArea * this->TwiceArea;
    }
    for (std::size_t k = 1; k + 1 < n && this->Fan; ++k)
    {
      this->Triangles.push_back({ { this->Cycle[0], this->Cycle[k], this->Cycle[k + 1] } });
    }
    return this->Fan;
  }

  bool CutEars()
  {
    std::vector<std::size_t> rest(this->Cycle.size());
    for (std::size_t k = 0; k < rest.size(); ++k)
    {
      rest[k] = k;
    }
    while (rest.size() >= 3)
    {
      std::size_t best = rest.size();
      double bestHeight = 0;
      for (std::size_t k = 0; k < rest.size(); ++k)
      {
        const double height = this->EarHeight(rest, k);
        if (height > bestHeight)
        {
          best = k;
          bestHeight = height;
        }
      }
      if (best == rest.size())
      {
        return false;
      }
      const std::size_t n = rest.size();
      this->Triangles.push_back({ { this->Cycle[rest[(best + n - 1) % n]], this->Cycle[rest[best]],
        this->Cycle[rest[(best + 1) % n]] } });
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
      if (rest.size() == 2)
      {
        return true;
      }
    }
    return false;
  }

  // The smallest height of the triangle at a corner; 0 if it is no ear.
  double EarHeight(const std::vector<std::size_t>& rest, std::size_t k) const
  {
    const std::size_t n = rest.size();
    const std::size_t a = rest[(k + n - 1) % n], b = rest[k], c = rest[(k + 1) % n];
    const double area = this->Area(a, b, c);
    if (!(area > smallestArea * this->TwiceArea))
    {
      return 0;
    }
    for (const std::size_t other : rest)
    {
      const int vertex = this->Cycle[other];
      if (vertex != this->Cycle[a] && vertex != this->Cycle[b] && vertex != this->Cycle[c] &&
        this->Covers(a, b, c, other))
      {
        return 0;
      }
    }
    return area /
      std::sqrt(std::max({ this->Length2(a, b), this->Length2(b, c), this->Length2(c, a) }));
  }

  bool Covers(std::size_t a, std::size_t b, std::size_t c, std::size_t x) const
  {
    const double zero = -smallestArea * this->TwiceArea;
    return this->Area(a, b, x) >= zero && this->Area(b, c, x) >= zero &&
      this->Area(c, a, x) >= zero;
  }

  double Length2(std::size_t a, std::size_t b) const
  {
    const double x = this->Places[b][0] - this->Places[a][0],
                 y = this->Places[b][1] - this->Places[a][1];
    return x * x + y * y;
  }

  std::vector<int> Cycle;
  std::vector<Place> Places;
  std::vector<Vector3> Relative; ///< to the first vertex
  double TwiceArea = 0;
  double Warp = 0;
  bool Fan = false;
  std::vector<Triangle> Triangles;
};

} // namespace nephoscope

#endif
