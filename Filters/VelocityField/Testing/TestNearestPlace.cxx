// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest place of triangles, of quadrilaterals and of many faces, against all places of a fine
// grid on them.
#include "CellTree.h"
#include "NearestPlace.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace nephoscope;

namespace
{
struct Faces
{
  std::mt19937 Engine{ 7 };

  double Random(double size)
  {
    return std::uniform_real_distribution<double>(-size, size)(this->Engine);
  }

  // A square, at a place of its own, whose corners are moved by up to `warp`.
  void Make(Vector3 (&p)[4], double warp, double distance)
  {
    const Vector3 square[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
    const Vector3 shift = { this->Random(distance), this->Random(distance),
      this->Random(distance) };
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[i][c] = square[i][c] + shift[c] + this->Random(warp);
      }
    }
  }
};

Vector3 Sum(const Vector3 (&p)[4], const std::array<double, 4>& weights)
{
  Vector3 sum{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += weights[i] * p[i][c];
    }
  }
  return sum;
}

// The least distance among n x n places.
double LeastDistance(const Vector3 (&p)[4], bool triangle, int n)
{
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= (triangle ? n - i : n); ++j)
    {
      const double u = double(i) / n;
      const double v = double(j) / n;
      const Vector3 place = triangle
        ? Sum(p, { 1 - u - v, u, v, 0 })
        : Sum(p, { (1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v });
      least = std::min(least, std::sqrt(Dot(place, place)));
    }
  }
  return least;
}

void ExpectNearest(const Vector3 (&p)[4], bool triangle)
{
  NearestPlace place;
  triangle ? place.OnTriangle(p) : place.OnQuadrilateral(p);
  double sum = 0.0;
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < 4; ++i)
  {
    weights[i] = place.Weight(i);
    sum += weights[i];
    EXPECT_GE(weights[i], 0.0);
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  const Vector3 there = Sum(p, weights);
  EXPECT_NEAR(std::sqrt(Dot(there, there)), std::sqrt(place.Distance2()), 1e-12);
  constexpr int n = 100;
  const double least = LeastDistance(p, triangle, n);
  EXPECT_LE(std::sqrt(place.Distance2()), least + 1e-12);
  EXPECT_GE(std::sqrt(place.Distance2()), least - 2.0 / n); // at most half a diagonal of the grid
}
}

TEST(NearestPlace, OnFaces)
{
  Faces faces;
  Vector3 p[4];
  for (int i = 0; i < 300; ++i)
  {
    const double warp = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 0.1 : 0.3;
    faces.Make(p, warp, i % 2 ? 1.0 : 4.0);
    ExpectNearest(p, true);
    ExpectNearest(p, false);
  }
}

TEST(NearestPlace, OnCollapsedFaces)
{
  Faces faces;
  Vector3 p[4];
  for (int i = 0; i < 100; ++i)
  {
    faces.Make(p, 0.1, 1.0);
    p[1] = p[0]; // an edge
    ExpectNearest(p, true);
    ExpectNearest(p, false);
    p[3] = p[0]; // all but an edge
    ExpectNearest(p, false);
    p[2] = p[0]; // everything
    ExpectNearest(p, true);
    ExpectNearest(p, false);
  }
}

TEST(NearestPlace, OfManyBoxes)
{
  Faces faces;
  std::vector<Box> boxes(777);
  for (Box& box : boxes)
  {
    const Vector3 a = { faces.Random(1), faces.Random(1), faces.Random(1) };
    const Vector3 b = { a[0] + 0.05, a[1] + 0.1, a[2] };
    box.AddPoint(a.data());
    box.AddPoint(b.data());
  }
  CellTree tree;
  tree.Build(boxes);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 x = { faces.Random(3), faces.Random(3), faces.Random(3) };
    double expected = std::numeric_limits<double>::max();
    for (const Box& box : boxes)
    {
      expected = std::min(expected, box.Distance2(x));
    }
    double least = std::numeric_limits<double>::max();
    int looks = 0;
    tree.ForEachNear(x, [&](std::int64_t cell) {
      ++looks;
      least = std::min(least, boxes[static_cast<std::size_t>(cell)].Distance2(x));
      return least;
    });
    EXPECT_EQ(least, expected);
    EXPECT_LT(looks, 50);
  }
  tree.Build({});
  tree.ForEachNear({ 0, 0, 0 }, [](std::int64_t) -> double { throw 0; });
}
