// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Long work tells how far it is, grows steadily, stops when told to, and then comes out as if it
// had never been stopped.
#include "ProjectionOrder.h"

#include "OrderMeshes.h"

#include <gtest/gtest.h>

#include <atomic>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
const Vector4 eye = { { 3, 1, 0.5, 1 } };

/** Everything that a first frame needs; false when stopped. */
bool MakeOrder(vtkDataSet* data, const Progress& progress, ProjectionOrder& sorted)
{
  CellGeometry geometry;
  FaceNeighbors neighbors;
  geometry.Build(
    data, { data->GetPointData()->GetScalars(), false, -1 }, {}, nullptr, progress.Part(0, 0.4));
  if (geometry.Stopped)
  {
    EXPECT_TRUE(geometry.Points.empty() && geometry.Tetrahedra.empty());
    return false;
  }
  if (!neighbors.Connect(geometry, progress.Part(0.4, 0.7)))
  {
    EXPECT_FALSE(neighbors.IsConnected());
    return false;
  }
  if (!sorted.Sort(
        ProjectionOrder::Kind::Topological, geometry, neighbors, eye, progress.Part(0.7, 1)))
  {
    EXPECT_TRUE(sorted.Tetrahedra.empty());
    return false;
  }
  return true;
}
}

TEST(ProgressLoop, EveryElementOnce)
{
  for (const std::size_t n : { 0u, 1u, 15u, 16u, 17u, 5000u })
  {
    for (const bool heard : { false, true })
    {
      std::vector<std::atomic<int>> visits(n);
      std::vector<std::size_t> turns;
      const Progress progress = heard ? Progress([](double) { return true; }) : Progress();
      EXPECT_TRUE(ForEachIndex(n, progress, [&](std::size_t i) { ++visits[i]; }));
      EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](int v) { return v == 1; }));
      EXPECT_TRUE(ForEachInTurn(n, progress, [&](std::size_t i) { turns.push_back(i); }));
      EXPECT_TRUE(turns.size() == n && std::is_sorted(turns.begin(), turns.end()));
    }
  }
}

TEST(ProgressLoop, PartsOfParts)
{
  double heard = -1;
  const Progress whole([&](double fraction) { return (heard = fraction) < 2; });
  whole.Part(0.5, 1).Part(0.5, 0.75).Report(0.5);
  EXPECT_DOUBLE_EQ(heard, 0.8125);
}

TEST(OrderProgress, GrowsFromNothingToAll)
{
  const auto data = MakeShell(60, 30, 4, 80, 1, 1.3);
  AddPointNumbers(data);
  double last = 0;
  int events = 0;
  ProjectionOrder sorted;
  EXPECT_TRUE(MakeOrder(data, Progress([&](double fraction) {
    EXPECT_GE(fraction, last - 1e-12);
    EXPECT_LE(fraction, 1 + 1e-12);
    last = fraction;
    return ++events > 0;
  }),
    sorted));
  EXPECT_NEAR(last, 1, 1e-9);
  EXPECT_GT(events, 20);
}

TEST(OrderProgress, StopsWhereverItIsTold)
{
  const auto data = MakeShell(24, 12, 3, 80, 1, 1.3);
  AddPointNumbers(data);
  ProjectionOrder whole, stopped, again;
  int events = 0;
  ASSERT_TRUE(MakeOrder(data, Progress([&](double) { return ++events > 0; }), whole));
  ProjectionOrder quiet;
  ASSERT_TRUE(MakeOrder(data, Progress(), quiet));
  EXPECT_EQ(quiet.Tetrahedra, whole.Tetrahedra) << "whether anybody listens must not matter";
  ASSERT_GT(events, 20);
  // The length of a stretch, and with it the number of events, depends on the clock: only early
  // ones are sure to come.
  int stops = 0;
  for (int stop = 1; stop <= events; ++stop)
  {
    int count = 0, after = 0;
    if (!MakeOrder(data, Progress([&](double) {
          after += count >= stop;
          return ++count < stop;
        }),
          stopped))
    {
      ++stops;
      EXPECT_EQ(after, 0) << "asked again after it was told to stop";
    }
  }
  EXPECT_GT(stops, 15);
  ASSERT_TRUE(MakeOrder(data, Progress(), again));
  EXPECT_EQ(again.Tetrahedra, whole.Tetrahedra);
}

TEST(OrderProgress, CentroidsStopToo)
{
  const CellGeometry geometry = BuildGeometry(MakeLattice(6));
  const Vector4 away = { { 9, 8, 7, 1 } };
  ProjectionOrder order, stopped;
  using Kind = ProjectionOrder::Kind;
  EXPECT_TRUE(order.Sort(Kind::Centroid, geometry, {}, away));
  EXPECT_FALSE(
    stopped.Sort(Kind::Centroid, geometry, {}, away, Progress([](double) { return false; })));
  EXPECT_TRUE(stopped.Tetrahedra.empty());
  EXPECT_TRUE(
    stopped.Sort(Kind::Centroid, geometry, {}, away, Progress([](double) { return true; })));
  EXPECT_EQ(order.Tetrahedra, stopped.Tetrahedra);
}
