// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibilityOrder.h"

#include "Buckets.h"
#include "OrderRelations.h"
#include "StrongComponents.h"

#include <algorithm>
#include <numeric>

namespace nephoscope
{
namespace
{
/** Sort key of a centroid: larger is farther. */
float farness(const CellGeometry& geometry, std::size_t i, const Vector4& eye)
{
  const std::array<Vector3, 4> p = geometry.Vertices(i);
  Vector3 centroid = { 0, 0, 0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    centroid[axis] = 0.25 * (p[0][axis] + p[1][axis] + p[2][axis] + p[3][axis]);
  }
  const Vector3 e = { eye[0], eye[1], eye[2] };
  if (eye[3] == 0.0)
  {
    return static_cast<float>(-dot(centroid, e));
  }
  const Vector3 d = difference(centroid, e);
  return static_cast<float>(dot(d, d));
}

/** A cycle: where its members lie in the order. */
struct Cycle
{
  std::size_t First, Last;
};

/** Writes the members of cycles, and their pieces, in the order in which they must be drawn. */
class CycleOrder
{
public:
  CycleOrder(const OrderRelations& relations, const StrongComponents& components)
    : Relations(relations)
    , Components(components)
  {
  }

  bool Resolve(const std::vector<Cycle>& cycles, CycleSplitter& splitter,
    VisibilityOrder::Sorted& sorted, const Progress& progress)
  {
    std::vector<std::int32_t> order;
    std::size_t copied = 0;
    for (std::size_t i = 0; i < cycles.size(); ++i)
    {
      const auto begin = sorted.Order.begin();
      order.insert(
        order.end(), begin + std::ptrdiff_t(copied), begin + std::ptrdiff_t(cycles[i].First));
      copied = cycles[i].Last;
      std::vector<std::int32_t> members(
        begin + std::ptrdiff_t(cycles[i].First), begin + std::ptrdiff_t(copied));
      std::sort(members.begin(), members.end());
      const double n = static_cast<double>(cycles.size());
      if (!splitter.Append(members, this->RelationsAmong(members), sorted.Pieces, order,
            progress.Part(static_cast<double>(i) / n, static_cast<double>(i + 1) / n)))
      {
        return false;
      }
      sorted.NumberOfCyclicTetrahedra += static_cast<std::int64_t>(members.size());
    }
    order.insert(order.end(), sorted.Order.begin() + std::ptrdiff_t(copied), sorted.Order.end());
    sorted.Order.swap(order);
    sorted.NumberOfCycles = static_cast<std::int64_t>(cycles.size());
    sorted.NumberOfBrokenRelations = splitter.GetNumberOfBrokenRelations();
    return true;
  }

private:
  std::vector<CycleSplitter::Relation> RelationsAmong(
    const std::vector<std::int32_t>& members) const
  {
    std::vector<CycleSplitter::Relation> result;
    for (std::size_t i = 0; i < members.size(); ++i)
    {
      std::int32_t cursor = 0, opposite = 0, behind;
      while ((behind = this->Relations.Next(members[i], cursor, opposite)) >= 0)
      {
        if (this->Components.GetComponent(behind) == this->Components.GetComponent(members[i]))
        {
          const auto place = std::lower_bound(members.begin(), members.end(), behind);
          result.push_back({ static_cast<std::int32_t>(place - members.begin()),
            static_cast<std::int32_t>(i), opposite });
        }
      }
    }
    return result;
  }

  const OrderRelations& Relations;
  const StrongComponents& Components;
};
}

bool VisibilityOrder::Connect(const CellGeometry& geometry, const Progress& progress)
{
  return this->Faces.Connect(geometry, progress);
}

bool VisibilityOrder::SortExact(const CellGeometry& geometry, const OrderView& view, Sorted& sorted,
  const Progress& progress, std::size_t mostPieces) const
{
  sorted = Sorted();
  OrderRelations relations(geometry, this->Faces);
  if (!relations.Find(view, progress.Part(0, 0.5)))
  {
    return false;
  }
  std::vector<Cycle> cycles;
  StrongComponents components;
  sorted.Order.reserve(geometry.Tetrahedra.size());
  bool done = components.Find(
    geometry.Tetrahedra.size(), progress.Part(0.5, 0.8),
    [&](std::int32_t node, std::int32_t& cursor) {
      std::int32_t opposite;
      return relations.Next(node, cursor, opposite);
    },
    [&](const std::int32_t* begin, const std::int32_t* end) {
      if (end - begin > 1)
      {
        cycles.push_back(
          { sorted.Order.size(), sorted.Order.size() + static_cast<std::size_t>(end - begin) });
      }
      sorted.Order.insert(sorted.Order.end(), begin, end);
    });
  if (done && !cycles.empty())
  {
    CycleSplitter splitter(geometry, view.Eye, this->Faces.GetCoordinateError(), mostPieces);
    done =
      CycleOrder(relations, components).Resolve(cycles, splitter, sorted, progress.Part(0.8, 1));
  }
  done = done && progress.Report(1);
  if (!done)
  {
    sorted = Sorted();
  }
  return done;
}

// In buckets of distance, each of which is then sorted.
bool VisibilityOrder::SortCentroids(const CellGeometry& geometry, const Vector4& eye,
  std::vector<std::int32_t>& order, const Progress& progress)
{
  const std::size_t n = geometry.Tetrahedra.size();
  std::vector<float> far(n);
  order.clear();
  if (!forEach(
        n, progress.Part(0, 0.4), [&](std::size_t i) { far[i] = farness(geometry, i, eye); }) ||
    n == 0)
  {
    return n == 0;
  }
  const auto range = std::minmax_element(far.begin(), far.end());
  const float least = *range.first;
  const std::size_t size = std::min<std::size_t>(n, 65536);
  const double scale =
    static_cast<double>(size - 1) / std::max(double(*range.second) - least, 1e-300);
  Buckets<std::int32_t> buckets;
  return buckets.Fill(n, size, progress.Part(0.4, 0.6),
           [&](std::size_t i, auto add) {
             const double bucket =
               scale * (double(far[i]) - least); // not a number where distances overflow
             const double last = static_cast<double>(size - 1);
             add(size - 1 - static_cast<std::size_t>(bucket > 0 ? std::min(bucket, last) : 0),
               static_cast<std::int32_t>(i));
           }) &&
    buckets.ForEach(progress.Part(0.6, 0.9),
      [&](std::int32_t* begin, std::int32_t* end) {
        std::sort(begin, end, [&far](std::int32_t a, std::int32_t b) {
          const float fa = far[static_cast<std::size_t>(a)];
          const float fb = far[static_cast<std::size_t>(b)];
          return fa > fb || (fa == fb && a < b);
        });
      }) &&
    buckets.ForEachInTurn(
      progress.Part(0.9, 1), [&](const std::int32_t* begin, const std::int32_t* end) {
        order.insert(order.end(), begin, end);
      });
}

void VisibilityOrder::SortNone(const CellGeometry& geometry, std::vector<std::int32_t>& order)
{
  order.resize(geometry.Tetrahedra.size());
  std::iota(order.begin(), order.end(), 0);
}

} // namespace nephoscope
