// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn on a vector splat, in double precision: the reference for VectorTexture.glsl. Plain
// C++17.
#ifndef nephoscope_VectorTextureValues_h
#define nephoscope_VectorTextureValues_h

#include "VectorTexture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace streaks
{
// One unit of length for all, as it is seen: period and tail are foreshortened.
struct Shape
{
  double Period = 3.0;
  double Tail = 1.5;  // length of the streak behind its head
  double Width = 0.1; // standard deviation across
  double Spacing = 1.0;
  double Pixel = 0.0; // size of a pixel
};

inline double SmoothStep(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Standard deviation of a gaussian pixel.
inline double PixelFilter(const Shape& shape)
{
  return 0.4 * shape.Pixel;
}

inline double Hypot(double a, double b)
{
  return std::sqrt(a * a + b * b);
}

// One streak whose head is at the origin; across, and in front of the head, a gaussian that is
// blurred by the pixel's.
inline double Comet(const Shape& shape, double behind, double across)
{
  const double t = std::clamp(behind / shape.Tail, 0.0, 1.0);
  const double width = shape.Width * (1.0 - (1.0 - tailEnd) * t);
  const double blurred = Hypot(width, PixelFilter(shape));
  const double ahead = std::min(behind, 0.0);
  return (1.0 - t) * width / blurred *
    std::exp(-0.5 * (across * across + ahead * ahead) / (blurred * blurred));
}

// Share of a streak's peak that is its mean over rows and periods, without blur.
inline double Mean(const Shape& shape)
{
  constexpr double pi = 3.141592653589793;
  const double tail =
    std::sqrt(2.0 * pi) * shape.Width * shape.Tail * (0.5 - (1.0 - tailEnd) / 6.0);
  const double head = pi * shape.Width * shape.Width;
  return std::min(1.0, (tail + head) / (shape.Period * shape.Spacing));
}

// The rows alone. `row` moves them across, in rows.
inline double Rows(const Shape& shape, double x, double y, double phase, double row)
{
  const double place = y / shape.Spacing + row;
  const double nearest = std::round(place);
  const double lead = std::min(0.5, nose * Hypot(shape.Width, PixelFilter(shape)) / shape.Period);
  double sum = 0.0;
  for (const double r : { nearest, nearest + (place < nearest ? -1.0 : 1.0) })
  {
    const double behind = phase + golden * r - x / shape.Period + lead; // periods
    sum += Comet(
      shape, (behind - std::floor(behind) - lead) * shape.Period, (place - r) * shape.Spacing);
  }
  return std::min(sum, 1.0);
}

// A vector that points at the eye.
inline double Dot(const Shape& shape, double x, double y)
{
  const double width = roundDot * shape.Width;
  const double blurred = Hypot(width, PixelFilter(shape));
  const double peak = width / blurred;
  return peak * peak * std::exp(-0.5 * (x * x + y * y) / (blurred * blurred));
}

// The texture, 0 to 1: streaks where the vector lies across the ray, a dot where it is along it,
// the mean where pixels are too coarse.
inline double Value(const Shape& shape, double x, double y, double phase, double row)
{
  const double streaked = SmoothStep(steep, flat, shape.Period / shape.Width);
  const double pattern =
    streaked * Rows(shape, x, y, phase, row) + (1.0 - streaked) * Dot(shape, x, y);
  const double resolved = shape.Pixel > 0.0
    ? SmoothStep(
        coarse, fine, std::min(std::max(shape.Period, shape.Width), shape.Spacing) / shape.Pixel)
    : 1.0;
  return resolved * pattern + (1.0 - resolved) * Mean(shape);
}
}

// The error function, to 2e-7: AbramowitzStegun1964, 7.1.26.
inline double ErrorFunction(double x)
{
  constexpr double c[] = { 0.254829592, -0.284496736, 1.421413741, -1.453152027, 1.061405429 };
  const double t = 1.0 / (1.0 + 0.3275911 * std::abs(x));
  const double sum = t * (c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4]))));
  return std::copysign(1.0 - sum * std::exp(-x * x), x);
}

// Share of a pixel that a segment along x, about the origin, covers: exact for a gaussian filter.
// Its integral is length times width.
inline double SegmentCoverage(const LineSegment& segment, double x, double y)
{
  const double s = 1.0 / (segment.FilterWidth * std::sqrt(2.0));
  const double along =
    std::erf((x + 0.5 * segment.Length) * s) - std::erf((x - 0.5 * segment.Length) * s);
  const double across =
    std::erf((y + 0.5 * segment.Width) * s) - std::erf((y - 0.5 * segment.Width) * s);
  return 0.25 * along * across;
}

struct MovingSegment
{
  double Offset = 0.0; // along the vector, in travels
  double Weight = 1.0; // that of the one before, a travel ahead, is the rest of 1
};

inline MovingSegment MoveSegment(double phase)
{
  return { phase - 0.5 * (1.0 + segmentFade), std::min(phase / segmentFade, 1.0) };
}
}

#endif
