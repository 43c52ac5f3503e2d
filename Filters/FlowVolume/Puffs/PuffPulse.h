// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Puffs of smoke: how much smoke there is along a flow volume, as a periodic function of age minus
 * time (MaxCrawfisBecker1993 Sec. 6).
 *
 * With the phase x = (age - time) / period, taken to [-1/2, 1/2), and the width w, a share of the
 * period,
 *   shape(x) = cos^2(pi x / w) for |x| < w / 2, else 0
 *   pulse(x) = scale * (floor + (1 - floor) * shape(x))
 * The shape has a continuous first derivative for every w, and all derivatives are continuous for w
 * = 1. The mean over a period is that of the shape, w / 2, as floor + (1 - floor) w / 2, times the
 * scale. The crest is where age = time + n period: it ages one second per second, which is to say
 * that it moves with the smoke.
 */
#ifndef nephoscope_PuffPulse_h
#define nephoscope_PuffPulse_h

#include <cmath>

namespace nephoscope
{
struct PuffPulse
{
  double Period = 1.0; // s, positive
  double Width = 0.5;  // share of the period, in (0, 1]
  double Floor = 0.1;  // in [0, 1]: what stays between puffs; 1: no puffs
  double Scale = 1.0;  // of the whole; 1: crests are 1

  // In [-1/2, 1/2); 0 at the crest of a puff.
  double Phase(double age, double time) const
  {
    // The time is reduced first: a time of centuries would leave few digits of its difference to an
    // age.
    const double periods = (age - std::remainder(time, this->Period)) / this->Period;
    const double phase = periods - std::floor(periods + 0.5);
    return phase < 0.5 ? phase : -0.5;
  }

  double Shape(double phase) const
  {
    if (std::abs(phase) >= 0.5 * this->Width)
    {
      return 0.0;
    }
    const double c = std::cos(3.14159265358979323846 * phase / this->Width);
    return c * c;
  }

  double operator()(double age, double time) const
  {
    return this->Scale * (this->Floor + (1.0 - this->Floor) * this->Shape(this->Phase(age, time)));
  }

  // Over a period.
  double Mean() const
  {
    return this->Scale * (this->Floor + (1.0 - this->Floor) * 0.5 * this->Width);
  }
};
}

#endif
