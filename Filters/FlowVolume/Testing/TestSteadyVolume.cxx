// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes and densities of steady flow volumes against closed forms.
#include "SmokeChecks.h"
#include "TestRandom.h"
#include "ThreadScope.h"

#include "OwnThreads.h"
#include "SmokeGeometry.h"

using namespace nephoscope_test;

namespace
{
double Error(const FormulaField& field, int n, int steps)
{
  const SmokeMesh mesh = Build(field, SmallTriangle(n), Steps(1.0, steps));
  return TotalVolume(mesh) / mesh.Report.Flux - 1.0;
}
}

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

TEST(SteadyVolume, TheLastStepIsShorterIfTheDurationAsksForIt)
{
  FlowVolumeSettings settings = Steps(1.0, 1);
  settings.TimeStep = 0.3;
  const auto mesh = Build(Uniform(), SmallTriangle(2), settings);
  EXPECT_NEAR(TotalVolume(mesh), 0.02, 1e-15);
  EXPECT_EQ(mesh.Report.MassPerStep.size(), 4u);
  EXPECT_NEAR(*std::max_element(mesh.PointAges.begin(), mesh.PointAges.end()), 1.0, 1e-15);
}

TEST(SteadyVolume, VolumeOfDivergenceFreeFlowsConverges)
{
  // The sides are cut at random, so the error falls only about as the step squared; with plain ids,
  // cut all the same way, the saddle's would be +.022 and +.0055 at 16 and 64 steps (n = 1).
  EXPECT_LT(std::abs(Error(Saddle(), 1, 16)), 0.01);
  EXPECT_LT(std::abs(Error(Saddle(), 4, 16)), 1.5e-3);
  EXPECT_LT(std::abs(Error(Saddle(), 4, 64)), 2e-4);
  EXPECT_NEAR(Error(Helix(), 4, 16), -0.0254, 4e-3);
  EXPECT_NEAR(Error(Helix(), 4, 64), -0.0016, 1e-3);
  const auto abc = Triangle({ { 1, 1, 1 } }, { { 0.2, 0, 0 } }, { { 0, 0.2, 0 } }, 4);
  const auto coarse = Build(ABC(), abc, Steps(1.0, 16)), fine = Build(ABC(), abc, Steps(1.0, 64));
  EXPECT_NEAR(
    coarse.Report.Flux, 0.0311400221, 0.002 * 0.0311400221); // by corners; to second order
  EXPECT_LT(std::abs(TotalVolume(coarse) / 0.0311400221 - 1.0), 1e-2);
  EXPECT_LT(std::abs(TotalVolume(fine) / 0.0311400221 - 1.0), 3e-3);
}

TEST(SteadyVolume, SpreadingSmokeGrowsAndThins)
{
  // div v = 2: V = Q (e^2 - 1) / 2.
  const double exact = 0.01 * (std::exp(2.0) - 1.0);
  const double errors[4] = { 1.04e-2, 2.60e-3, 6.5e-4, 1.63e-4 };
  for (int i = 0; i < 4; ++i)
  {
    const auto mesh = Build(Spreading(), SmallTriangle(1), Steps(1.0, 4 << i));
    EXPECT_NEAR(TotalVolume(mesh) / exact - 1.0, errors[i], 0.02 * errors[i]);
  }
  const auto mesh = Build(Spreading(), SmallTriangle(1), Steps(1.0, 16));
  EXPECT_NEAR(mesh.Densities.back() / mesh.Densities.front(), 0.153355, 1e-6);
  EXPECT_NEAR(mesh.Densities.back() / mesh.Densities.front(), std::exp(-1.875), 1e-5);
  ExpectTrueMass(mesh);
}

TEST(SteadyVolume, DensitiesAtPointsHaveTheMassOfThoseOfCells)
{
  SmokeMesh mesh = Build(Spreading(), SmallTriangle(3), Steps(1.0, 16));
  AverageDensities(mesh);
  double mass = 0.0;
  for (const TetrahedronPoints& tetrahedron : mesh.Tetrahedra)
  {
    for (const PointId point : tetrahedron)
    {
      mass += 0.25 * VolumeOf(tetrahedron, mesh.Points) *
        mesh.PointDensities[static_cast<std::size_t>(point)];
    }
  }
  EXPECT_NEAR(mass, mesh.Report.KeptMass, 1e-12 * mass);
  const auto range = std::minmax_element(mesh.PointDensities.begin(), mesh.PointDensities.end());
  EXPECT_GT(*range.first, 0.9 * std::exp(-2.0));
  EXPECT_LT(*range.second, 1.0);
}

TEST(SteadyVolume, StepsAreHalvedWhereTheFlowTurnsAndOnlyThere)
{
  FlowVolumeSettings settings = Steps(1.0, 8); // the helix turns by 45 degrees in a step
  settings.MaximumHalvings = 4;
  for (const double degrees : { 50.0, 25.0, 12.0, 6.0 })
  {
    settings.MaximumTurnAngle = degrees * pi / 180.0;
    const auto mesh = Build(Helix(), SmallTriangle(1), settings);
    const double atMost = std::ceil(std::log2(45.0 / degrees));
    EXPECT_LE(mesh.Report.Layers, static_cast<std::size_t>(8.0 * std::exp2(std::max(atMost, 0.0))));
    EXPECT_GE(mesh.Report.Layers * degrees,
      300.0); // a corner nearer the axis moves more upwards, and turns less
    EXPECT_EQ(*std::max_element(mesh.EmissionSteps.begin(), mesh.EmissionSteps.end()), 7);
    for (std::size_t t = 0; t < mesh.Tetrahedra.size(); ++t)
    {
      EXPECT_EQ(static_cast<int>(8.0 * mesh.Ages[t]), mesh.EmissionSteps[t]);
    }
    ExpectConforming(mesh);
    ExpectTrueMass(mesh);
  }
  settings.MaximumTurnAngle = 0.01;
  settings.MaximumHalvings = 2;
  EXPECT_EQ(Build(Helix(), SmallTriangle(1), settings).Report.Layers, 32u);
  EXPECT_EQ(Build(Saddle(), SmallTriangle(1), Steps(1.0, 8)).Report.Layers, 8u);
}

TEST(SteadyVolume, StepsAreHalvedWhereTheFlowDiverges)
{
  FlowVolumeSettings settings = Steps(1.0, 2); // div v h = 1: one halving leaves .5 and rounding
  settings.MaximumHalvings = 4;
  const auto mesh = Build(Spreading(), SmallTriangle(1), settings);
  EXPECT_GE(mesh.Report.Layers, 4u);
  EXPECT_LE(mesh.Report.Layers, 8u);
}

TEST(SteadyVolume, TheLimitsOfStepsAndEdgesCanBeSet)
{
  FlowVolumeSettings settings = Steps(1.0, 2); // div v h = 1, areas grow by e
  settings.MaximumHalvings = 4;
  const auto layers = [&settings](double ratio, double divergence) {
    settings.MaximumAreaRatio = ratio;
    settings.MaximumDivergence = divergence;
    return Build(Spreading(), SmallTriangle(1), settings).Report.Layers;
  };
  EXPECT_EQ(layers(0.0, 0.0), 2u);
  EXPECT_EQ(layers(2.8, 0.0), 2u);
  EXPECT_EQ(layers(2.0, 0.0), 4u);
  EXPECT_GE(layers(1.2, 0.0), 8u);
  EXPECT_GE(layers(0.0, 0.1), 16u);
  settings.MaximumHalvings = 1;
  EXPECT_EQ(layers(0.0, 0.01), 4u);
  settings = Steps(2.0, 2);
  settings.MaximumEdgeLength = 0.3; // no edge is longer before a step, but after it
  EXPECT_GT(Build(Spreading(), SmallTriangle(1), settings).Report.HalvedEdges, 0u);
  settings.EdgeLevels = 0;
  const auto whole = Build(Spreading(), SmallTriangle(1), Steps(1.0, 1));
  settings.Duration = settings.TimeStep = 1.0;
  EXPECT_EQ(
    Build(Spreading(), SmallTriangle(1), settings).Tetrahedra.size(), whole.Tetrahedra.size());
}

TEST(SteadyVolume, TheOrderOfPointsAndTrianglesMakesNoDifference)
{
  Random random(7);
  FlowVolumeSettings settings = Steps(1.0, 8);
  settings.MaximumEdgeLength = 0.06;
  const PolygonMesh polygon = SmallTriangle(4);
  const double volume = TotalVolume(Build(ABC(), polygon, settings));
  for (int trial = 0; trial < 5; ++trial)
  {
    std::vector<PointId> places(polygon.Points.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      places[i] = static_cast<PointId>(i);
      std::swap(
        places[i], places[static_cast<std::size_t>(random.Integer(0, static_cast<int>(i)))]);
    }
    PolygonMesh shuffled = polygon;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      shuffled.Points[static_cast<std::size_t>(places[i])] = polygon.Points[i];
    }
    for (auto& triangle : shuffled.Triangles)
    {
      for (PointId& point : triangle)
      {
        point = places[static_cast<std::size_t>(point)];
      }
    }
    std::reverse(shuffled.Triangles.begin(), shuffled.Triangles.end());
    EXPECT_NEAR(TotalVolume(Build(ABC(), shuffled, settings)), volume, 1e-14);
  }
}

TEST(SteadyVolume, DoesNotDependOnTheNumberOfThreads)
{
  SmokeMesh one, four;
  WithThreads(1, [&]() { one = Build(ABC(), Square(0.4, 24), Steps(1.0, 8)); });
  WithThreads(4, [&]() { four = Build(ABC(), Square(0.4, 24), Steps(1.0, 8)); });
  EXPECT_EQ(one.Points, four.Points);
  EXPECT_EQ(one.Tetrahedra, four.Tetrahedra);
  EXPECT_EQ(one.Densities, four.Densities);
}

TEST(SteadyVolume, ErrorControlIsMoreAccurateThanOneStep)
{
  FlowVolumeSettings settings = Steps(1.0, 8); // 45 degrees a step
  const auto furthest = [&settings]() {
    const auto mesh = Build(Helix(), SmallTriangle(1), settings);
    double error = 0.0;
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      const auto& p = mesh.Points[i];
      const double r = std::hypot(p[0], p[1]), corner = std::hypot(0.3, 0.3);
      error = std::max(error, std::min(std::abs(r - corner), std::abs(r - std::hypot(0.5, 0.3))));
    }
    return error;
  };
  EXPECT_GT(furthest(), 1e-3);
  settings.Adaptive = true;
  settings.Tolerance = 1e-8;
  EXPECT_LT(furthest(), 1e-6);
}
