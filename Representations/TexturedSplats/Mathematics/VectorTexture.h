// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Constants and phases of what is drawn on a vector splat: streaks that move along the vector, or
// an anti-aliased line segment (CrawfisMax1993; MaxCrawfisBecker1993, section 3).
// VectorTexture.glsl draws it. Plain C++17.
#ifndef nephoscope_VectorTexture_h
#define nephoscope_VectorTexture_h

#include <cmath>

namespace nephoscope
{
// Streaks like comets along x: a sharp, round head in front, a tail that narrows and fades, so that
// a still tells where the vector points. Rows of them, a fixed distance apart, each at a place of
// its own; they move along +x as the phase grows.
namespace streaks
{
constexpr double golden = 0.6180339887498949; // of a period from row to row, as uneven as can be
constexpr double tailEnd = 0.35;              // width of the tail's end, of the head's
constexpr double nose = 3.0;     // standard deviations of the head that are kept in front of it
constexpr double roundDot = 1.6; // width of a vector that points at the eye, of the head's
constexpr double coarse = 1.5,
                 fine = 4.0; // pixels: finer patterns are their mean, coarser ones themselves
constexpr double steep = 4.0,
                 flat = 12.0; // period over width: shorter ones are round dots, longer ones streaks
}

struct LineSegment
{
  double Length = 3.0; // pixels, as is everything here
  double Width = 1.0;
  double FilterWidth = 0.5; // standard deviation of the gaussian pixel filter
};

// A segment that moves along its vector: in one period by the travel, about the place of its splat.
// In the first part of a period it fades in, while the one before it, a travel ahead, fades out:
// together they are as opaque as one, always.
constexpr double segmentFade = 0.25; // of a period

// Phase of a splat after a step of time: accumulated, so that it does not jump when the speed
// changes. In [0, 1).
inline double AdvancePhase(double phase, double speed, double period, double step)
{
  const double next = phase + (period > 0.0 ? speed * step / period : 0.0);
  return next - std::floor(next);
}

// A phase as one of a number of stored textures; 0: as it is.
inline double StoredPhase(double phase, int steps)
{
  const double stored = steps > 0 ? std::round(phase * steps) / steps : phase;
  return stored - std::floor(stored);
}
}

#endif
