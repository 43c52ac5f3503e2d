// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Flows that are given by a formula.
#ifndef nephoscope_AnalyticFlows_h
#define nephoscope_AnalyticFlows_h

#include "VelocityField.h"

#include <cmath>
#include <functional>

namespace nephoscope_test
{
using nephoscope::CellHint;
using nephoscope::SampleBatch;
using nephoscope::Vector3;

class AnalyticField : public nephoscope::VelocityField
{
public:
  using Function = std::function<Vector3(const Vector3&, double)>;
  using Domain = std::function<bool(const Vector3&)>;

  explicit AnalyticField(
    Function function, Domain domain = [](const Vector3&) { return true; }, bool local = true)
    : Velocity(std::move(function))
    , Holds(std::move(domain))
    , Local(local)
  {
  }

  void Sample(const SampleBatch& batch) const override
  {
    ++this->Calls;
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      batch.Inside[i] = this->Holds(batch.Positions[i]);
      if (batch.Inside[i])
      {
        batch.Velocities[i] = this->Velocity(batch.Positions[i], batch.TimeOf(i));
      }
    }
  }

  bool IsLocal() const override { return this->Local; }

  mutable int Calls = 0; // of fields that are not local

private:
  Function Velocity;
  Domain Holds;
  bool Local;
};

constexpr double PI = 3.14159265358979323846;

// One turn in unit time about the z axis.
inline Vector3 Rotation(const Vector3& x, double)
{
  return { -2.0 * PI * x[1], 2.0 * PI * x[0], 0.0 };
}

// Arnold, Beltrami and Childress, with A = sqrt 3, B = sqrt 2, C = 1.
inline Vector3 AbcFlow(const Vector3& x, double)
{
  const double a = std::sqrt(3.0);
  const double b = std::sqrt(2.0);
  return { a * std::sin(x[2]) + std::cos(x[1]), b * std::sin(x[0]) + a * std::cos(x[2]),
    std::sin(x[1]) + b * std::cos(x[0]) };
}

// Shadden, Lekien and Marsden 2005: amplitude 0.1, epsilon 0.25, period 10.
inline Vector3 DoubleGyre(const Vector3& x, double t)
{
  const double e = 0.25 * std::sin(2.0 * PI * t / 10.0);
  const double f = e * x[0] * x[0] + (1.0 - 2.0 * e) * x[0];
  const double slope = 2.0 * e * x[0] + 1.0 - 2.0 * e;
  return { -0.1 * PI * std::sin(PI * f) * std::cos(PI * x[1]),
    0.1 * PI * std::cos(PI * f) * std::sin(PI * x[1]) * slope, 0.0 };
}

}

#endif
