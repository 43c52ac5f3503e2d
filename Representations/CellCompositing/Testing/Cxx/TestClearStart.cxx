// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A start of rays near an eye on, in or beside a tetrahedron: clear of all faces, and no farther
 * away than need be.
 */
#include "ClearStart.h"

#include <gtest/gtest.h>

#include <random>

using namespace nephoscope;

namespace
{
using Corners = std::array<Vector3, 4>;

const Corners corner = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
constexpr double clearance = 1e-3;

Vector3 Combine(const Corners& p, const Vector4& weights)
{
  Vector3 result = { { 0, 0, 0 } };
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      result[axis] += weights[i] * p[i][axis];
    }
  }
  return result;
}

ClearStart StartFrom(const Corners& p, const Vector3& eye)
{
  return FindClearStart(p, { { eye[0], eye[1], eye[2], 1 } }, clearance);
}

// Distances from the faces, by barycentric coordinates of the position alone.
double NearestFace(const Corners& p, const Vector3& position)
{
  const Vector4 q = EyeCoordinates(p, { { position[0], position[1], position[2], 1 } });
  const Vector4 h = Heights(p);
  return std::min({ q[0] * h[0], q[1] * h[1], q[2] * h[2], q[3] * h[3] });
}
}

TEST(ClearStart, HeightsOfACorner)
{
  const Vector4 h = Heights(corner);
  EXPECT_NEAR(h[0], 1 / std::sqrt(3.0), 1e-15);
  for (std::size_t i = 1; i < 4; ++i)
  {
    EXPECT_NEAR(h[i], 1.0, 1e-15);
  }
}

TEST(ClearStart, StaysWhereTheEyeIsClear)
{
  const ClearStart start = StartFrom(corner, { { 0.2, 0.3, 0.1 } });
  EXPECT_TRUE(start.Found);
  EXPECT_EQ(start.Moved, 0);
  EXPECT_EQ(start.Position, (Vector3{ { 0.2, 0.3, 0.1 } }));
}

TEST(ClearStart, IsClearFromVerticesEdgesFacesAndBesideThem)
{
  const Vector4 places[] = { { { 1, 0, 0, 0 } }, { { 0, 0, 1, 0 } }, { { 0.5, 0.5, 0, 0 } },
    { { 0, 0.3, 0, 0.7 } }, { { 0.2, 0.3, 0.5, 0 } }, { { 0, 0.1, 0.2, 0.7 } },
    { { 1.0005, -0.0005, 0, 0 } }, { { 0.2, 0.3, 0.5005, -0.0005 } } };
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Corners p = corner;
  for (int repeat = 0; repeat < 50; ++repeat)
  {
    for (const Vector4& place : places)
    {
      const Vector3 eye = Combine(p, place);
      const ClearStart start = StartFrom(p, eye);
      const Vector4 h = Heights(p);
      const double inscribed = 1 / (1 / h[0] + 1 / h[1] + 1 / h[2] + 1 / h[3]);
      if (NearestFace(p, eye) >= -clearance)
      {
        ASSERT_TRUE(start.Found);
        EXPECT_NEAR(NearestFace(p, start.Position), std::min(clearance, inscribed / 2), 1e-12);
        EXPECT_NEAR(start.Clearance, std::min(clearance, inscribed / 2), 1e-15);
      }
    }
    for (Vector3& vertex : p)
    {
      vertex = { { uniform(random), uniform(random), uniform(random) } };
    }
  }
}

TEST(ClearStart, NeedsTheEyeNearAndAVolume)
{
  EXPECT_FALSE(StartFrom(corner, { { -0.01, 0.3, 0.3 } }).Found);
  EXPECT_FALSE(
    StartFrom({ { corner[0], corner[1], corner[2], corner[2] } }, { { 0.2, 0.2, 0 } }).Found);
  EXPECT_FALSE(
    StartFrom({ { corner[0], corner[1], corner[2], { { 1, 1, 0 } } } }, { { 0.2, 0.2, 0 } }).Found);
  EXPECT_FALSE(
    StartFrom({ { corner[0], corner[0], corner[0], corner[0] } }, { { 0, 0, 0 } }).Found);
}
