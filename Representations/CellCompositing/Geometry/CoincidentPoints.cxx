// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoincidentPoints.h"

#include "Buckets.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace nephoscope
{
namespace
{
std::size_t HashOfPlace(const CellGeometry::Point& p)
{
  std::uint64_t hash = 0;
  for (const float x : { p.X, p.Y, p.Z })
  {
    const float positive = x + 0.0f; // -0 is at the same place
    std::uint32_t bits;
    std::memcpy(&bits, &positive, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

bool IsPlace(const CellGeometry::Point& p)
{
  return std::isfinite(p.X) && std::isfinite(p.Y) && std::isfinite(p.Z);
}

double LargestCoordinate(const CellGeometry::Point& p)
{
  return std::max({ std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
}

double DistanceBetween(const CellGeometry::Point& p, const CellGeometry::Point& q)
{
  return std::max(
    { std::abs(double(p.X) - q.X), std::abs(double(p.Y) - q.Y), std::abs(double(p.Z) - q.Z) });
}

// Float trigonometry is off by 1.5 units at 360 degrees, and every coordinate by half a unit for
// being moved to the centre.
constexpr double roundingUnits = 4.0 * std::numeric_limits<float>::epsilon();

using Pair = std::pair<std::int32_t, std::int32_t>;

/** Pairs of places that differ by rounding at most, lower number first. */
class NearPlaces
{
public:
  NearPlaces(const CellGeometry& geometry, const std::vector<std::int32_t>& places)
    : Points(geometry.Points)
    , Places(places)
  {
    double largest = 0;
    for (const CellGeometry::Point& p : this->Points)
    {
      largest = IsPlace(p) ? std::max(largest, LargestCoordinate(p)) : largest;
    }
    this->Reach = roundingUnits * largest;
    this->BoxSize = 64 * this->Reach; // few points reach into a second box
  }

  bool Find(std::vector<Pair>& pairs, const Progress& progress)
  {
    const std::size_t size = std::max<std::size_t>(this->Points.size(), 1);
    Buckets<std::int32_t> buckets;
    vtkSMPThreadLocal<std::vector<Pair>> found;
    const bool done = this->Reach > 0 &&
      buckets.Fill(this->Points.size(), size, progress.Part(0, 0.6),
        [&](std::size_t i, auto add) { this->AddToBoxes(i, size, add); }) &&
      buckets.ForEach(progress.Part(0.6, 1), [&](std::int32_t* begin, std::int32_t* end) {
        this->FindInBox(begin, end, found.Local());
      });
    for (const std::vector<Pair>& part : found)
    {
      pairs.insert(pairs.end(), part.begin(), part.end());
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return done || this->Reach <= 0;
  }

private:
  template <typename Add>
  void AddToBoxes(std::size_t i, std::size_t size, Add add) const
  {
    const CellGeometry::Point& p = this->Points[i];
    if (this->Places[i] != static_cast<std::int32_t>(i) || !IsPlace(p))
    {
      return;
    }
    const float x[3] = { p.X, p.Y, p.Z };
    std::int64_t low[3], high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] =
        static_cast<std::int64_t>(std::floor((double(x[axis]) - this->Reach) / this->BoxSize));
      high[axis] =
        static_cast<std::int64_t>(std::floor((double(x[axis]) + this->Reach) / this->BoxSize));
    }
    std::int64_t box[3];
    for (box[0] = low[0]; box[0] <= high[0]; ++box[0])
    {
      for (box[1] = low[1]; box[1] <= high[1]; ++box[1])
      {
        for (box[2] = low[2]; box[2] <= high[2]; ++box[2])
        {
          const CellGeometry::Point corner = { float(box[0]), float(box[1]), float(box[2]), 0 };
          add(HashOfPlace(corner) % size, static_cast<std::int32_t>(i));
        }
      }
    }
  }

  void FindInBox(std::int32_t* begin, std::int32_t* end, std::vector<Pair>& pairs) const
  {
    // Where so many lie together, all is smaller than rounding, and nothing is gained.
    constexpr std::ptrdiff_t crowd = 256;
    if (end - begin < 2 || end - begin > crowd)
    {
      return;
    }
    for (const std::int32_t* a = begin; a != end; ++a)
    {
      for (const std::int32_t* b = begin; b != end; ++b)
      {
        const CellGeometry::Point& p = this->Points[static_cast<std::size_t>(*a)];
        const CellGeometry::Point& q = this->Points[static_cast<std::size_t>(*b)];
        if (*a < *b && DistanceBetween(p, q) <= this->Reach)
        {
          pairs.emplace_back(*a, *b);
        }
      }
    }
  }

  const std::vector<CellGeometry::Point>& Points;
  const std::vector<std::int32_t>& Places;
  double Reach, BoxSize; // Reach: what rounding may be
};

/** At each place of a pair: the shortest edge that is longer than nothing. */
bool FindShortestEdges(const CellGeometry& geometry, const std::vector<std::int32_t>& places,
  const std::vector<Pair>& pairs, std::vector<float>& shortest, const Progress& progress)
{
  shortest.assign(places.size(), -1.0f); // not asked for
  for (const Pair& pair : pairs)
  {
    shortest[static_cast<std::size_t>(pair.first)] =
      shortest[static_cast<std::size_t>(pair.second)] = std::numeric_limits<float>::max();
  }
  const auto visit = [&](const auto& vertices) {
    for (const std::int32_t vertex : vertices)
    {
      const std::int32_t place = places[static_cast<std::size_t>(vertex)];
      float& length = shortest[static_cast<std::size_t>(place)];
      if (length < 0)
      {
        continue;
      }
      for (const std::int32_t other : vertices)
      {
        const float distance =
          static_cast<float>(DistanceBetween(geometry.Points[static_cast<std::size_t>(vertex)],
            geometry.Points[static_cast<std::size_t>(other)]));
        length = distance > 0 ? std::min(length, distance) : length;
      }
    }
  };
  return ForEachInTurn(geometry.Tetrahedra.size(), progress.Part(0, 0.5),
           [&](std::size_t i) { visit(geometry.Tetrahedra[i]); }) &&
    ForEachInTurn(geometry.Hexahedra.size(), progress.Part(0.5, 1),
      [&](std::size_t i) { visit(geometry.Hexahedra[i]); });
}

/** Joins numbers to groups, each under its lowest number. */
std::int32_t FindRoot(std::vector<std::int32_t>& parents, std::int32_t i)
{
  while (parents[static_cast<std::size_t>(i)] != i)
  {
    std::int32_t& parent = parents[static_cast<std::size_t>(i)];
    i = parent = parents[static_cast<std::size_t>(parent)];
  }
  return i;
}
}

std::vector<std::int32_t> FindPlaces(const CellGeometry& geometry, const Progress& progress)
{
  const auto& points = geometry.Points;
  const auto place = [&points](std::int32_t i) {
    const CellGeometry::Point& p = points[static_cast<std::size_t>(i)];
    return std::tie(p.X, p.Y, p.Z);
  };
  std::vector<std::int32_t> places(points.size());
  std::iota(places.begin(), places.end(), 0);
  Buckets<std::int32_t> buckets;
  const std::size_t size = std::max<std::size_t>(points.size(), 1);
  const bool done = buckets.Fill(points.size(), size, progress.Part(0, 0.5),
                      [&](std::size_t i, auto add) {
                        const CellGeometry::Point& p = points[i];
                        if (p.X == p.X && p.Y == p.Y &&
                          p.Z == p.Z) // NaN has no place in an order, and is in no tetrahedron
                        {
                          add(HashOfPlace(p) % size, static_cast<std::int32_t>(i));
                        }
                      }) &&
    buckets.ForEach(progress.Part(0.5, 1), [&](std::int32_t* begin, std::int32_t* end) {
      std::sort(begin, end, [&](std::int32_t a, std::int32_t b) {
        return std::tuple_cat(place(a), std::tie(a)) < std::tuple_cat(place(b), std::tie(b));
      });
      for (std::int32_t* i = begin; i != end && i + 1 != end; ++i)
      {
        if (place(i[0]) == place(i[1]))
        {
          places[static_cast<std::size_t>(i[1])] = places[static_cast<std::size_t>(i[0])];
        }
      }
    });
  if (!done)
  {
    places.clear();
  }
  return places;
}

bool WeldPlaces(
  const CellGeometry& geometry, std::vector<std::int32_t>& places, const Progress& progress)
{
  std::vector<Pair> pairs;
  std::vector<float> shortest;
  if (!NearPlaces(geometry, places).Find(pairs, progress.Part(0, 0.8)))
  {
    return false;
  }
  if (pairs.empty())
  {
    return true;
  }
  if (!FindShortestEdges(geometry, places, pairs, shortest, progress.Part(0.8, 0.95)))
  {
    return false;
  }
  for (const Pair& pair : pairs)
  {
    const std::size_t a = static_cast<std::size_t>(pair.first),
                      b = static_cast<std::size_t>(pair.second);
    if (8 * DistanceBetween(geometry.Points[a], geometry.Points[b]) <=
      std::min(shortest[a], shortest[b]))
    {
      const std::int32_t first = FindRoot(places, pair.first),
                         second = FindRoot(places, pair.second);
      places[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] = FindRoot(places, static_cast<std::int32_t>(i));
  }
  return progress.Report(1);
}

} // namespace nephoscope
