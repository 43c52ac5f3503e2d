// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a step of the front was short enough. Plain C++17.
#ifndef nephoscope_StepControl_h
#define nephoscope_StepControl_h

#include "SmokeFront.h"
#include "SmokeGeometry.h"

namespace nephoscope
{
enum class StepVerdict
{
  TooLong,
  Fine,
  Calm // twice the step would do
};

struct StepLimits
{
  double Turn = 0.0; // radians between the tangents at the start and the end of the step; 0: any
  double AreaRatio = 2.0;  // of a triangle after the step and before it; 0: any
  double Divergence = 0.5; // times the step; 0: any
};

// Collects the worst of all points and triangles. Tangents are not sampled: two chords in a row of
// steps g and h differ by the turn over (g + h) / 2, and the first chord differs by that over h / 2
// from the velocity at its start (g = 0).
// In the same way the densities of two layers differ by the divergence.
class StepControl
{
public:
  StepControl(const StepLimits& limits, double previousStep, double step)
    : Limits(limits)
    , Extrapolation(2.0 * step / (previousStep + step))
    , CosineTooLong(std::cos(std::min(limits.Turn / this->Extrapolation, halfTurn)))
    , CosineCalm(std::cos(std::min(0.5 * limits.Turn / this->Extrapolation, halfTurn)))
  {
  }

  void AddPath(const Vector3& direction, const Vector3& chord)
  {
    if (this->Limits.Turn > 0.0)
    {
      // Either may be zero, at rest: then it says nothing.
      const double cosine = Dot(direction, chord), length = Norm(chord) * Norm(direction);
      this->Add(cosine < this->CosineTooLong * length, cosine < this->CosineCalm * length);
    }
  }

  void AddAreas(double squaredBelow, double squaredAbove)
  {
    const double low = std::min(squaredBelow, squaredAbove);
    const double high = std::max(squaredBelow, squaredAbove);
    const double limit = this->Limits.AreaRatio;
    if (limit > 0.0)
    {
      this->Add(high > limit * limit * low, high > limit * low);
    }
  }

  void AddDensities(double below, double above)
  {
    if (this->Limits.Divergence > 0.0 && below > 0.0 && above > 0.0)
    {
      const double divergence = std::abs(std::log(below / above)) * this->Extrapolation;
      this->Add(divergence > this->Limits.Divergence, divergence > 0.5 * this->Limits.Divergence);
    }
  }

  StepVerdict Verdict() const { return this->Worst; }

private:
  static constexpr double halfTurn = 3.14159265358979323846;

  void Add(bool tooLong, bool notCalm)
  {
    this->Worst = tooLong                              ? StepVerdict::TooLong
      : notCalm && this->Worst != StepVerdict::TooLong ? StepVerdict::Fine
                                                       : this->Worst;
  }

  StepLimits Limits;
  double Extrapolation;
  double CosineTooLong;
  double CosineCalm;
  StepVerdict Worst = StepVerdict::Calm;
};

// `above`: where the front's points arrive after `step`; `inside`: which of them do.
inline StepVerdict CheckStep(const SmokeFront& front, const std::vector<Vector3>& above,
  const std::vector<unsigned char>& inside, const StepLimits& limits, double previousStep,
  double step)
{
  StepControl control(limits, previousStep, step);
  for (std::size_t i = 0; i < above.size(); ++i)
  {
    if (inside[i])
    {
      control.AddPath(front.Directions[i], above[i] - front.Positions[i]);
    }
  }
  for (const FrontTriangle& triangle : front.Triangles)
  {
    const auto a = static_cast<std::size_t>(triangle.Points[0]);
    const auto b = static_cast<std::size_t>(triangle.Points[1]);
    const auto c = static_cast<std::size_t>(triangle.Points[2]);
    if (!inside[a] || !inside[b] || !inside[c])
    {
      continue;
    }
    const auto& p = front.Positions;
    const Vector3 below = AreaVector(p[a], p[b], p[c]);
    const Vector3 top = AreaVector(above[a], above[b], above[c]);
    control.AddAreas(Dot(below, below), Dot(top, top));
    const double volume = PrismVolume(p[a], p[b], p[c], above[a], above[b], above[c]);
    control.AddDensities(triangle.Density, volume > 0.0 ? triangle.Mass * step / volume : 0.0);
  }
  return control.Verdict();
}
}

#endif
