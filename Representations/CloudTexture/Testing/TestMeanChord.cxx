// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Mean chords of bodies against their volume and area, against rays, and what is not a closed
 * surface.
 */
#include "MeanChord.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace nephoscope;
using nephoscope_test::Random;

namespace
{
using Point = MeanChord::Point;

struct Triangle
{
  Point A, B, C;
};

/** A box, its faces outwards, two triangles each. */
std::vector<Triangle> MakeBox(const Point& low, const Point& size)
{
  constexpr int faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  const auto corner = [&](int i) {
    return Point{ { low[0] + (i & 1) * size[0], low[1] + (i >> 1 & 1) * size[1],
      low[2] + (i >> 2) * size[2] } };
  };
  std::vector<Triangle> result;
  for (const auto& f : faces)
  {
    result.push_back({ corner(f[0]), corner(f[1]), corner(f[2]) });
    result.push_back({ corner(f[0]), corner(f[2]), corner(f[3]) });
  }
  return result;
}

MeanChord Measure(const std::vector<Triangle>& triangles, bool reverse = false)
{
  MeanChord result;
  for (const Triangle& t : triangles)
  {
    reverse ? result.AddTriangle(t.A, t.C, t.B) : result.AddTriangle(t.A, t.B, t.C);
  }
  return result;
}
}

TEST(MeanChord, IsFourVolumesOverTheArea)
{
  const Point size{ { 1, 2, 3 } };
  const double expected = 4.0 * 6 / 22;
  for (const bool reverse : { false, true })
  {
    const MeanChord chord = Measure(MakeBox({ { 5, -7, 0.3 } }, size), reverse);
    EXPECT_TRUE(chord.IsClosed());
    EXPECT_EQ(chord.IsInsideOut(), reverse);
    EXPECT_NEAR(chord.Length(), expected, 1e-12);
  }
}

// Rays of all directions through places that are spread evenly over the surface, which they meet
// with a density like the cosine.
TEST(MeanChord, IsThatOfRays)
{
  Random random(9);
  const Point half{ { 0.5, 1, 0.3 } };
  double sum = 0, weights = 0;
  for (int i = 0; i < 400000; ++i)
  {
    Point d{ { random.Normal(), random.Normal(), random.Normal() } };
    const double norm = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (std::size_t c = 0; c < 3; ++c)
    {
      Point o;
      for (std::size_t k = 0; k < 3; ++k)
      {
        o[k] = k == c ? half[k] : random.Uniform(-half[k], half[k]);
      }
      double leave = 1e30; // inwards from the face across c; the faces opposite are like it
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double v = k == c ? -std::abs(d[k]) : d[k];
        leave = std::min(leave, ((v > 0 ? half[k] : -half[k]) - o[k]) / v);
      }
      const double weight = std::abs(d[c]) / norm / half[c]; // area of the face, but for a factor
      sum += weight * leave * norm;
      weights += weight;
    }
  }
  EXPECT_NEAR(
    sum / weights, Measure(MakeBox({ { -0.5, -1, -0.3 } }, { { 1, 2, 0.6 } })).Length(), 0.005);
}

TEST(MeanChord, SeveralBodiesAndWeights)
{
  auto bodies = MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } });
  const auto other = MakeBox({ { 4, 0, 0 } }, { { 2, 2, 2 } });
  MeanChord chord;
  for (const Triangle& t : bodies)
  {
    chord.AddTriangle(t.A, t.B, t.C, 3);
  }
  for (const Triangle& t : other)
  {
    chord.AddTriangle(t.A, t.B, t.C, 0.5);
  }
  EXPECT_NEAR(chord.Length(), 4.0 * 9 / 30, 1e-12);
  EXPECT_NEAR(chord.MeanWeight(), (6 * 3 + 24 * 0.5) / 30, 1e-12);
}

TEST(MeanChord, OpenSurfacesHaveNone)
{
  auto triangles = MakeBox({ { -1, -1, -1 } }, { { 2, 2, 2 } });
  triangles.erase(triangles.begin(), triangles.begin() + 2); // the floor
  EXPECT_FALSE(Measure(triangles).IsClosed());
  EXPECT_EQ(Measure(triangles).Length(), 0);
  triangles.erase(triangles.begin(), triangles.begin() + 2); // and the ceiling: normals cancel out
  EXPECT_FALSE(Measure(triangles).IsClosed());
  EXPECT_FALSE(MeanChord().IsClosed());
  EXPECT_EQ(MeanChord().MeanWeight(), 1);
}
