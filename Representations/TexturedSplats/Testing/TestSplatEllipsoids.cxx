// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What rays meet of ellipsoidal splats, against quadrature along the ray. */
#include "EllipsoidSplat.h"
#include "SplatKernelValues.h"
#include "SplatOpacity.h"

#include <gtest/gtest.h>

#include <random>

using namespace nephoscope;

namespace
{
// How a ray passes a splat.
struct SplatPassage
{
  double Distance = 0.0;  // from the centre, in cells: the argument of the footprint
  double Thickness = 0.0; // factor on the footprint, length per cell along the ray
  double Depth = 0.0;     // along the ray from its origin to the point nearest to the centre
};

// `direction` has unit length; `offset` is the ray's origin minus the splat's centre.
inline SplatPassage PassSplat(
  const SplatMatrix& inverseJacobian, const Vector3& offset, const Vector3& direction)
{
  const Vector3 k = Times(inverseJacobian, direction);
  const Vector3 o = Times(inverseJacobian, offset);
  const double length = Norm(k);
  return { Norm(Cross(o, k)) / length, 1.0 / length, -Dot(o, k) / (length * length) };
}

double Integrate(const SplatMatrix& inverse, const Vector3& offset, const Vector3& e)
{
  const int steps = 40000;
  const double reach = 12.0, h = 2.0 * reach / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double s = -reach + (i + 0.5) * h;
    const Vector3 x = { { offset[0] + s * e[0], offset[1] + s * e[1], offset[2] + s * e[2] } };
    sum += h * cubic_kernel::Value(Norm(Times(inverse, x)));
  }
  return sum;
}
}

TEST(EllipsoidSplat, OracleOfAStretchedCell)
{
  const double n = 1.0 / std::sqrt(3.0);
  const SplatMatrix inverse = Inverse({ { { { 2, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 0.5 } } } });
  const SplatPassage passage = PassSplat(inverse, { { 0.3, 0.2, -0.1 } }, { { n, n, n } });
  EXPECT_NEAR(
    passage.Thickness * cubic_kernel::Footprint(passage.Distance), 0.4361847905839568, 1e-9);
}

TEST(EllipsoidSplat, OraclesOfRaysThroughTheMiddle)
{
  const double n = 1.0 / std::sqrt(3.0);
  const SplatMatrix inverse = Inverse({ { { { 2, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 0.5 } } } });
  const auto depthAlong = [&](const Vector3& direction) {
    const SplatPassage passage = PassSplat(inverse, {}, direction);
    return passage.Thickness * cubic_kernel::Footprint(passage.Distance);
  };
  EXPECT_NEAR(depthAlong({ { 0, 0, 1 } }), 0.349971713, 1e-9);
  EXPECT_NEAR(depthAlong({ { 1, 0, 0 } }), 1.399886851, 1e-9);
  EXPECT_NEAR(depthAlong({ { n, n, n } }), 0.5291074958, 1e-9);
}

TEST(EllipsoidSplat, EveryRayThroughEveryCellIsExact)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&]() {
    return Vector3{ { uniform(random), uniform(random), uniform(random) } };
  };
  for (int i = 0; i < 40; ++i)
  {
    SplatMatrix jacobian = { { vector(), vector(), vector() } };
    for (std::size_t c = 0; c < 3; ++c)
    {
      jacobian[c][c] += 1.5; // never near degenerate
    }
    const SplatMatrix inverse = Inverse(jacobian);
    Vector3 e = vector();
    const double length = Norm(e);
    e = { { e[0] / length, e[1] / length, e[2] / length } };
    const Vector3 offset = vector();
    const SplatPassage passage = PassSplat(inverse, offset, e);
    EXPECT_NEAR(passage.Thickness * cubic_kernel::Footprint(passage.Distance),
      Integrate(inverse, offset, e), 2e-7);
    const Vector3 nearest = { { offset[0] + passage.Depth * e[0], offset[1] + passage.Depth * e[1],
      offset[2] + passage.Depth * e[2] } };
    EXPECT_NEAR(Norm(Times(inverse, nearest)), passage.Distance, 1e-12);
  }
}

TEST(EllipsoidSplat, FlatCellsKeepAVolume)
{
  const SplatMatrix flat = { { { { 2, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 0 } } } };
  EXPECT_NEAR(Determinant(WithoutFlatColumns(flat, 0.1, 1e-3)), 2.0 * 1.0 * 0.2, 1e-12);
  const SplatMatrix thin = { { { { 2, 0, 0 } }, { { 0, 1e-9, 0 } }, { { 0, 0, 1 } } } };
  EXPECT_NEAR(Determinant(WithoutFlatColumns(thin, 0.1, 1e-3)), 2.0 * 0.2 * 1.0, 1e-12);
  const SplatMatrix layer = { { { { 2, 0, 0 } }, { { 0, 0.004, 0 } }, { { 0, 0, 1 } } } };
  EXPECT_EQ(WithoutFlatColumns(layer, 0.1, 1e-3), layer) << "cells of weather models are thin";
  const SplatMatrix thinner = { { { { 2, 0, 0 } }, { { 0, 4e-4, 0 } }, { { 0, 0, 1 } } } };
  EXPECT_NEAR(Determinant(WithoutFlatColumns(thinner, 0.1, 1e-3)), 2.0 * 0.002 * 1.0, 1e-12);
  const SplatMatrix plain = { { { { 2, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  EXPECT_EQ(WithoutFlatColumns(plain, 0.1, 1e-3), plain);
  EXPECT_EQ(Determinant(WithoutFlatColumns({}, 0.1, 1e-3)), 0.0) << "a cell without size stays one";
}

TEST(SplatOpacity, MediumAndVectorHideEachOther)
{
  const SplatLight both = MediumAndVector(0.5, { { 1, 1, 1 } }, 0.3, { { 1, 1, 1 } });
  EXPECT_NEAR(both.Transparency, 0.42457146179884336, 1e-12);
  EXPECT_NEAR(both.Light[0], 1.0 - both.Transparency, 1e-12) << "of one colour, light is opacity";
  const SplatLight dark = MediumAndVector(0.5, { { 1, 1, 1 } }, 0.3, { { 0, 0, 0 } });
  EXPECT_NEAR(dark.Light[0], 0.341788303, 1e-9);
  const SplatLight medium = MediumAndVector(0.5, { { 0.2, 0.4, 0.6 } }, 0.0, {});
  EXPECT_NEAR(medium.Light[1], 0.4 * SplatAlpha(0.5), 1e-12);
  const SplatLight vector = MediumAndVector(0.0, {}, 0.3, { { 0.2, 0.4, 0.6 } });
  EXPECT_NEAR(vector.Light[2], 0.3 * 0.6, 1e-12);
}

TEST(SplatOpacity, SingleSplatAndColumnOfSplats)
{
  EXPECT_NEAR(SplatAlpha(cubic_kernel::Footprint(0.0)), 0.503386601261117, 1e-9);
  double depth =
    0.0; // a block of 8^3 cells with extinction 1/8, along the middle of a column of voxels
  for (int i = -1; i <= 1; ++i)
  {
    for (int j = -1; j <= 1; ++j)
    {
      depth += 8.0 / 8.0 * cubic_kernel::Footprint(std::hypot(i, j));
    }
  }
  EXPECT_NEAR(SplatAlpha(depth), 0.6325001241830706, 1e-6);
}
