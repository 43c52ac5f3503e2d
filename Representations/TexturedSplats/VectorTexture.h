// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn on a vector splat: a windowed wave that moves along the vector, or an anti-aliased line segment. Plain C++17.
#ifndef nephoscope_VectorTexture_h
#define nephoscope_VectorTexture_h

#include "SplatKernel.h"

#include <cmath>

namespace nephoscope
{
// Streaks along x, a fixed distance apart, each with a dash of its own place that moves along +x as the phase grows. Period 1
// in `along`; values from 0 to 1; the mean over a cycle depends on y alone.
namespace streaks
{
constexpr double spacing = 0.4; // between streaks, cells
constexpr double width = 0.12;  // standard deviation across, cells
constexpr double golden =
  0.6180339887498949; // offsets of neighbouring streaks, as uneven as can be

inline double Dash(double along)
{
  constexpr double twoPi = 6.283185307179586;
  const double wave = 0.5 + 0.5 * std::cos(twoPi * along);
  return wave * wave;
}

inline double Value(double along, double y)
{
  const double row = std::round(y / spacing);
  const double across = (y - row * spacing) / width;
  return std::exp(-0.5 * across * across) * Dash(along + golden * row);
}
}

// The window is the footprint, whose lattice sum is flat; the streaks move through it, so that phase 1 is phase 0 again.
inline double VectorTexture(double x, double y, double period, double phase)
{
  return cubic_kernel::Footprint(std::hypot(x, y)) * streaks::Value(x / period - phase, y);
}

struct LineSegment
{
  double Length = 3.0; // pixels, as is everything here
  double Width = 1.0;
  double FilterWidth = 0.5; // standard deviation of the gaussian pixel filter
};

// Share of a pixel that a segment along x, about the origin, covers: exact for a gaussian filter. Its integral is length times width.
inline double SegmentCoverage(const LineSegment& segment, double x, double y)
{
  const double s = 1.0 / (segment.FilterWidth * std::sqrt(2.0));
  const double along =
    std::erf((x + 0.5 * segment.Length) * s) - std::erf((x - 0.5 * segment.Length) * s);
  const double across =
    std::erf((y + 0.5 * segment.Width) * s) - std::erf((y - 0.5 * segment.Width) * s);
  return 0.25 * along * across;
}

// Phase of a splat after a step of time: accumulated, so that it does not jump when the speed changes. In [0, 1).
inline double AdvancePhase(double phase, double speed, double period, double step)
{
  const double next = phase + speed * step / period;
  return next - std::floor(next);
}
}

#endif
