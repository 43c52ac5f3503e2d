// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes and masses of steady flow volumes against closed forms.
#include "SmokeChecks.h"

using namespace nephoscope_test;

TEST(SteadyVolume, UniformAndObliqueFlowsGiveAreaTimesSpeedTimesTime)
{
  const auto oblique = Everywhere([](double, double, double) {
    return Vector3{ { 0.7, -0.4, 1.0 } };
  });
  for (int n : { 1, 3, 4 })
  {
    for (int steps : { 1, 7, 16 })
    {
      const auto straight = Build(Uniform(), SmallTriangle(n), Steps(2.0, steps));
      EXPECT_NEAR(TotalVolume(straight), 0.04, 1e-15);
      EXPECT_EQ(straight.Tetrahedra.size(), static_cast<std::size_t>(3 * n * n * steps));
      EXPECT_NEAR(TotalVolume(Build(oblique, SmallTriangle(n), Steps(2.0, steps))), 0.04, 1e-15);
    }
  }
}

TEST(SteadyVolume, SaddleAndHelixConvergeWithSecondOrder)
{
  for (int n : { 1, 4 })
  {
    const auto error = [n](const FormulaField& field, int steps) {
      return TotalVolume(Build(field, SmallTriangle(n), Steps(1.0, steps))) / 0.02 - 1.0;
    };
    EXPECT_LT(std::abs(error(Saddle(), 16)), n == 1 ? 0.03 : 0.003);
    EXPECT_LT(std::abs(error(Saddle(), 64)), n == 1 ? 0.008 : 0.0008);
  }
  for (const auto& field : { Saddle(), Helix(), ABC() })
  {
    for (int n : { 1, 4 })
    {
      for (int steps : { 8, 16, 32, 64 })
      {
        const auto mesh = Build(field, SmallTriangle(n), Steps(1.0, steps));
        EXPECT_EQ(mesh.Report.FoldedTriangles, 0u);
      }
    }
  }
}

TEST(SteadyVolume, Adaptive)
{
  for (const auto& field : { Saddle(), Helix(), ABC(), Spreading() })
  {
    auto s = Steps(1.0, 8);
    s.MaximumHalvings = 4;
    s.MaximumTurnAngle = 0.26;
    s.MaximumEdgeLength = 0.05;
    const auto mesh = Build(field, SmallTriangle(4), s);
    const auto& r = mesh.Report;
    EXPECT_EQ(r.FoldedTriangles, 0u);
    ExpectTrueMass(mesh);
  }
}

