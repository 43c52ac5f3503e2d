// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of the division: triangles of faces, the middle of the kernel, the weights of new
// points.
#include "FaceTriangulation.h"
#include "KernelPoint.h"
#include "MeanValueWeights.h"
#include "PolyhedronExamples.h"

#include "TestRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
const double pi = std::acos(-1.0);

/** A polygon in a tilted plane, vertices numbered in the order of their coordinates. */
struct Face
{
  explicit Face(const Polygon& polygon, double warp = 0)
  {
    std::vector<Vector3> places;
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      const auto& p = polygon[k];
      places.push_back(
        { { p[0], p[1] + 0.1 * p[0], 0.3 * p[0] - 0.2 * p[1] + (k % 2 ? warp : -warp) } });
    }
    this->Positions = places;
    std::sort(this->Positions.begin(), this->Positions.end());
    this->Positions.erase(
      std::unique(this->Positions.begin(), this->Positions.end()), this->Positions.end());
    for (const Vector3& x : places)
    {
      this->Vertices.push_back(
        static_cast<int>(std::lower_bound(this->Positions.begin(), this->Positions.end(), x) -
          this->Positions.begin()));
    }
  }
  bool Cut(FaceTriangulation& triangulation) const
  {
    return triangulation.Cut(this->Vertices.data(), static_cast<int>(this->Vertices.size()),
      [this](int v) { return this->Positions[static_cast<std::size_t>(v)]; });
  }
  Vector3 AreaVector(const Triangle& t) const
  {
    const Vector3& a = this->Positions[static_cast<std::size_t>(t[0])];
    return Cross(Difference(this->Positions[static_cast<std::size_t>(t[1])], a),
      Difference(this->Positions[static_cast<std::size_t>(t[2])], a));
  }
  Vector3 AreaVector() const
  {
    Vector3 sum{ { 0, 0, 0 } };
    for (std::size_t k = 1; k + 1 < this->Vertices.size(); ++k)
    {
      const Vector3 a =
        this->AreaVector({ { this->Vertices[0], this->Vertices[k], this->Vertices[k + 1] } });
      for (std::size_t i = 0; i < 3; ++i)
      {
        sum[i] += a[i];
      }
    }
    return sum;
  }
  std::vector<Vector3> Positions;
  std::vector<int> Vertices;
};

std::set<std::set<int>> AsSet(const std::vector<Triangle>& triangles)
{
  std::set<std::set<int>> result;
  for (const Triangle& t : triangles)
  {
    result.insert({ t.begin(), t.end() });
  }
  return result;
}

Polygon RandomStar(Random& random, int n)
{
  Polygon polygon;
  for (int k = 0; k < n; ++k)
  {
    const double angle = 2 * pi * (k + random.Uniform(0, 0.8)) / n, r = random.Uniform(0.2, 1);
    polygon.push_back({ { r * std::cos(angle), r * std::sin(angle) } });
  }
  return polygon;
}

void ExpectCovers(const Face& face, const FaceTriangulation& triangulation)
{
  const Vector3 whole = face.AreaVector();
  const double length = std::sqrt(Dot(whole, whole));
  double sum = 0;
  for (const Triangle& t : triangulation.GetTriangles())
  {
    const double part = Dot(face.AreaVector(t), whole) / length;
    EXPECT_GT(part, 0);
    sum += part;
  }
  EXPECT_EQ(triangulation.GetTriangles().size(), face.Vertices.size() - 2);
  EXPECT_NEAR(sum, length, 1e-12);
}

std::vector<HalfSpace> HalfSpacesOf(const Polyhedron& p)
{
  std::vector<HalfSpace> result;
  PolyhedronSurface surface;
  p.Build(surface);
  const FaceList<int> faces = surface.Faces();
  for (const int* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    const Vector3& a = surface.Position(face[1]);
    Vector3 n{ { 0, 0, 0 } };
    for (int k = 2; k < *face; ++k)
    {
      const Vector3 part = Cross(
        Difference(surface.Position(face[k]), a), Difference(surface.Position(face[k + 1]), a));
      n = { { n[0] + part[0], n[1] + part[1], n[2] + part[2] } };
    }
    const double length = std::sqrt(Dot(n, n));
    n = { { n[0] / length, n[1] / length, n[2] / length } };
    result.push_back({ n, Dot(n, a) });
  }
  return result;
}
}

TEST(FaceTriangulation, CoversAnyPolygon)
{
  Random random(1);
  int fans = 0;
  for (int trial = 0; trial < 500; ++trial)
  {
    const Face face(RandomStar(random, 4 + trial % 9), trial % 2 ? 0.01 : 0.0);
    FaceTriangulation triangulation;
    ASSERT_TRUE(face.Cut(triangulation)) << trial;
    ExpectCovers(face, triangulation);
    fans += triangulation.IsFan();
  }
  EXPECT_GT(fans, 20);
  EXPECT_LT(fans, 400);
}

TEST(FaceTriangulation, IsTheSameFromBothSidesAndFromAnyStart)
{
  Random random(2);
  for (int trial = 0; trial < 200; ++trial)
  {
    Face face(RandomStar(random, 5 + trial % 8), 0.02);
    FaceTriangulation one, other;
    ASSERT_TRUE(face.Cut(one));
    std::rotate(face.Vertices.begin(), face.Vertices.begin() + trial % 5, face.Vertices.end());
    ASSERT_TRUE(face.Cut(other));
    EXPECT_EQ(AsSet(one.GetTriangles()), AsSet(other.GetTriangles()));
    std::reverse(face.Vertices.begin(), face.Vertices.end());
    ASSERT_TRUE(face.Cut(other));
    EXPECT_EQ(AsSet(one.GetTriangles()), AsSet(other.GetTriangles()));
    ExpectCovers(face, other);
  }
}

TEST(FaceTriangulation, ConvexFacesAreTheMappersFans)
{
  for (int n = 3; n < 12; ++n)
  {
    Polygon polygon;
    for (int k = 0; k < n; ++k)
    {
      polygon.push_back({ { std::cos(2 * pi * k / n + 0.1), std::sin(2 * pi * k / n + 0.1) } });
    }
    const Face face(polygon);
    FaceTriangulation triangulation;
    ASSERT_TRUE(face.Cut(triangulation));
    EXPECT_TRUE(triangulation.IsFan());
    for (const Triangle& t : triangulation.GetTriangles())
    {
      EXPECT_EQ(*std::min_element(t.begin(), t.end()), 0);
    }
  }
}

TEST(FaceTriangulation, FacesWithAHoleThroughABridge)
{
  const Face face({ { { 0, 0 } }, { { 3, 0 } }, { { 3, 3 } }, { { 0, 3 } }, { { 0, 0 } },
    { { 1, 1 } }, { { 1, 2 } }, { { 2, 2 } }, { { 2, 1 } }, { { 1, 1 } } });
  FaceTriangulation triangulation;
  ASSERT_TRUE(face.Cut(triangulation));
  ExpectCovers(face, triangulation);
}

TEST(FaceTriangulation, APointInTheMiddleOfAnEdgeMakesNoFlatTriangle)
{
  const Face face({ { { 0, 0 } }, { { 0, -0.5 } }, { { 0, -1 } }, { { 1, -1 } }, { { 1, 0 } } });
  FaceTriangulation triangulation;
  ASSERT_TRUE(face.Cut(triangulation));
  ExpectCovers(face, triangulation);
}

TEST(FaceTriangulation, RefusesFacesThatCrossThemselvesOrHaveNoArea)
{
  FaceTriangulation triangulation;
  EXPECT_FALSE(Face({ { { 0, 0 } }, { { 2, 2 } }, { { 2, 0 } }, { { 0, 1 } } }).Cut(triangulation));
  EXPECT_TRUE(triangulation.GetTriangles().empty());
  EXPECT_FALSE(Face({ { { 0, 0 } }, { { 1, 1 } }, { { 2, 2 } } }).Cut(triangulation));
}

TEST(KernelPoint, FindsTheLargestBall)
{
  // Cube: 1/2. The L's kernel is the cube at its corner. A tetrahedron's inscribed ball: r = 3 V /
  // A.
  for (const auto& polygon : { squarePolygon, lPolygon })
  {
    const Ball ball = KernelPoint::Find(HalfSpacesOf(MakePrism(polygon)));
    EXPECT_GT(ball.Radius, 0.98 * 0.5);
    EXPECT_LE(ball.Radius, 0.5 + 1e-12);
  }
  const Polyhedron tetrahedron{ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
                                  { { 0, 0, 1 } } },
    { 3, 0, 1, 2, 3, 0, 1, 3, 3, 0, 2, 3, 3, 1, 2, 3 } };
  const double inscribed = 3 * (1.0 / 6) / (1.5 + std::sqrt(3.0) / 2);
  const Ball ball = KernelPoint::Find(HalfSpacesOf(tetrahedron));
  EXPECT_GT(ball.Radius, 0.98 * inscribed);
  EXPECT_LE(ball.Radius, inscribed + 1e-12);
}

TEST(KernelPoint, SmallKernelsAreFoundAndEmptyOnesKnown)
{
  // A block with a notch from above down to a height of `gap`: the kernel is a prism over a
  // triangle of that height.
  for (const double gap : { 0.3, 1e-1, 1e-2, 1e-3, 1e-4 })
  {
    const Polygon notch = { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, gap } },
      { { 0, 1 } } };
    const double half = gap / (1 - gap), leg = std::sqrt(gap * gap + half * half);
    const double inscribed = half * gap / (half + leg);
    const Ball ball = KernelPoint::Find(HalfSpacesOf(MakePrism(notch)));
    EXPECT_GT(ball.Radius, 0.98 * inscribed) << gap;
    EXPECT_LE(ball.Radius, inscribed + 1e-12) << gap;
  }
  EXPECT_LT(KernelPoint::Find(HalfSpacesOf(MakePrism(uPolygon))).Radius, 0);
}

TEST(MeanValueWeights, AreEqualWhereSymmetryAsksForIt)
{
  // The middle of an octahedron.
  std::vector<Vector3> x = { { { 1, 0, 0 } }, { { -1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, -1, 0 } },
    { { 0, 0, 1 } }, { { 0, 0, -1 } }, { { 0, 0, 0 } } };
  std::vector<std::array<int, 4>> tetrahedra;
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 2; b < 4; ++b)
    {
      for (int c = 4; c < 6; ++c)
      {
        const bool even = (a + b + c) % 2 == 0;
        tetrahedra.push_back({ { 6, a, even ? b : c, even ? c : b } });
      }
    }
  }
  const auto weights = NewPointWeights(x, 6, tetrahedra);
  ASSERT_EQ(weights.size(), 1u);
  for (const double w : weights[0])
  {
    EXPECT_NEAR(w, 1.0 / 6, 1e-15);
  }
}

TEST(MeanValueWeights, AreExactForLinearFieldsAndNeverNegative)
{
  Random random(5);
  for (int trial = 0; trial < 100; ++trial)
  {
    // A star-shaped double cone of n sides; the second new point lies in one of the tetrahedra at
    // the first.
    const int n = 3 + trial % 6;
    std::vector<Vector3> x;
    for (int k = 0; k < n; ++k)
    {
      const double r = random.Uniform(0.3, 2), angle = 2 * pi * k / n;
      x.push_back({ { r * std::cos(angle), r * std::sin(angle), random.Uniform(-0.2, 0.2) } });
    }
    x.push_back({ { 0, 0, random.Uniform(0.5, 2) } });
    x.push_back({ { 0, 0, random.Uniform(-2, -0.5) } });
    const int first = n + 2, second = n + 3;
    x.push_back({ { 0, 0, 0 } });
    std::vector<std::array<int, 4>> tetrahedra;
    for (int k = 0; k < n; ++k)
    {
      tetrahedra.push_back({ { first, k, (k + 1) % n, n } });
      tetrahedra.push_back({ { first, (k + 1) % n, k, n + 1 } });
    }
    const std::array<int, 4> split = tetrahedra.front();
    Vector3 inside{ { 0, 0, 0 } };
    for (const int v : split)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        inside[i] += 0.25 * x[static_cast<std::size_t>(v)][i];
      }
    }
    x.push_back(inside);
    tetrahedra.erase(tetrahedra.begin());
    for (std::size_t i = 0; i < 4; ++i)
    {
      std::array<int, 4> part = split;
      part[i] = second;
      tetrahedra.push_back(part);
    }
    const auto weights = NewPointWeights(x, n + 2, tetrahedra);
    ASSERT_EQ(weights.size(), 2u);
    for (std::size_t p = 0; p < 2; ++p)
    {
      Vector3 sum{ { 0, 0, 0 } };
      double one = 0;
      for (std::size_t v = 0; v < weights[p].size(); ++v)
      {
        EXPECT_GE(weights[p][v], -1e-15);
        one += weights[p][v];
        for (std::size_t i = 0; i < 3; ++i)
        {
          sum[i] += weights[p][v] * x[v][i];
        }
      }
      EXPECT_NEAR(one, 1, 1e-13);
      for (std::size_t i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(sum[i], x[static_cast<std::size_t>(n) + 2 + p][i], 1e-12);
      }
    }
  }
}
