// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Short characteristics through a row of a grid, in loops without decisions, so that a processor
 * does several points at a time. Plain C++17.
 *
 * Light arrives at a point from between four points upstream: where its way last crosses a plane, a
 * neighbouring row or the point before.
 */
#ifndef nephoscope_RowSweep_h
#define nephoscope_RowSweep_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace nephoscope
{
/** exp(-x) for x >= 0, to 2e-7 of 1. */
inline float ExpOfMinus(float x)
{
  const float power = (x < 87.0f ? x : 87.0f) * -1.44269504f,
              whole = (power + 12582912.0f) - 12582912.0f;
  const float f = power - whole; // -0.5 to 0.5
  const float p = 1 +
    f *
      (0.69314718f +
        f *
          (0.24022651f +
            f * (0.05550411f + f * (0.00961813f + f * (0.00133336f + f * 0.000154035f)))));
  const std::int32_t bits = (static_cast<std::int32_t>(whole) + 127) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return p * scale;
}

/** The points of a row, or of a row upstream. */
struct SweepRow
{
  const float* Extinction;
  const float* Emission;
  float* Radiance;

  SweepRow Moved(std::ptrdiff_t by) const
  {
    return { this->Extinction + by, this->Emission + by, this->Radiance + by };
  }
};

class RowSweep
{
public:
  explicit RowSweep(int size)
    : Factor(size)
    , Rest(size)
    , Along(size)
  {
  }

  SweepRow Here, Beside, Before,
    Diagonal; ///< this row, that upstream in this plane, and both in the plane upstream
  const float*
    Rates[3]; ///< of crossing points, rows and planes, without slopes, for the points of the row
  float Slopes[3]; ///< absolute

  /**
   * Points from `first` (in the direction of light, 1 or -1), whose points upstream in the row are
   * `upstream` away.
   */
  void Run(int first, int count, int forward, std::ptrdiff_t upstream);

private:
  void FindAxes(int low, int count);

  std::vector<float> Factor, Rest;
  std::vector<std::int32_t> Along; // the axis of the plane that the way to each point last crosses
};
}

#endif
