// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// No cracks, no hanging points, no tetrahedra inside out and true mass, whatever happens to the
// front.
#include "SmokeChecks.h"

#include <limits>

using namespace nephoscope_test;

namespace
{
std::size_t ExpectWhole(const SmokeMesh& mesh)
{
  ExpectTrueMass(mesh);
  return ExpectConforming(mesh);
}

double LongestFrontEdge(const SmokeMesh& mesh)
{
  double longest = 0.0;
  for (const auto& t : mesh.Tetrahedra)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const auto a = static_cast<std::size_t>(t[i]), b = static_cast<std::size_t>(t[j]);
        double squared = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          squared += std::pow(mesh.Points[a][c] - mesh.Points[b][c], 2);
        }
        const bool same = mesh.PointAges[a] == mesh.PointAges[b];
        longest = same ? std::max(longest, std::sqrt(squared)) : longest;
      }
    }
  }
  return longest;
}

// Potential flow around a ball of radius .2 at (0, 0, 1).
FormulaField AroundBall()
{
  return FormulaField([](const Vector3& p, Vector3& v) {
    const double x = p[0], y = p[1], z = p[2] - 1.0, r2 = x * x + y * y + z * z;
    const double k = 0.004 / (r2 * std::sqrt(r2));
    v = { { -3.0 * k * x * z / r2, -3.0 * k * y * z / r2, 1.0 + k - 3.0 * k * z * z / r2 } };
    return r2 > 0.04;
  });
}
FormulaField WithBall()
{
  return FormulaField([](const Vector3& p, Vector3& v) {
    v = { { 0, 0, 1 } };
    return p[0] * p[0] + p[1] * p[1] + (p[2] - 1.0) * (p[2] - 1.0) > 0.04;
  });
}
}

TEST(SmokeConformity, OnlyTheOutsideIsOutside)
{
  const auto abc = Triangle({ { 1, 1, 1 } }, { { 0.2, 0, 0 } }, { { 0, 0.2, 0 } }, 4);
  const auto settings = Steps(1.0, 16);
  // Two ends of 16 triangles, 12 edges x 16 layers x 2.
  EXPECT_EQ(ExpectWhole(Build(ABC(), abc, settings)), 416u);
  EXPECT_EQ(ExpectWhole(Build(Saddle(), SmallTriangle(4), settings)), 416u);
  EXPECT_EQ(ExpectWhole(Build(Helix(), SmallTriangle(4), Steps(1.0, 16))), 416u);
}

TEST(SmokeConformity, DividedEdgesLeaveTheVolumeClosed)
{
  for (const auto& field : { Saddle(), ABC(), Spreading() })
  {
    FlowVolumeSettings settings = Steps(1.5, 12);
    settings.MaximumEdgeLength = 0.08;
    const auto mesh = Build(field, SmallTriangle(3), settings);
    EXPECT_GT(mesh.Report.HalvedEdges, 0u);
    EXPECT_LE(LongestFrontEdge(mesh), 0.08 * (1.0 + 1e-12));
    ExpectWhole(mesh);
  }
}

TEST(SmokeConformity, SeveralGenerationsInOneStep)
{
  FlowVolumeSettings settings = Steps(2.0, 2);
  settings.MaximumEdgeLength = 0.05;
  const auto mesh = Build(Spreading(), SmallTriangle(1), settings);
  EXPECT_LE(LongestFrontEdge(mesh), 0.05 * (1.0 + 1e-12));
  ExpectWhole(mesh);
}

TEST(SmokeConformity, MergedEdgesLeaveTheVolumeClosed)
{
  FlowVolumeSettings settings = Steps(2.0, 32);
  settings.MinimumEdgeLength = 0.05;
  const auto few = Build(Converging(), Square(0.4, 8), settings);
  settings.MinimumEdgeLength = 0.0;
  const auto all = Build(Converging(), Square(0.4, 8), settings);
  EXPECT_GT(few.Report.MergedEdges, 50u);
  EXPECT_LT(few.Tetrahedra.size(), 0.6 * static_cast<double>(all.Tetrahedra.size()));
  EXPECT_NEAR(TotalVolume(few), TotalVolume(all), 1e-3 * TotalVolume(all)); // the outline stays
  ExpectWhole(few);
  settings.MinimumEdgeLength = 0.05;
  settings.MaximumEdgeLength = 0.15;
  const auto both = Build(Saddle(), Square(0.4, 8), settings);
  EXPECT_GT(both.Report.MergedEdges, 100u);
  EXPECT_GT(both.Report.HalvedEdges, 100u);
  ExpectWhole(both);
}

TEST(SmokeConformity, MergingKeepsTheDensityOfUniformSmoke)
{
  FlowVolumeSettings settings = Steps(1.0, 16);
  settings.MinimumEdgeLength = 0.15;
  const auto shear = Everywhere([](double, double, double) {
    return Vector3{ { 0.2, 0.1, 1.0 } };
  });
  const auto mesh = Build(shear, Square(0.4, 8), settings);
  EXPECT_GT(mesh.Report.MergedEdges, 10u);
  for (double density : mesh.Densities)
  {
    EXPECT_NEAR(density, 1.0, 1e-12);
  }
  ExpectWhole(mesh);
}

TEST(SmokeConformity, PartsAtAnObstacle)
{
  // The flow ends at the front half of the ball: it lacks the half ball and the cylinder from its
  // middle on.
  const double lost = 2.0 / 3.0 * pi * 0.008 + pi * 0.04;
  double errors[3];
  for (int i = 0; i < 3; ++i)
  {
    FlowVolumeSettings settings = Steps(2.0, 64);
    settings.ObstacleLevels = 2 * i;
    settings.FarthestObstacle = 10.0;
    const auto mesh = Build(WithBall(), Square(0.4, 4), settings);
    ExpectWhole(mesh);
    EXPECT_NEAR(mesh.Report.ObstacleMass, mesh.Report.LostMass, 1e-9 * mesh.Report.LostMass);
    for (const Vector3& p : mesh.Points)
    {
      EXPECT_GE(p[0] * p[0] + p[1] * p[1] + (p[2] - 1.0) * (p[2] - 1.0), 0.04);
    }
    errors[i] = mesh.Report.LostMass - lost;
  }
  // Whole prisms end: too much is lost, by half a triangle along the outline, which is sixteen
  // times smaller at level 4.
  EXPECT_GT(errors[2], 0.0);
  EXPECT_LT(errors[2], 0.1 * lost);
  EXPECT_LT(errors[2], 0.5 * errors[1]);
}

TEST(SmokeConformity, FindsObstaclesSmallerThanATriangleAndThinnerThanAStep)
{
  // A plate of width 0.08 and thickness 0.02 between the corners of triangles
  // with edges of 0.4. Behind it, from z = 1 on, there is no smoke.
  const FormulaField plate([](const Vector3& p, Vector3& v) {
    v = { { 0, 0, 1 } };
    return std::abs(p[0] - 0.21) > 0.04 || std::abs(p[1] - 0.13) > 0.04 ||
      std::abs(p[2] - 1.005) > 0.01;
  });
  FlowVolumeSettings settings = Steps(2.0, 16);
  settings.ObstacleLevels = 5;
  settings.FarthestObstacle = 10.0;
  const auto missed = Build(plate, Square(0.4, 2), settings);
  EXPECT_EQ(missed.Report.LostMass, 0.0);
  settings.ObstacleSize = 0.02;
  const auto mesh = Build(plate, Square(0.4, 2), settings);
  ExpectWhole(mesh);
  EXPECT_NEAR(mesh.Report.ObstacleMass, mesh.Report.LostMass, 1e-9 * mesh.Report.LostMass);
  // What the plate stops, in front of it a layer too much, and along its
  // outline half a triangle of 1/32 of an edge or so.
  EXPECT_GT(mesh.Report.LostMass, 0.08 * 0.08 * 1.005);
  EXPECT_LT(mesh.Report.LostMass, 0.12 * 0.12 * 1.13);
  settings.ObstacleLevels = 0;
  const auto whole = Build(plate, Square(0.4, 2), settings);
  ExpectWhole(whole);
  // A whole triangle, from the beginning of the layer on.
  EXPECT_NEAR(whole.Report.LostMass, 0.08 * 1.125, 1e-12);
}

TEST(SmokeConformity, TellsObstaclesFromTheEdgeOfTheData)
{
  // A ball in front of the edge: what its disc stops is lost at the obstacle, and the rest at the
  // edge.
  const FormulaField field([](const Vector3& p, Vector3& v) {
    v = { { 0, 0, 1 } };
    return p[0] * p[0] + p[1] * p[1] + (p[2] - 1.0) * (p[2] - 1.0) > 0.04 && p[2] < 2.0;
  });
  FlowVolumeSettings settings = Steps(3.0, 96);
  settings.ObstacleLevels = 4;
  settings.FarthestObstacle = 10.0;
  const auto mesh = Build(field, Square(0.4, 4), settings);
  const double atBall = pi * 0.04 * 2.0 + 2.0 / 3.0 * pi * 0.008;
  const double atEdge = (0.64 - pi * 0.04) * 1.0;
  EXPECT_NEAR(mesh.Report.ObstacleMass, atBall, 0.1 * atBall);
  EXPECT_NEAR(mesh.Report.LostMass - mesh.Report.ObstacleMass, atEdge, 0.1 * atEdge);
  settings.FarthestObstacle = 0.05; // less than the ball is thick
  const auto shorter = Build(field, Square(0.4, 4), settings);
  EXPECT_LT(shorter.Report.ObstacleMass, 0.3 * atBall);
}

TEST(SmokeConformity, FlowsAroundABall)
{
  FlowVolumeSettings settings;
  settings.Duration = 2.0;
  settings.TimeStep = 1.0 / 16.0;
  settings.MaximumEdgeLength = 0.2;
  settings.MinimumEdgeLength = 0.04;
  const auto mesh = Build(AroundBall(), Square(0.41, 5), settings);
  ExpectWhole(mesh);
  EXPECT_LT(mesh.Report.LostMass, 0.05 * mesh.Report.EmittedMass);
  EXPECT_NEAR(TotalVolume(mesh), mesh.Report.KeptMass, 0.02 * mesh.Report.KeptMass);
}

TEST(SmokeConformity, EndsAtTheEdgeOfTheDataAndAtNotANumber)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FormulaField box([nan](const Vector3& p, Vector3& v) {
    v = { { 0.3, 0, p[2] > 1.2 ? nan : 1.0 } };
    return p[0] < 0.6;
  });
  FlowVolumeSettings settings = Steps(2.0, 32);
  settings.MinimumEdgeLength = 0.05;
  settings.FarthestObstacle = 10.0;
  const auto mesh = Build(box, Square(0.4, 4), settings);
  EXPECT_GT(mesh.Report.LostMass, 0.0);
  EXPECT_EQ(mesh.Report.ObstacleMass, 0.0); // nothing is behind the edge
  for (const Vector3& p : mesh.Points)
  {
    EXPECT_LT(p[0], 0.6);
    EXPECT_LE(p[2], 1.2);
  }
  ExpectWhole(mesh);
}

TEST(SmokeConformity, APolygonPartlyOutsideEmitsWhereItIsInside)
{
  const FormulaField half([](const Vector3& p, Vector3& v) {
    v = { { 0, 0, 1 } };
    return p[0] <= 0.0;
  });
  const auto mesh = Build(half, Square(0.4, 4), Steps(1.0, 4));
  EXPECT_TRUE(mesh.Report.StartedOutside);
  EXPECT_NEAR(TotalVolume(mesh), 0.32, 1e-12);
  ExpectWhole(mesh);
  const FormulaField nowhere([](const Vector3&, Vector3&) { return false; });
  const auto none = Build(nowhere, Square(0.4, 4), Steps(1.0, 4));
  EXPECT_TRUE(none.Report.StartedOutside);
  EXPECT_TRUE(none.Points.empty());
}

TEST(SmokeConformity, AgainstTheFlowOrBothWaysIsStillPositive)
{
  const auto against = Everywhere([](double, double, double) { return Vector3{ { 0, 0, -1 } }; });
  const auto down = Build(against, SmallTriangle(3), Steps(1.0, 4));
  EXPECT_NEAR(TotalVolume(down), 0.02, 1e-15);
  ExpectWhole(down);
  const auto both = Everywhere([](double x, double, double) {
    return Vector3{ { 0, 0, x - 0.03 } };
  });
  const auto mesh = Build(both, Square(0.4, 5), Steps(1.0, 4));
  EXPECT_GT(mesh.Report.ParallelTriangles, 0u);
  // The integral of |x - .03| over the square.
  EXPECT_NEAR(mesh.Report.Flux, 0.8 * (0.43 * 0.43 + 0.37 * 0.37) / 2.0, 0.01 * 0.13);
  ExpectWhole(mesh);
  const auto along = Everywhere([](double, double, double) { return Vector3{ { 1, 0.5, 0 } }; });
  EXPECT_TRUE(Build(along, Square(0.4, 5), Steps(1.0, 4)).Tetrahedra.empty());
  const auto still = Everywhere([](double, double, double) { return Vector3{}; });
  EXPECT_TRUE(Build(still, Square(0.4, 5), Steps(1.0, 4)).Tetrahedra.empty());
}

TEST(SmokeConformity, PointsAtRestStayOnePoint)
{
  const auto wall = Everywhere([](double x, double, double) {
    return Vector3{ { 0, 0, x + 0.4 } };
  });
  FlowVolumeSettings settings = Steps(1.0, 8);
  settings.MaximumEdgeLength = 0.3;
  const auto mesh = Build(wall, Square(0.4, 4), settings);
  EXPECT_NEAR(TotalVolume(mesh), 0.256, 1e-12);
  ExpectWhole(mesh);
}

TEST(SmokeConformity, StopsAtTheLimitAndOnRequest)
{
  FlowVolumeSettings settings = Steps(3.0, 30);
  settings.MaximumEdgeLength = 0.05;
  settings.MaximumNumberOfTetrahedra = 3000;
  const auto full = Build(Spreading(), SmallTriangle(4), settings);
  EXPECT_TRUE(full.Report.LimitReached);
  EXPECT_LE(full.Tetrahedra.size(), 3000u);
  EXPECT_GT(full.Tetrahedra.size(), 500u);
  ExpectWhole(full);
  settings.MaximumEdgeLength = 1e-7; // the polygon alone would need millions
  const auto none = Build(Spreading(), SmallTriangle(4), settings);
  EXPECT_TRUE(none.Report.LimitReached);
  EXPECT_TRUE(none.Tetrahedra.empty());
  int calls = 0;
  const auto stopped = BuildSteadyVolume(
    Uniform(), SmallTriangle(4), Steps(1.0, 10), 0.0, [&calls](double) { return ++calls < 4; });
  EXPECT_TRUE(stopped.Report.Stopped);
  EXPECT_NEAR(TotalVolume(stopped), 0.02 * 0.3, 1e-15);
  ExpectWhole(stopped);
}

TEST(SmokeConformity, HoldsFarFromTheOrigin)
{
  const auto field = Everywhere([](double x, double y, double) {
    return Vector3{ { x - 6371000.0, -y, 1.0 } };
  });
  const auto polygon =
    Triangle({ { 6371000.3, 0.3, 1e6 } }, { { 0.2, 0, 0 } }, { { 0, 0.2, 0 } }, 4);
  FlowVolumeSettings settings = Steps(1.0, 16);
  settings.MaximumEdgeLength = 0.1;
  const auto mesh = Build(field, polygon, settings);
  EXPECT_NEAR(TotalVolume(mesh), 0.02, 1e-4);
  ExpectWhole(mesh);
}
