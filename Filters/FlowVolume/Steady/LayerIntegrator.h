// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a front moved along a steady flow, by threads where they are many.
#ifndef nephoscope_LayerIntegrator_h
#define nephoscope_LayerIntegrator_h

#include "AdvanceParticles.h"
#include "SmokeFront.h"
#include "SmokeGeometry.h"

namespace nephoscope
{
// Where the points of a front have got to.
struct ArrivedPoints
{
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
  std::vector<unsigned char>
    Inside; // 0: left the field, met a blanked cell or values that are not finite
};

class LayerIntegrator
{
public:
  LayerIntegrator(const VelocityField& field, const FlowVolumeSettings& settings, double time)
    : Field(field)
    , Time(time)
  {
    this->Method.Method =
      settings.Adaptive ? IntegrationMethod::DormandPrince : IntegrationMethod::RungeKutta4;
    this->Method.Tolerance = settings.Tolerance;
  }

  // The tolerance was relative to this, the longest edge of the polygon.
  void SetLength(double length) { this->Method.Tolerance *= length > 0.0 ? length : 1.0; }

  // Moves the points of the front from number `first` on; those before have been moved.
  void Advance(const SmokeFront& front, double step, ArrivedPoints& top, std::size_t first = 0)
  {
    const std::size_t count = front.Positions.size();
    const auto start = static_cast<std::ptrdiff_t>(first);
    top.Positions.resize(first);
    top.Positions.insert(
      top.Positions.end(), front.Positions.begin() + start, front.Positions.end());
    top.Hints.resize(first);
    top.Hints.insert(top.Hints.end(), front.Hints.begin() + start, front.Hints.end());
    top.Inside.resize(first);
    top.Inside.resize(count, 1);
    Particles particles;
    particles.Positions = top.Positions.data() + first;
    particles.Hints = top.Hints.data() + first;
    particles.Inside = top.Inside.data() + first;
    particles.Count = count - first;
    AdvanceParticles(this->Field, particles, this->Time, step, this->Method);
    for (std::size_t i = first; i < count; ++i)
    {
      top.Inside[i] = top.Inside[i] && IsFinite(top.Positions[i]);
    }
  }

private:
  const VelocityField& Field;
  double Time;
  IntegrationSettings Method;
};
}

#endif
