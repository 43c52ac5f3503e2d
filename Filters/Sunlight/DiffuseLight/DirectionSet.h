// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions and their solid angles: Gauss-Legendre in the cosine of the zenith angle of each
// hemisphere, even in azimuth. Plain C++17.
#ifndef nephoscope_DirectionSet_h
#define nephoscope_DirectionSet_h

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nephoscope
{
struct Direction
{
  float X, Y, Z; // in which light goes
  float Weight;  // steradians
};

struct AngleCounts
{
  int Zenith, Azimuth; // 0: automatic
};

// Small grids get more directions: up to 120,000 points the light takes about 1 s of processor
// time.
inline AngleCounts AnglesFor(AngleCounts asked, std::size_t points)
{
  const AngleCounts automatic = points <= 20000 ? AngleCounts{ 6, 8 }
    : points <= 120000                          ? AngleCounts{ 4, 6 }
                                                : AngleCounts{ 3, 4 };
  return { asked.Zenith > 0 ? asked.Zenith : automatic.Zenith,
    asked.Azimuth > 0 ? asked.Azimuth : automatic.Azimuth };
}

// Nodes and weights on [0, 1] by Newton's method (AbramowitzStegun1964, 25.4.29).
inline std::vector<std::pair<double, double>> GaussLegendre(int n)
{
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < n; ++i)
  {
    double x = std::cos(3.14159265358979323846 * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 50; ++step)
    {
      double p = 1, before = 0;
      for (int k = 1; k <= n; ++k)
      {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.emplace_back(0.5 * (1 - x), 1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

// Cosines in each hemisphere, with a number of azimuth angles each; cosines with larger solid
// angles have twice as many. No direction is along an axis.
inline std::vector<Direction> DirectionSet(AngleCounts angles)
{
  std::vector<Direction> directions;
  const double twoPi = 6.28318530717958647692;
  for (const double side : { 1.0, -1.0 })
  {
    for (const auto& [mu, weight] : GaussLegendre(angles.Zenith))
    {
      const double sine = std::sqrt(1 - mu * mu);
      const int count = weight * angles.Zenith > 1.2 ? 2 * angles.Azimuth : angles.Azimuth;
      for (int a = 0; a < count; ++a)
      {
        const double angle = twoPi * (a + 0.5) / count;
        directions.push_back({ float(sine * std::cos(angle)), float(sine * std::sin(angle)),
          float(side * mu), float(twoPi / count * weight) });
      }
    }
  }
  return directions;
}
}

#endif
