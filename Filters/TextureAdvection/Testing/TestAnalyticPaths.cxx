// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Flows of which the paths are known, or known to many digits, and the order of each method in
// them.
#include "ParticleIntegrator.h"

#include <gtest/gtest.h>

#include <functional>

using namespace nephoscope;

namespace
{
constexpr double PI = 3.14159265358979323846;
constexpr double TURN = 2.0 * PI;

using Flow = std::function<Vector3(const Vector3&, double)>;

class FlowField : public VelocityField
{
public:
  explicit FlowField(Flow flow)
    : Function(std::move(flow))
  {
  }

  void Sample(const SampleBatch& batch) const override
  {
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      batch.Velocities[i] = this->Function(batch.Positions[i], batch.TimeOf(i));
      batch.Inside[i] = 1;
    }
  }

private:
  Flow Function;
};

Vector3 Follow(const Flow& flow, const Vector3& start, double from, double to, int steps,
  IntegrationMethod method)
{
  const FlowField field(flow);
  ParticleIntegrator integrator(field);
  Vector3 position = start;
  CellHint hint;
  unsigned char inside = 1;
  IntegrationSettings settings;
  settings.Method = method;
  const double h = (to - from) / steps;
  for (int n = 0; n < steps; ++n)
  {
    integrator.Advance({ &position, &hint, &inside, 1, nullptr }, from + n * h, h, settings);
  }
  return position;
}

std::vector<Vector3> UnitSquare()
{
  std::vector<Vector3> points;
  for (int i = 1; i <= 15; ++i)
  {
    for (int j = 1; j <= 15; ++j)
    {
      points.push_back({ i / 16.0, j / 16.0, 0.0 });
    }
  }
  return points;
}

Vector3 Rotation(const Vector3& p, double)
{
  return { -TURN * (p[1] - 0.5), TURN * (p[0] - 0.5), 0.0 };
}

Vector3 Rankine(const Vector3& p, double)
{
  const double x = p[0] - 0.5;
  const double y = p[1] - 0.5;
  const double r2 = x * x + y * y;
  const double speed = r2 <= 0.04 ? TURN : TURN * 0.04 / r2;
  return { -speed * y, speed * x, 0.0 };
}

Vector3 TaylorGreen(const Vector3& p, double)
{
  return { PI * std::sin(PI * p[0]) * std::cos(PI * p[1]),
    -PI * std::cos(PI * p[0]) * std::sin(PI * p[1]), 0.0 };
}

Vector3 DoubleGyre(const Vector3& p, double t)
{
  const double swing = 0.25 * std::sin(TURN / 10.0 * t);
  const double f = swing * p[0] * p[0] + (1.0 - 2.0 * swing) * p[0];
  const double slope = 2.0 * swing * p[0] + 1.0 - 2.0 * swing;
  return { -PI * 0.1 * std::sin(PI * f) * std::cos(PI * p[1]),
    PI * 0.1 * std::cos(PI * f) * std::sin(PI * p[1]) * slope, 0.0 };
}

Vector3 ABC(const Vector3& p, double)
{
  const double a = std::sqrt(3.0);
  const double b = std::sqrt(2.0);
  return { a * std::sin(p[2]) + std::cos(p[1]), b * std::sin(p[0]) + a * std::cos(p[2]),
    std::sin(p[1]) + b * std::cos(p[0]) };
}

// Largest error over the points, back from `time` to 0, against the exact place or that of many
// steps.
double Worst(const Flow& flow, const std::vector<Vector3>& points, double time, int steps,
  IntegrationMethod method, const std::function<Vector3(const Vector3&)>& exact)
{
  double worst = 0.0;
  for (const Vector3& p : points)
  {
    worst = std::max(worst, Distance(Follow(flow, p, time, 0.0, steps, method), exact(p)));
  }
  return worst;
}

void CheckOrders(const Flow& flow, const std::vector<Vector3>& points, double time, int steps,
  double atMost, const std::function<Vector3(const Vector3&)>& exact)
{
  const auto worst = [&](IntegrationMethod method, int n) {
    return Worst(flow, points, time, n, method, exact);
  };
  const double euler = std::log2(
    worst(IntegrationMethod::Euler, 32 * steps) / worst(IntegrationMethod::Euler, 64 * steps));
  EXPECT_NEAR(euler, 1.0, 0.25);
  const double coarse = worst(IntegrationMethod::RungeKutta4, steps);
  const double fine = worst(IntegrationMethod::RungeKutta4, 2 * steps);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.4);
  EXPECT_LT(coarse, atMost);
  IntegrationSettings settings;
  EXPECT_LT(worst(IntegrationMethod::DormandPrince, steps), 1e-3);
}

std::function<Vector3(const Vector3&)> ManySteps(const Flow& flow, double time, int steps)
{
  return [=](const Vector3& p) {
    return Follow(flow, p, time, 0.0, steps, IntegrationMethod::RungeKutta4);
  };
}

Vector3 Itself(const Vector3& p)
{
  return p;
}
}

TEST(AnalyticPaths, ATurnInTwentyFourSteps)
{
  const Flow flow = [](const Vector3& p, double) { return Vector3{ -p[1], p[0], 0.0 }; };
  const Vector3 start = { 1.0, 0.0, 0.0 };
  const Vector3 euler = Follow(flow, start, 0.0, TURN, 24, IntegrationMethod::Euler);
  EXPECT_NEAR(std::hypot(euler[0], euler[1]) / 2.2155631920333207, 1.0, 1e-9);
  const Vector3 runge = Follow(flow, start, 0.0, TURN, 24, IntegrationMethod::RungeKutta4);
  EXPECT_NEAR(Distance(runge, start) / 0.00024579146521042767, 1.0, 1e-6);
}

TEST(AnalyticPaths, RotationOfTheUnitSquare)
{
  CheckOrders(Rotation, UnitSquare(), 1.0, 48, 1e-5, Itself);
  EXPECT_NEAR(
    Worst(Rotation, UnitSquare(), 1.0, 24, IntegrationMethod::RungeKutta4, Itself) / 1.52e-4, 1.0,
    0.02);
}

TEST(AnalyticPaths, RankineVortex)
{
  const auto exact = [](const Vector3& p) {
    const double x = p[0] - 0.5;
    const double y = p[1] - 0.5;
    const double r2 = x * x + y * y;
    const double angle = -(r2 <= 0.04 ? TURN : TURN * 0.04 / r2);
    return Vector3{ 0.5 + x * std::cos(angle) - y * std::sin(angle),
      0.5 + x * std::sin(angle) + y * std::cos(angle), 0.0 };
  };
  CheckOrders(Rankine, UnitSquare(), 1.0, 48, 4.5e-6, exact);
}

TEST(AnalyticPaths, TaylorGreenVortices)
{
  CheckOrders(TaylorGreen, UnitSquare(), 1.0, 50, 2.5e-5, ManySteps(TaylorGreen, 1.0, 1600));
  const auto stream = [](const Vector3& p) { return std::sin(PI * p[0]) * std::sin(PI * p[1]); };
  double drift = 0.0;
  for (const Vector3& p : UnitSquare())
  {
    const Vector3 end = Follow(TaylorGreen, p, 1.0, 0.0, 100, IntegrationMethod::RungeKutta4);
    drift = std::max(drift, std::abs(stream(end) - stream(p)));
  }
  EXPECT_LT(drift, 3e-7);
}

TEST(AnalyticPaths, DoubleGyre)
{
  const auto at = [](double x, double y) {
    return Follow(DoubleGyre, { x, y, 0.0 }, 0.0, 10.0, 2000, IntegrationMethod::RungeKutta4);
  };
  EXPECT_NEAR(at(1.0, 0.25)[0] / 0.47328081941716577, 1.0, 1e-6);
  EXPECT_NEAR(at(1.0, 0.25)[1] / 0.3195194348064797, 1.0, 1e-6);
  EXPECT_LT(Distance(at(0.5, 0.5), { 0.05055053, 0.11102015, 0.0 }), 2e-8);
  EXPECT_LT(Distance(at(1.5, 0.25), { 1.26834471, 0.35072684, 0.0 }), 2e-8);
  const std::vector<Vector3> points = { { 0.4, 0.3, 0.0 }, { 1.2, 0.6, 0.0 }, { 1.7, 0.4, 0.0 } };
  CheckOrders(DoubleGyre, points, 10.0, 100, 1e-4, ManySteps(DoubleGyre, 10.0, 4000));
}

TEST(AnalyticPaths, ArnoldBeltramiChildress)
{
  const Vector3 end =
    Follow(ABC, { 1.0, 1.0, 1.0 }, 0.0, 2.0, 2000, IntegrationMethod::RungeKutta4);
  const double expected[3] = { 2.991809945538757, 3.6164723054780463, 0.41907363526702046 };
  for (std::size_t c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(end[c] / expected[c], 1.0, 1e-6);
  }
  std::vector<Vector3> points;
  for (int i = 0; i < 27; ++i)
  {
    points.push_back({ 2.0 * (i % 3), 2.0 * (i / 3 % 3), 2.0 * (i / 9) });
  }
  CheckOrders(ABC, points, 2.0, 40, 2e-5, ManySteps(ABC, 2.0, 1280));
}
