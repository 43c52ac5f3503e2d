// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Phase functions as tables (Kattawar1975, BohrenHuffman1983), evenly spaced in the scattering
// angle from 0 to 180 degrees. Plain C++17.
#ifndef nephoscope_PhaseTable_h
#define nephoscope_PhaseTable_h

#include "DropletPhaseFunction.h"
#include "PhaseFunction.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nephoscope
{
enum class PhaseKind
{
  HenyeyGreenstein,
  DoubleHenyeyGreenstein,
  CloudDroplets
};

/**
 * P(cosine) of each kind, with the mean 1 over the sphere; `asymmetry` is that of a
 * Henyey-Greenstein function.
 */
inline std::vector<double> PhaseTable(PhaseKind kind, double asymmetry)
{
  if (kind == PhaseKind::CloudDroplets)
  {
    return std::vector<double>(std::begin(dropletPhaseFunction), std::end(dropletPhaseFunction));
  }
  constexpr std::size_t steps = 1800;
  std::vector<double> table(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i)
  {
    const double cosine = std::cos(3.14159265358979323846 * double(i) / steps);
    table[i] = kind == PhaseKind::HenyeyGreenstein
      ? HenyeyGreenstein(asymmetry, cosine)
      : dropletForwardShare * HenyeyGreenstein(dropletForward, cosine) +
        (1 - dropletForwardShare) * HenyeyGreenstein(dropletBackward, cosine);
  }
  return table;
}

/** The mean cosine of the scattering angle, by the trapezoidal rule. */
inline double AsymmetryOf(const std::vector<double>& table)
{
  double sum = 0, weights = 0;
  const double step = 3.14159265358979323846 / double(table.size() - 1);
  for (std::size_t i = 0; i + 1 < table.size(); ++i)
  {
    const double from = std::cos(step * double(i)), to = std::cos(step * double(i + 1));
    const double light = 0.5 * (table[i] + table[i + 1]) * (from - to);
    sum += 0.5 * (from + to) * light;
    weights += light;
  }
  return sum / weights;
}

/**
 * The phase function of light scattered twice: its Legendre coefficients are the squares of those
 * of `table`.
 */
inline std::vector<double> ScatteredTwice(const std::vector<double>& table)
{
  const std::size_t size = table.size(), terms = (size + 1) / 2;
  const double step = 3.14159265358979323846 / double(size - 1);
  std::vector<double> twice(size, 0.0), cosine(size), before(size, 0.0), now(size, 1.0);
  for (std::size_t i = 0; i < size; ++i)
  {
    cosine[i] = std::cos(step * double(i));
  }
  for (std::size_t l = 0; l < terms; ++l)
  {
    double coefficient = 0;
    for (std::size_t i = 0; i + 1 < size; ++i)
    {
      coefficient +=
        0.25 * (cosine[i] - cosine[i + 1]) * (table[i] * now[i] + table[i + 1] * now[i + 1]);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      twice[i] += double(2 * l + 1) * coefficient * coefficient * now[i];
      const double next =
        (double(2 * l + 1) * cosine[i] * now[i] - double(l) * before[i]) / double(l + 1);
      before[i] = now[i];
      now[i] = next;
    }
  }
  return twice;
}

/**
 * The factors by which a mapper multiplies single scattering: P / (1 - f) for light straight from
 * the sun, and AfterForwardScattering() for light that has been scattered into the forward peak
 * before (PhaseFunction.h). Without scaling, f is 0.
 */
inline std::vector<std::array<float, 2>> PhaseFactors(const std::vector<double>& table, bool scales)
{
  const double asymmetry = AsymmetryOf(table), forward = scales ? asymmetry * asymmetry : 0.0,
               scaled = asymmetry / (1 + asymmetry);
  const std::vector<double> twice = ScatteredTwice(table);
  std::vector<std::array<float, 2>> factors(table.size());
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double cosine = std::cos(3.14159265358979323846 * double(i) / double(table.size() - 1));
    factors[i] = { { static_cast<float>(table[i] / (1 - forward)),
      static_cast<float>(AfterForwardScattering(table[i], twice[i],
        HenyeyGreenstein(scaled, cosine), HenyeyGreenstein(scaled * scaled, cosine), forward)) } };
  }
  return factors;
}
}

#endif
