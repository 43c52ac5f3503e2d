// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The coefficients of Runge-Kutta methods. Plain C++17.
#ifndef nephoscope_RungeKuttaTables_h
#define nephoscope_RungeKuttaTables_h

namespace nephoscope
{
// First order: one slope, that of the start.
struct EulerMethod
{
  static constexpr int StageCount = 1;
  static constexpr double Fractions[1] = { 0.0 };
  static constexpr double Stages[1][1] = { { 0.0 } };
  static constexpr double Weights[1] = { 1.0 };
};

// The classical method of fourth order: row s of Stages makes the probe of stage s from the slopes
// before it.
struct RungeKutta4
{
  static constexpr int StageCount = 4;
  static constexpr double Fractions[4] = { 0.0, 0.5, 0.5, 1.0 };
  static constexpr double Stages[4][4] = { { 0.0 }, { 0.5 }, { 0.0, 0.5 }, { 0.0, 0.0, 1.0 } };
  static constexpr double Weights[4] = { 1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0 };
};

// DormandPrince1980, the pair RK5(4)7M: fifth order with an embedded fourth. The last stage is the
// first one of the next step.
struct DormandPrince54
{
  static constexpr int StageCount = 7;
  static constexpr double Fractions[7] = { 0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0 };
  static constexpr double Stages[7][7] = { { 0.0 }, { 0.2 }, { 3.0 / 40.0, 9.0 / 40.0 },
    { 44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0 },
    { 19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0 },
    { 9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0 },
    { 35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0 } };
  // Fifth order less fourth.
  static constexpr double Errors[7] = { 71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0,
    -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0 };
};
}

#endif
