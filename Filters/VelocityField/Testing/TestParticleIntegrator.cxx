// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The integrators against flows with known paths.
#include "AnalyticFlows.h"
#include "ParticleIntegrator.h"
#include "TemporalField.h"

#include <gtest/gtest.h>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
IntegrationSettings Adaptive(double tolerance)
{
  IntegrationSettings settings;
  settings.Method = IntegrationMethod::DormandPrince;
  settings.Tolerance = tolerance;
  settings.MaximumSubSteps = 20000;
  return settings;
}

// Where a particle is after `steps` steps from time 0 to `duration`.
Vector3 End(const VelocityField& field, Vector3 position, double duration, int steps,
  const IntegrationSettings& settings = {})
{
  CellHint hint;
  unsigned char inside = 1;
  ParticleIntegrator integrator(field);
  for (int k = 0; k < steps; ++k)
  {
    integrator.Advance(
      { &position, &hint, &inside, 1, nullptr }, k * duration / steps, duration / steps, settings);
  }
  EXPECT_EQ(inside, 1);
  return position;
}

struct Flow
{
  AnalyticField::Function Velocity;
  Vector3 Start;
  Vector3 End;
  double Duration;
};

// By an independent integrator of order 8, tolerance 1e-13.
const Flow ABC{ AbcFlow, { 1, 1, 1 },
  { 2.991809945538757, 3.6164723054780463, 0.41907363526702046 }, 2.0 };
const Flow GYRE{ DoubleGyre, { 1, 0.25, 0 }, { 0.47328081941716577, 0.3195194348064797, 0 }, 10.0 };
}

TEST(RungeKutta4, PlanarRotationIn24Steps)
{
  const Vector3 end = End(AnalyticField(Rotation), { 1, 0, 0 }, 1.0, 24);
  EXPECT_NEAR(Distance(end, { 1, 0, 0 }), 0.00024579146521042767, 1e-6 * 0.000246);
}

TEST(RungeKutta4, KnownPaths)
{
  for (const Flow& flow : { ABC, GYRE })
  {
    const AnalyticField field(flow.Velocity);
    EXPECT_LT(Distance(End(field, flow.Start, flow.Duration, 640), flow.End), 1e-8);
  }
}

TEST(RungeKutta4, HalfTheStepIsASixteenthOfTheError)
{
  for (const Flow& flow : { ABC, GYRE, Flow{ Rotation, { 1, 0, 0 }, { 1, 0, 0 }, 1.0 } })
  {
    const AnalyticField field(flow.Velocity);
    const double coarse = Distance(End(field, flow.Start, flow.Duration, 80), flow.End);
    const double fine = Distance(End(field, flow.Start, flow.Duration, 160), flow.End);
    EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.25);
  }
}

TEST(RungeKutta4, BackwardsReturns)
{
  const AnalyticField field(AbcFlow);
  const Vector3 there = End(field, { 1, 1, 1 }, 2.0, 320);
  EXPECT_LT(Distance(End(field, there, -2.0, 320), { 1, 1, 1 }), 1e-8);
}

TEST(DormandPrince, ErrorFollowsTheTolerance)
{
  for (const Flow& flow : { ABC, GYRE })
  {
    const AnalyticField field(flow.Velocity);
    double last = 1e9;
    for (const double tolerance : { 1e-4, 1e-6, 1e-8, 1e-10 })
    {
      const double error =
        Distance(End(field, flow.Start, flow.Duration, 4, Adaptive(tolerance)), flow.End);
      // Errors of the steps are carried along by the flow, which spreads neighbours here.
      EXPECT_LT(error, 100.0 * tolerance);
      EXPECT_LT(error, last);
      last = error;
    }
  }
}

// Errors of sub-steps fall with the fifth power of the sub-step: 1e5 times the accuracy takes ten
// times the steps.
TEST(DormandPrince, StepsGrowWithTheFifthRoot)
{
  int calls[2];
  const double tolerances[2] = { 1e-6, 1e-11 };
  for (int i = 0; i < 2; ++i)
  {
    const AnalyticField field(Rotation);
    End(field, { 1, 0, 0 }, 10.0, 1, Adaptive(tolerances[i]));
    calls[i] = field.Calls;
  }
  EXPECT_NEAR(static_cast<double>(calls[1]) / calls[0], 10.0, 1.5);
}

TEST(DormandPrince, FastParticlesTakeMoreStepsThanSlowOnes)
{
  // The angular speed grows towards the axis.
  const AnalyticField field([](const Vector3& x, double) -> Vector3 {
    const double r2 = x[0] * x[0] + x[1] * x[1];
    return { -x[1] / r2, x[0] / r2, 0.0 };
  });
  Vector3 positions[2] = { { 0.05, 0, 0 }, { 2, 0, 0 } };
  CellHint hints[2];
  unsigned char inside[2] = { 1, 1 };
  double subSteps[2] = { 0.0, 0.0 };
  ParticleIntegrator(field).Advance(
    { positions, hints, inside, 2, subSteps }, 0.0, 1.0, Adaptive(1e-9));
  for (int i = 0; i < 2; ++i)
  {
    const double r = i == 0 ? 0.05 : 2.0;
    EXPECT_TRUE(inside[i]);
    EXPECT_LT(Distance(positions[i], { r * std::cos(1 / (r * r)), r * std::sin(1 / (r * r)), 0 }),
      i == 0 ? 1e-4 : 1e-8);
  }
  EXPECT_LT(100.0 * subSteps[0], subSteps[1]);
}

TEST(ParticleIntegrator, AParticleThatLeavesKeepsItsPositionAndIsLeftAlone)
{
  for (const auto& settings : { IntegrationSettings{}, Adaptive(1e-8) })
  {
    const AnalyticField field(
      [](const Vector3&, double) {
        return Vector3{ 1, 0, 0 };
      },
      [](const Vector3& x) { return x[0] <= 0.75; }, false);
    Vector3 positions[2] = { { 0.5, 0, 0 }, { -5, 0, 0 } };
    CellHint hints[2];
    unsigned char inside[2] = { 1, 1 };
    const Particles particles{ positions, hints, inside, 2, nullptr };
    ParticleIntegrator integrator(field);
    integrator.Advance(particles, 0.0, 0.5, settings);
    EXPECT_FALSE(inside[0]);
    EXPECT_EQ(positions[0], (Vector3{ 0.5, 0, 0 }));
    EXPECT_TRUE(inside[1]);
    EXPECT_NEAR(positions[1][0], -4.5, 1e-12);
    positions[0][0] = 0.0; // inside again, but it has left
    integrator.Advance(particles, 0.5, 0.5, settings);
    EXPECT_EQ(positions[0], (Vector3{ 0, 0, 0 }));
    inside[1] = 0;
    const int calls = field.Calls;
    integrator.Advance(particles, 1.0, 0.5, settings);
    EXPECT_EQ(field.Calls, calls); // nobody is left
  }
}

// A long step probes far outside although the path turns back before.
TEST(DormandPrince, AProbeOutsideIsNotALeave)
{
  const AnalyticField field(
    Rotation, [](const Vector3& x) { return x[0] * x[0] + x[1] * x[1] < 1.01; });
  EXPECT_LT(Distance(End(field, { 1, 0, 0 }, 1.0, 1, Adaptive(1e-9)), { 1, 0, 0 }), 1e-6);
}

TEST(DormandPrince, NoFlowIsOneStepAndHopelessFlowEnds)
{
  const AnalyticField still([](const Vector3&, double) { return Vector3{}; });
  EXPECT_EQ(End(still, { 1, 2, 3 }, 10.0, 1, Adaptive(1e-12)), (Vector3{ 1, 2, 3 }));
  const AnalyticField noise([](const Vector3& x, double) {
    return Vector3{ std::sin(1e9 * x[0] + 1.0), std::cos(1e9 * x[1]), 1.0 };
  });
  Vector3 position{ 0.1, 0.2, 0.3 };
  CellHint hint;
  unsigned char inside = 1;
  ParticleIntegrator(noise).Advance(
    { &position, &hint, &inside, 1, nullptr }, 0.0, 1.0, Adaptive(1e-12));
  EXPECT_FALSE(inside);
}

TEST(TemporalField, LinearInTimeAndHeldOutside)
{
  const AnalyticField first([](const Vector3&, double) { return Vector3{ 1, 0, 2 }; });
  const AnalyticField second(
    [](const Vector3&, double) {
      return Vector3{ 3, 4, -2 };
    },
    [](const Vector3& x) { return x[0] < 1.0; });
  const TemporalField field(first, 10.0, second, 20.0);
  const double times[5] = { 5.0, 10.0, 12.5, 20.0, 30.0 };
  const Vector3 expected[5] = { { 1, 0, 2 }, { 1, 0, 2 }, { 1.5, 1, 1 }, { 3, 4, -2 },
    { 3, 4, -2 } };
  Vector3 positions[5] = {};
  Vector3 together[5];
  CellHint hints[5];
  unsigned char inside[5];
  field.Sample({ 5, positions, 0.0, together, inside, hints, times });
  for (int i = 0; i < 5; ++i)
  {
    Vector3 alone;
    field.Sample({ 1, positions, times[i], &alone, inside, hints });
    EXPECT_LT(Distance(alone, expected[i]), 1e-15);
    EXPECT_EQ(alone, together[i]);
  }
  // Inside only the first: inside as long as it has all the weight.
  const Vector3 outside{ 2, 0, 0 };
  for (const double time : { 10.0, 15.0, 20.0 })
  {
    Vector3 velocity;
    field.Sample({ 1, &outside, time, &velocity, inside, hints });
    EXPECT_EQ(inside[0], time == 10.0);
  }
}

// x' = t from 0 to 2: the field between v = 0 and v = 2 is exact for both methods.
TEST(TemporalField, ParticlesSeeTheTimeOfTheirStages)
{
  const AnalyticField first([](const Vector3&, double) { return Vector3{}; });
  const AnalyticField second([](const Vector3&, double) { return Vector3{ 2, 0, 0 }; });
  const TemporalField field(first, 0.0, second, 2.0);
  for (const auto& settings : { IntegrationSettings{}, Adaptive(1e-9) })
  {
    EXPECT_NEAR(End(field, { 0, 0, 0 }, 2.0, 3, settings)[0], 2.0, 1e-12);
  }
}
