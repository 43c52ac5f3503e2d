// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra that hide one another in cycles: found, counted, and cut until every pixel's ray meets the pieces in order.
#include "VisibilityOrder.h"

#include "FaceRelations.h"
#include "OrderMeshes.h"
#include "RayOrder.h"
#include "StrongComponents.h"
#include "ThreadScope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
const PixelCamera fromAbove({ { 0, 0, 4 } }, { { 0, 0, 0 } }, 1.6, true, 96, 96);
const PixelCamera fromBelow({ { 0, 0, -4 } }, { { 0, 0, 0 } }, 1.6, true, 96, 96);
const PixelCamera perspective({ { 0.1, 0.05, 9 } }, { { 0, 0, 0 } }, 0.2, false, 96, 96);
const PixelCamera aside({ { 5, 1.5, 0.5 } }, { { 0, 0, 0 } }, 1.6, true, 96, 96);

VisibilityOrder::Sorted sortAndCheck(
  const CellGeometry& geometry, const PixelCamera& camera, const char* name)
{
  VisibilityOrder visibility;
  EXPECT_TRUE(visibility.Connect(geometry));
  VisibilityOrder::Sorted sorted;
  EXPECT_TRUE(visibility.SortExact(geometry, camera.GetView(), sorted));
  const RayCheck check = checkRays(geometry, sorted, camera);
  std::cout << name << ": " << geometry.Tetrahedra.size() << " tetrahedra, "
            << sorted.NumberOfCyclicTetrahedra << " in " << sorted.NumberOfCycles << " cycles, "
            << sorted.Pieces.Tetrahedra.size() << " pieces; " << check << std::endl;
  EXPECT_EQ(check.Inversions, 0) << name;
  EXPECT_LT(check.LargestGap, 1e-4) << name;
  EXPECT_GT(check.Crossings, 500) << name;
  EXPECT_EQ(sorted.NumberOfBrokenRelations, 0) << name;
  return sorted;
}

double volume(const std::array<Vector3, 4>& p)
{
  return std::abs(
           dot(cross(difference(p[1], p[0]), difference(p[2], p[0])), difference(p[3], p[0]))) /
    6;
}

/** Every tetrahedron is drawn once, whole or in pieces of the same volume. */
void checkVolumes(const CellGeometry& geometry, const VisibilityOrder::Sorted& sorted)
{
  const std::size_t whole = geometry.Tetrahedra.size();
  std::vector<double> drawn(whole, 0.0);
  for (const std::int32_t number : sorted.Order)
  {
    const std::size_t i = std::size_t(number);
    if (i < whole)
    {
      drawn[i] += volume(geometry.Vertices(i));
      continue;
    }
    std::array<Vector3, 4> p;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const auto& x =
        sorted.Pieces
          .Points[std::size_t(sorted.Pieces.Tetrahedra[i - whole][k]) - geometry.Points.size()];
      p[k] = { { x.X, x.Y, x.Z } };
    }
    drawn[std::size_t(sorted.Pieces.Owners[i - whole])] += volume(p);
  }
  for (std::size_t i = 0; i < whole; ++i)
  {
    const double expected = volume(geometry.Vertices(i));
    ASSERT_NEAR(drawn[i], expected, 1e-5 * expected + 1e-9) << "tetrahedron " << i;
  }
}

std::vector<std::int32_t> shuffled(Random& random, std::size_t n)
{
  std::vector<std::int32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::shuffle(numbers.begin(), numbers.end(), random.GetEngine());
  return numbers;
}
}

TEST(StrongComponents, AgainstReachability)
{
  Random random(81);
  for (int trial = 0; trial < 300; ++trial)
  {
    const std::size_t n = std::size_t(random.Integer(1, 14));
    std::vector<std::vector<std::int32_t>> next(n);
    std::vector<std::vector<bool>> reach(n, std::vector<bool>(n, false));
    for (int edges = random.Integer(0, 30); edges > 0; --edges)
    {
      const int a = random.Integer(0, int(n) - 1), b = random.Integer(0, int(n) - 1);
      next[std::size_t(a)].push_back(b);
      reach[std::size_t(a)][std::size_t(b)] = true;
    }
    for (std::size_t k = 0; k < n; ++k)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
        {
          reach[i][j] = reach[i][j] || (reach[i][k] && reach[k][j]);
        }
      }
    }
    StrongComponents components;
    std::vector<int> group(n, -1);
    int groups = 0;
    ASSERT_TRUE(components.Find(
      n, {},
      [&](std::int32_t node, std::int32_t& cursor) {
        const auto& list = next[std::size_t(node)];
        return std::size_t(cursor) < list.size() ? list[std::size_t(cursor++)] : -1;
      },
      [&](const std::int32_t* begin, const std::int32_t* end) {
        for (; begin != end; ++begin)
        {
          ASSERT_EQ(group[std::size_t(*begin)], -1);
          group[std::size_t(*begin)] = groups;
        }
        ++groups;
      }));
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = 0; j < n; ++j)
      {
        const bool together = i == j || (reach[i][j] && reach[j][i]);
        ASSERT_EQ(group[i] == group[j], together);
        ASSERT_EQ(
          components.GetComponent(std::int32_t(i)) == components.GetComponent(std::int32_t(j)),
          together);
        if (!together && reach[i][j])
        {
          ASSERT_GT(group[i], group[j]) << "what is behind comes first";
        }
      }
    }
  }
}

TEST(VisibilityCycles, RingOfNeighbours)
{
  for (const int n : { 16, 24 })
  {
    const CellGeometry geometry = buildGeometry(makeLeaningRing(n));
    ASSERT_EQ(geometry.Tetrahedra.size(), std::size_t(3 * n));
    for (const PixelCamera* camera : { &fromAbove, &fromBelow, &perspective })
    {
      const auto relations = findRelations(findInteriorFaces(geometry), camera->GetView().Eye);
      ASSERT_GT(countUnsortable(relations, geometry.Tetrahedra.size()), 0u)
        << "the mesh of this test has no cycle";
      const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, *camera, "ring");
      EXPECT_GT(sorted.NumberOfCycles, 0);
      EXPECT_GE(sorted.NumberOfCyclicTetrahedra, n);
      EXPECT_LE(sorted.NumberOfCyclicTetrahedra, 3 * n);
      EXPECT_GT(sorted.Pieces.Tetrahedra.size(), 0u);
      checkVolumes(geometry, sorted);
    }
    const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, aside, "ring from the side");
    EXPECT_EQ(sorted.NumberOfCycles, 0);
    EXPECT_TRUE(sorted.Pieces.Tetrahedra.empty());
  }
}

// Bars that do not touch: along z, each lies over the next.
TEST(VisibilityCycles, ThreeBars)
{
  for (const int pieces : { 1, 7 })
  {
    const CellGeometry geometry = buildGeometry(makeThreeBars(pieces));
    for (const PixelCamera* camera : { &fromAbove, &fromBelow, &perspective })
    {
      const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, *camera, "three bars");
      EXPECT_EQ(sorted.NumberOfCycles, pieces == 1 ? 1 : 0)
        << "divided into two, the bars have an order";
      EXPECT_EQ(sorted.NumberOfCyclicTetrahedra >= 3, pieces == 1);
      checkVolumes(geometry, sorted);
    }
    EXPECT_EQ(sortAndCheck(geometry, aside, "three bars from the side").NumberOfCycles, 0);
  }
}

TEST(VisibilityCycles, ManyAtOnce)
{
  Random random(82);
  BlockMesh mesh; // in front of each other
  for (int i = 0; i < 12; ++i)
  {
    addThreeBars(mesh, 1,
      { { random.Uniform(-0.7, 0.7), random.Uniform(-0.7, 0.7), 0.8 * (i - 5.5) } },
      i % 2 ? 1 : 0.4);
  }
  const CellGeometry geometry = buildGeometry(mesh.Get());
  std::int64_t cycles = 0;
  for (int i = 0; i < 6; ++i)
  {
    const Vector3 eye = { { random.Uniform(-2, 2), random.Uniform(-2, 2), i % 2 ? 14.0 : -14.0 } };
    const PixelCamera camera(eye, { { 0, 0, 0 } }, 0.25, false, 128, 128);
    const VisibilityOrder::Sorted sorted =
      sortAndCheck(geometry, camera, "twelve times three bars");
    cycles += sorted.NumberOfCycles;
    checkVolumes(geometry, sorted);
  }
  EXPECT_GT(cycles, 20);
}

TEST(VisibilityCycles, AllRodsInOne)
{
  const CellGeometry geometry = buildGeometry(makeInterlacedRods(3));
  for (const bool parallel : { false, true })
  {
    const PixelCamera camera(
      { { 2, 2.1, 1.9 } }, { { 0, 0, 0 } }, parallel ? 0.9 : 0.27, parallel, 96, 96);
    const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, camera, "interlaced rods");
    EXPECT_EQ(sorted.NumberOfCycles, 1);
    EXPECT_GT(sorted.NumberOfCyclicTetrahedra, 81);
    checkVolumes(geometry, sorted);
  }
}

TEST(VisibilityCycles, TwistedTube)
{
  const CellGeometry geometry = buildGeometry(makeTwistedTube(24, 3, 1));
  for (const double z : { 9.0, -7.0 })
  {
    const PixelCamera camera({ { 0.1, 0.05, z } }, { { 0, 0, 0 } }, 0.15, false, 80, 80);
    const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, camera, "twisted tube");
    EXPECT_GE(sorted.NumberOfCycles, 1);
    EXPECT_GE(sorted.NumberOfCyclicTetrahedra, 24);
    checkVolumes(geometry, sorted);
  }
}

TEST(VisibilityCycles, NumberingAndThreadsDoNotCount)
{
  Random random(84);
  const CellGeometry geometry = buildGeometry(makeThreeBars(1));
  const VisibilityOrder::Sorted first = sortAndCheck(geometry, fromAbove, "bars");
  for (int i = 0; i < 5; ++i)
  {
    const auto numbers = shuffled(random, geometry.Tetrahedra.size());
    const CellGeometry permuted =
      buildGeometry(pickTetrahedra(geometry, numbers, [](std::int32_t) { return true; }));
    const VisibilityOrder::Sorted sorted = sortAndCheck(permuted, fromAbove, "bars, renumbered");
    EXPECT_EQ(sorted.NumberOfCycles, first.NumberOfCycles);
    EXPECT_EQ(sorted.NumberOfCyclicTetrahedra, first.NumberOfCyclicTetrahedra);
  }
  for (const int threads : { 1, 3, 4 })
  {
    withThreads(threads, [&]() {
      const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, fromAbove, "bars, threads");
      EXPECT_EQ(sorted.Order, first.Order);
      EXPECT_EQ(sorted.Pieces.Tetrahedra, first.Pieces.Tetrahedra);
    });
  }
}

// Where pieces would be too many, what is drawn wrong is counted.
TEST(VisibilityCycles, ALimitOnPieces)
{
  const CellGeometry geometry = buildGeometry(makeLeaningRing(16));
  VisibilityOrder visibility;
  visibility.Connect(geometry);
  VisibilityOrder::Sorted sorted;
  OrderView view; // without a picture: the relations are those of shared faces
  view.Eye = fromAbove.GetView().Eye;
  ASSERT_TRUE(visibility.SortExact(geometry, view, sorted, {}, 0));
  EXPECT_GT(sorted.NumberOfBrokenRelations, 0);
  EXPECT_GT(sorted.NumberOfCycles, 0);
  EXPECT_TRUE(sorted.Pieces.Tetrahedra.empty());
  EXPECT_EQ(sorted.Order.size(), geometry.Tetrahedra.size());
  const auto relations = findRelations(findInteriorFaces(geometry), view.Eye);
  EXPECT_EQ(countViolations(relations, sorted.Order), sorted.NumberOfBrokenRelations)
    << "what is counted is what is broken";
  EXPECT_GT(checkRays(geometry, sorted, fromAbove).Inversions, 0);
}

// The scalar of a piece is that of the tetrahedron at the same place.
TEST(VisibilityCycles, PiecesKeepTheField)
{
  const auto grid = makeThreeBars(1);
  const auto field = [](const double* x) { return 0.3 * x[0] - 0.2 * x[1] + 0.5 * x[2]; };
  addScalars(grid, false, [&](vtkIdType i) { return field(grid->GetPoint(i)); });
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  CellGeometry geometry;
  ASSERT_EQ(geometry.Build(grid, { scalars, false, -1 }, { scalars, false, -1 }), "");
  const VisibilityOrder::Sorted sorted = sortAndCheck(geometry, fromAbove, "bars with a field");
  ASSERT_EQ(sorted.Pieces.OpacityScalars.size(), sorted.Pieces.Points.size());
  ASSERT_GT(sorted.Pieces.Points.size(), 0u);
  for (std::size_t i = 0; i < sorted.Pieces.Points.size(); ++i)
  {
    const CellGeometry::Point& p = sorted.Pieces.Points[i];
    const double x[3] = { p.X + geometry.Center[0], p.Y + geometry.Center[1],
      p.Z + geometry.Center[2] };
    const double expected =
      (field(x) - geometry.ScalarRange[0]) / (geometry.ScalarRange[1] - geometry.ScalarRange[0]);
    EXPECT_NEAR(p.Scalar, expected, 1e-5);
    EXPECT_NEAR(sorted.Pieces.OpacityScalars[i], expected, 1e-5);
  }
}
