// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far apart rays may be, in pixels, so that a picture is drawn within the time that its window
 * allots.
 */
#ifndef nephoscope_SampleDistance_h
#define nephoscope_SampleDistance_h

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{

/**
 * The time of a picture is taken as `Fixed + Rays / distance²`. Two pictures one after another with
 * different distances give both, if two such pairs agree; later pictures correct the second. The
 * first picture does not count: its shaders are compiled.
 */
class SampleDistance
{
public:
  /** Known distances, so that images keep their size from picture to picture. */
  static constexpr std::array<double, 9> Steps = { { 1, 1.5, 2, 3, 4, 6, 8, 12, 16 } };

  /** For a picture in so many seconds, at most `most`. */
  double Choose(double seconds, double most) const
  {
    // Fewer rays do not make up for what else takes time.
    const double allotted = std::max(seconds - this->Fixed, 0.5 * this->Fixed);
    const double needed = allotted > 0 ? std::sqrt(this->Rays / allotted) : 1;
    const auto enough = [&](double distance) {
      const bool finer = distance < this->LastDistance; // not to and fro between two
      return distance >= (finer ? 1.25 : 1.0) * needed || distance >= most;
    };
    const auto found = std::find_if(Steps.begin(), Steps.end(), enough);
    return std::max(std::min(found == Steps.end() ? Steps.back() : *found, most), 1.0);
  }

  /** After a picture. */
  void Measure(double seconds, double distance)
  {
    if (!this->Started)
    {
      this->Started = true;
      return;
    }
    const double share = 1 / (distance * distance);
    const double lastShare = 1 / (this->LastDistance * this->LastDistance);
    const bool changed = this->LastSeconds > 0 && std::abs(share - lastShare) > 0.1 * share;
    const double rays = changed ? (this->LastSeconds - seconds) / (lastShare - share) : -1;
    if (rays > 0)
    {
      const double found = std::max(seconds - rays * share, 0.0);
      this->Fixed = std::min(found, this->LastFixed); // one slow picture among others is none
      this->LastFixed = found;
    }
    this->Rays = std::max(seconds - this->Fixed, 0.0) / share;
    this->LastSeconds = seconds;
    this->LastDistance = distance;
  }

private:
  bool Started = false;
  double Fixed = 0, LastFixed = 0;
  double Rays = 0; // of a ray for each pixel
  double LastSeconds = 0;
  double LastDistance = 1;
};

} // namespace nephoscope

#endif
