// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays through tetrahedra in barycentric coordinates, against rays clipped by the planes of the
// faces.
#include "TetrahedronRay.h"

#include "ClippedTetrahedron.h"
#include "TestRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
/**
 * Parameter u at which the ray from a back-face point with coordinates lambda leaves through a
 * front face.
 */
inline double FrontParameter(const Vector4& lambda, const Vector4& q, double eyeW)
{
  double u = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i)
  {
    const double slope = q[i] - eyeW * lambda[i];
    if (slope < 0)
    {
      u = std::min(u, std::max(lambda[i], 0.0) / -slope);
    }
  }
  return u;
}

/** Barycentric coordinates at parameter u. */
inline Vector4 CoordinatesAt(const Vector4& lambda, const Vector4& q, double eyeW, double u)
{
  Vector4 result;
  for (int i = 0; i < 4; ++i)
  {
    result[i] = lambda[i] + u * (q[i] - eyeW * lambda[i]);
  }
  return result;
}

using Points = TetrahedronPoints;

struct AffineMap
{
  std::array<Vector3, 3> Columns;
  Vector3 Offset;
  Vector3 Direction(const Vector3& v) const
  {
    Vector3 x = { { 0, 0, 0 } };
    for (int i = 0; i < 3; ++i)
    {
      x = Along(x, v[i], this->Columns[i]);
    }
    return x;
  }
  Vector3 operator()(const Vector3& v) const { return Along(this->Direction(v), 1, this->Offset); }
};

AffineMap RandomMap(Random& random)
{
  AffineMap map;
  do
  {
    map.Columns = { { random.NormalVector(), random.NormalVector(), random.NormalVector() } };
  } while (std::fabs(Dot(map.Columns[0], Cross(map.Columns[1], map.Columns[2]))) < 0.2);
  map.Offset = random.NormalVector();
  return map;
}

struct Segment
{
  double Thickness, Front, Back;
};

/** What the mapper does: lengths in the world, coordinates q in the model. */
Segment SegmentUnderTest(const Points& model, const Vector4& eyeModel, const Vector4& lambdaBack,
  const Vector4& scalars, double lengthPerParameter)
{
  const Vector4 q = EyeCoordinates(model, eyeModel);
  double u = FrontParameter(lambdaBack, q, eyeModel[3]);
  u = eyeModel[3] > 0 ? std::min(u, 1.0) : u; // the eye itself is at 1
  return { u * lengthPerParameter,
    Interpolate(CoordinatesAt(lambdaBack, q, eyeModel[3], u), scalars),
    Interpolate(lambdaBack, scalars) };
}
}

TEST(TetrahedronRay, AgreesWithClippedRays)
{
  Random random(21);
  double worst = 0;
  int inside = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Points model = RandomTetrahedron(random);
    const AffineMap map = RandomMap(random);
    const Points world = { { map(model[0]), map(model[1]), map(model[2]), map(model[3]) } };
    const Vector4 scalars = { { random.Normal(), random.Normal(), random.Normal(),
      random.Normal() } };
    const bool perspective = i % 2 == 0;
    const bool eyeInside = i % 8 == 0;
    const Vector3 eye =
      eyeInside ? RandomInside(random, model) : Along({ { 0, 0, 0 } }, 4, random.Direction());
    const Vector3 towards = random.Direction(); // in the model
    const Vector3 target = map(RandomInside(random, model));

    Vector3 direction = perspective ? Difference(target, map(eye)) : map.Direction(towards);
    direction = Along({ { 0, 0, 0 } }, (perspective ? 1 : -1) / Length(direction), direction);
    const Vector3 origin = perspective ? map(eye) : target;
    ClippedRay ray = Clip(world, origin, direction);
    ray.Near = perspective ? std::max(ray.Near, 0.0) : ray.Near;
    inside += perspective && ray.Near == 0.0;
    const Vector4 expectedFront = Barycentric(world, Along(origin, ray.Near, direction));
    const Vector4 expectedBack = Barycentric(world, Along(origin, ray.Far, direction));

    const Vector4 eyeModel = perspective ? Vector4{ { eye[0], eye[1], eye[2], 1 } }
                                         : Vector4{ { towards[0], towards[1], towards[2], 0 } };
    const Segment segment = SegmentUnderTest(model, eyeModel, expectedBack, scalars,
      perspective ? ray.Far : Length(map.Direction(towards)));
    worst = std::max({ worst, std::fabs(segment.Thickness - (ray.Far - ray.Near)),
      std::fabs(segment.Front - Interpolate(expectedFront, scalars)),
      std::fabs(segment.Back - Interpolate(expectedBack, scalars)) });
    ASSERT_GT(EyeCoordinates(model, eyeModel)[ray.FarFace], 0)
      << "the ray leaves through a face not marked as a back face";
  }
  std::cout << "largest difference " << worst << "; eye inside " << inside << " times" << std::endl;
  EXPECT_GT(inside, 2000);
  EXPECT_LE(worst, 1e-10);
}

TEST(TetrahedronRay, EyeCoordinates)
{
  Random random(22);
  for (int i = 0; i < 10000; ++i)
  {
    Points p = RandomTetrahedron(random);
    const Vector3 e = Along({ { 0, 0, 0 } }, 3, random.NormalVector());
    const Vector4 q = EyeCoordinates(p, { { e[0], e[1], e[2], 1 } });
    const Vector4 expected = Barycentric(p, e); // q are the eye's barycentric coordinates
    const Vector4 parallel = EyeCoordinates(p, { { e[0], e[1], e[2], 0 } });
    EXPECT_NEAR(parallel[0] + parallel[1] + parallel[2] + parallel[3], 0, 1e-9);
    std::swap(p[2], p[3]); // the other orientation
    const Vector4 swapped = EyeCoordinates(p, { { e[0], e[1], e[2], 1 } });
    for (int k = 0; k < 4; ++k)
    {
      ASSERT_NEAR(q[k], expected[k], 1e-9);
      ASSERT_NEAR(swapped[k < 2 ? k : 5 - k], q[k], 1e-9);
    }
  }
}

// The classes of ShirleyTuchman1990: sum mu_i P_i = 0 with the eye at the origin, mu_i = (-1)^i det
// of the others.
TEST(TetrahedronRay, ProjectionClasses)
{
  Random random(23);
  int oneInside = 0, samples = 20000;
  for (int i = 0; i < samples; ++i)
  {
    const Points p = RandomTetrahedron(random);
    const bool perspective = i % 2 == 0;
    const Vector3 e = Along({ { 0, 0, 0 } }, perspective ? 5 : 1, random.Direction());
    const Vector4 q = EyeCoordinates(p, { { e[0], e[1], e[2], perspective ? 1.0 : 0.0 } });
    // Eye space: positions from the eye, or (x, y, 1) with x and y across the view direction.
    Vector3 x =
      Cross(e, std::fabs(e[0]) < 0.5 * Length(e) ? Vector3{ { 1, 0, 0 } } : Vector3{ { 0, 1, 0 } });
    const Vector3 y = Cross(e, x);
    std::array<Vector3, 4> eyeSpace;
    for (int k = 0; k < 4; ++k)
    {
      eyeSpace[k] =
        perspective ? Difference(p[k], e) : Vector3{ { Dot(p[k], x), Dot(p[k], y), 1 } };
    }
    Vector4 mu;
    double ratio = 0;
    for (int k = 0; k < 4; ++k)
    {
      const auto& f = tetrahedronFaces[k];
      mu[k] = (k % 2 ? -1 : 1) * Dot(eyeSpace[f[0]], Cross(eyeSpace[f[1]], eyeSpace[f[2]]));
      ratio = std::fabs(q[k]) > std::fabs(ratio) ? mu[k] / q[k] : ratio;
    }
    const double scale = ratio;
    int positive = 0;
    for (int k = 0; k < 4; ++k)
    {
      ASSERT_NEAR(mu[k], scale * q[k], 1e-9 * (1 + std::fabs(scale)));
      positive += q[k] > 0;
    }
    oneInside += positive == 1 || positive == 3;
  }
  // With Gaussian vertices seen from afar, 34.9 % are of the class with one vertex inside the
  // others' outline.
  std::cout << "one vertex inside: " << 100.0 * oneInside / samples << " %" << std::endl;
  EXPECT_GT(oneInside, samples / 4);
  EXPECT_LT(oneInside, samples / 2);
}

TEST(TetrahedronRay, RegularTetrahedronAlongZ)
{
  // Crossing edges: from the middle of edge 0-3 (z = 1) to the middle of edge 1-2 (z = -1).
  const Points p = { { { { 1, 1, 1 } }, { { 1, -1, -1 } }, { { -1, 1, -1 } }, { { -1, -1, 1 } } } };
  const Vector4 eye = { { 0, 0, 1, 0 } };
  const Vector4 q = EyeCoordinates(p, eye);
  const int expected[4] = { 1, -1, -1, 1 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_GT(q[i] * expected[i], 0);
  }
  const Vector4 back = { { 0, 0.5, 0.5, 0 } };
  const Segment segment = SegmentUnderTest(p, eye, back, { { 0, 1, 2, 3 } }, 1);
  EXPECT_NEAR(segment.Thickness, 2, 1e-12);
  EXPECT_NEAR(segment.Front, 1.5, 1e-12);
  EXPECT_NEAR(segment.Back, 1.5, 1e-12);
  EXPECT_NEAR(-std::expm1(-segment.Thickness), 0.8646647167633873, 1e-12);
}

TEST(TetrahedronRay, CornerTetrahedronAlongZ)
{
  // The eye looks along +z; through the origin the ray runs in the edge 0-3, 0 in front with scalar
  // 0.
  const Points p = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  const Vector4 eye = { { 0, 0, -1, 0 } };
  const Vector4 q = EyeCoordinates(p, eye);
  EXPECT_GT(q[0], 0);
  EXPECT_EQ(q[1], 0);
  EXPECT_EQ(q[2], 0);
  EXPECT_LT(q[3], 0);
  const Segment segment = SegmentUnderTest(p, eye, { { 0, 0, 0, 1 } }, { { 0, 1, 2, 3 } }, 1);
  EXPECT_NEAR(segment.Thickness, 1, 1e-12);
  EXPECT_NEAR(segment.Front, 0, 1e-12);
  EXPECT_NEAR(segment.Back, 3, 1e-12);
}

// Rounding may put a back-face point slightly outside: the segment must then be empty, never
// negative.
TEST(TetrahedronRay, PointsOnTheOutlineGiveNoNegativeLength)
{
  Random random(24);
  for (int i = 0; i < 10000; ++i)
  {
    const Points p = RandomTetrahedron(random);
    const Vector3 e = Along({ { 0, 0, 0 } }, 5, random.Direction());
    const Vector4 q = EyeCoordinates(p, { { e[0], e[1], e[2], 1 } });
    const double t = random.Uniform();
    Vector4 lambda = { { t, 1 - t, -1e-15, 1e-15 } };
    ASSERT_GE(FrontParameter(lambda, q, 1), 0);
  }
}
