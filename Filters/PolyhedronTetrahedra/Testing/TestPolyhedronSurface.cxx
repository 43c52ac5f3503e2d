// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces wound outward whatever the file says, and the question whether a cell is convex.
#include "PolyhedronConvexity.h"
#include "PolyhedronExamples.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
using State = PolyhedronSurface::State;

// Winds every face at random and starts it anywhere.
void ShuffleFaces(Polyhedron& p, Random& random)
{
  for (std::size_t i = 0; i < p.Faces.size(); i += static_cast<std::size_t>(p.Faces[i]) + 1)
  {
    const auto begin = p.Faces.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const auto end = begin + p.Faces[i];
    std::rotate(
      begin, begin + static_cast<std::ptrdiff_t>(random.Uniform(0, 1) * p.Faces[i] * 0.999), end);
    if (random.Uniform(0, 1) < 0.5)
    {
      std::reverse(begin, end);
    }
  }
}

bool IsConvex(const Polyhedron& p, bool isFloat = false, double warpTolerance = 0.1)
{
  PolyhedronSurface surface;
  EXPECT_EQ(p.Build(surface), State::Closed);
  const double slack = SlackOf(surface, isFloat);
  return IsConvexButForWarp(surface, slack, warpTolerance) && ConeFillsCell(surface, slack);
}
}

TEST(PolyhedronSurface, WindsFacesOutward)
{
  Random random(1);
  for (int trial = 0; trial < 50; ++trial)
  {
    for (const auto& [polygon, volume] : { std::make_pair(squarePolygon, 1.0),
           std::make_pair(lPolygon, 3.0), std::make_pair(uPolygon, 5.0) })
    {
      Polyhedron prism = MakePrism(polygon);
      ShuffleFaces(prism, random);
      PolyhedronSurface surface;
      ASSERT_EQ(prism.Build(surface), State::Closed);
      EXPECT_NEAR(VolumeOf(surface), volume, 1e-12);
    }
  }
}

TEST(PolyhedronSurface, CavitiesAreTakenAwayAndIslandsAdded)
{
  Random random(2);
  const Polyhedron cube = MakePrism(squarePolygon);
  const Polyhedron cavity = Moved(cube, 0.5, { { 0.2, 0.25, 0.3 } });
  const Polyhedron island = Moved(cube, 0.25, { { 0.3, 0.35, 0.4 } });
  const Polyhedron beside = Moved(cube, 1.0, { { 5, 0, 0 } });
  for (int trial = 0; trial < 20; ++trial)
  {
    Polyhedron all = Joined(Joined(Joined(cavity, cube), island), beside);
    ShuffleFaces(all, random);
    PolyhedronSurface surface;
    ASSERT_EQ(all.Build(surface), State::Closed);
    EXPECT_NEAR(VolumeOf(surface), 1 - 1.0 / 8 + 1.0 / 64 + 1, 1e-12);
    EXPECT_EQ(surface.CavityFaces().size(), 1u);
  }
}

TEST(PolyhedronSurface, MergesPointsAtOnePlace)
{
  Polyhedron wedge = MakePrism(squarePolygon);
  wedge.Points[6] =
    wedge.Points[2] = { { 1, 1, 0.5 } }; // one edge shrinks to a point, whose two numbers stay
  PolyhedronSurface surface;
  ASSERT_EQ(wedge.Build(surface), State::Closed);
  EXPECT_EQ(surface.NumberOfVertices(), 7);
}

TEST(PolyhedronSurface, RefusesWhatHasNoInside)
{
  PolyhedronSurface surface;
  Polyhedron open = MakePrism(squarePolygon);
  open.Faces.resize(open.Faces.size() - 5); // one side is missing
  EXPECT_EQ(open.Build(surface), State::NotClosed);
  Polyhedron twice = MakePrism(squarePolygon);
  twice.Faces.insert(twice.Faces.end(), { 4, 0, 1, 5, 4 });
  EXPECT_EQ(twice.Build(surface), State::NotClosed);
  Polyhedron nan = MakePrism(squarePolygon);
  nan.Points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nan.Build(surface), State::NotFinite);
  EXPECT_EQ(Polyhedron().Build(surface), State::NotClosed);
  // The projective plane in six vertices: closed, and one-sided.
  Polyhedron plane;
  Random random(3);
  for (int k = 0; k < 6; ++k)
  {
    plane.Points.push_back(
      { { random.Uniform(0, 1), random.Uniform(0, 1), random.Uniform(0, 1) } });
  }
  for (const auto& t : { std::array<int, 3>{ { 0, 1, 2 } }, { { 0, 2, 3 } }, { { 0, 3, 4 } },
         { { 0, 4, 5 } }, { { 0, 5, 1 } }, { { 1, 2, 4 } }, { { 2, 3, 5 } }, { { 3, 4, 1 } },
         { { 4, 5, 2 } }, { { 5, 1, 3 } } })
  {
    plane.Faces.insert(plane.Faces.end(), { 3, t[0], t[1], t[2] });
  }
  EXPECT_EQ(plane.Build(surface), State::NotOriented);
}

TEST(PolyhedronConvexity, OfPlaneFaces)
{
  EXPECT_TRUE(IsConvex(MakePrism(squarePolygon)));
  EXPECT_FALSE(IsConvex(MakePrism(lPolygon)));
  EXPECT_FALSE(IsConvex(MakePrism(uPolygon)));
  // With a point in the middle of an edge, and a face cut in two.
  EXPECT_TRUE(IsConvex(
    MakePrism({ { { 0, 0 } }, { { 0.5, 0 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } })));
  // A dent of a thousandth, a bulge of a thousandth.
  EXPECT_FALSE(IsConvex(
    MakePrism({ { { 0, 0 } }, { { 0.5, 1e-3 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } })));
  EXPECT_TRUE(IsConvex(
    MakePrism({ { { 0, 0 } }, { { 0.5, -1e-3 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } })));
}

TEST(PolyhedronConvexity, DoesNotDependOnScaleOrPlace)
{
  const Polyhedron dented =
    MakePrism({ { { 0, 0 } }, { { 0.5, 1e-3 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } });
  for (const double scale : { 1e-12, 1e-3, 1e9 })
  {
    for (const double far : { 0.0, 1e3 })
    {
      const Vector3 by{ { far * scale, -far * scale, far * scale } };
      EXPECT_TRUE(IsConvex(Moved(MakePrism(squarePolygon), scale, by)));
      EXPECT_FALSE(IsConvex(Moved(dented, scale, by)));
    }
  }
}

TEST(PolyhedronConvexity, ForgivesTheRoundingOfFloats)
{
  // A regular prism of twelve sides, each cut in two: vertices that should lie in one plane, far
  // from the origin.
  Polygon polygon;
  for (int k = 0; k < 24; ++k)
  {
    const double pi = std::acos(-1.0), angle = pi / 6 * (k / 2), next = pi / 6 * (k / 2 + 1);
    const double half = k % 2 ? 0.5 : 0.0;
    polygon.push_back({ { (1 - half) * std::cos(angle) + half * std::cos(next),
      (1 - half) * std::sin(angle) + half * std::sin(next) } });
  }
  for (const double far : { 0.0, 10.0, 1e3 })
  {
    Polyhedron prism = Moved(MakePrism(polygon), 1, { { far, 0.7 * far, 0.3 * far } });
    for (Vector3& x : prism.Points)
    {
      x = { { static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) } };
    }
    EXPECT_TRUE(IsConvex(prism, true)) << far;
  }
}

TEST(PolyhedronConvexity, ForgivesWarpButNoFold)
{
  // The top of a cube with one corner lifted or lowered: whichever diagonal is taken, one of the
  // two is not convex.
  for (const double lift : { -0.2, -0.05, 0.05, 0.2 })
  {
    for (const int corner : { 4, 5, 6, 7 })
    {
      Polyhedron cube = MakePrism(squarePolygon);
      cube.Points[static_cast<std::size_t>(corner)][2] += lift;
      EXPECT_TRUE(IsConvex(cube)) << lift;
      EXPECT_FALSE(IsConvex(cube, false, 0.001)) << lift;
    }
  }
  Polyhedron folded = MakePrism(squarePolygon);
  folded.Points[6][2] = -0.9;
  EXPECT_FALSE(IsConvex(folded));
}

TEST(PolyhedronConvexity, AConeThatIsInvertedIsFoundWhateverTheWarp)
{
  // The volume of the tetrahedra that would be drawn is the volume of the cell exactly when
  // ConeFillsCell says so.
  Random random(4);
  int filled = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    Polyhedron cube = MakePrism(squarePolygon);
    for (Vector3& x : cube.Points)
    {
      for (double& c : x)
      {
        c += random.Uniform(-0.6, 0.6);
      }
    }
    PolyhedronSurface surface;
    ASSERT_EQ(cube.Build(surface), State::Closed);
    double all = 0, withSign = 0;
    DecomposeCell(
      surface.Faces(), [](int a, int b) { return a < b; },
      [&](const std::array<int, 4>& t) {
        const double six = SixVolumes(surface.Position(t[0]), surface.Position(t[1]),
          surface.Position(t[2]), surface.Position(t[3]));
        all += std::abs(six);
        withSign += six;
      });
    const bool fills = ConeFillsCell(surface, 0);
    filled += fills;
    EXPECT_EQ(fills, all - withSign < 1e-12) << trial;
  }
  EXPECT_GT(filled, 500);
  EXPECT_LT(filled, 1900);
}
