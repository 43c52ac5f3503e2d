// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The edges of a set of triangles, by sorting. Plain C++17.
#ifndef nephoscope_TriangleEdges_h
#define nephoscope_TriangleEdges_h

#include "TriangleDivision.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace nephoscope
{
struct TriangleEdges
{
  std::vector<std::array<PointId, 2>> Points; // smaller number first; sorted
  std::vector<unsigned char> Uses;            // by how many triangles; 1 on the boundary
  std::vector<std::array<std::size_t, 3>>
    Of; // of every triangle, from its vertex i to vertex i + 1

  // `corners(t)` gives the three points of triangle t, numbers below 2^32.
  template <typename Corners>
  void Build(std::size_t numberOfTriangles, const Corners& corners)
  {
    this->Sorted.clear();
    for (std::size_t t = 0; t < numberOfTriangles; ++t)
    {
      const TrianglePoints& points = corners(t);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto pair = std::minmax(points[i], points[(i + 1) % 3]);
        const auto key =
          (static_cast<std::uint64_t>(pair.first) << 32) | static_cast<std::uint64_t>(pair.second);
        this->Sorted.emplace_back(key, 3 * t + i);
      }
    }
    std::sort(this->Sorted.begin(), this->Sorted.end());
    this->Number(numberOfTriangles);
  }

  std::size_t Size() const { return this->Points.size(); }

private:
  void Number(std::size_t numberOfTriangles)
  {
    this->Points.clear();
    this->Uses.clear();
    this->Of.resize(numberOfTriangles);
    std::uint64_t last = 0;
    for (const auto& entry : this->Sorted)
    {
      if (this->Points.empty() || entry.first != last)
      {
        last = entry.first;
        this->Points.push_back(
          { { static_cast<PointId>(last >> 32), static_cast<PointId>(last & 0xffffffffu) } });
        this->Uses.push_back(0);
      }
      this->Uses.back() = static_cast<unsigned char>(std::min(3, this->Uses.back() + 1));
      this->Of[entry.second / 3][entry.second % 3] = this->Points.size() - 1;
    }
  }

  std::vector<std::pair<std::uint64_t, std::size_t>> Sorted;
};
}

#endif
