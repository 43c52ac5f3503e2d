// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Parcels of air moved through the winds of a globe. Plain C++17.
#ifndef nephoscope_GlobeSteps_h
#define nephoscope_GlobeSteps_h

#include "GlobeWinds.h"
#include "PathSettings.h"

namespace nephoscope
{
// The winds at the beginning, in the middle and at the end of a step. Winds are linear in time, so
// a step that lies between two times of a series can have them made once for all parcels.
struct StepWinds
{
  const GlobeWinds* Begin;
  const GlobeWinds* Middle;
  const GlobeWinds* End;
  double Seconds; // of the step; negative: back in time
};

class GlobeStepper
{
public:
  GlobeStepper(const GlobeColumns& columns, int levels, const PathSettings& settings)
    : Sampler(columns, levels)
    , Settings(settings)
  {
    const double width = (columns.Longitude(columns.ColumnCount() - 1) - columns.FirstLongitude()) /
      (columns.ColumnCount() - 1);
    this->LongestMove = 0.5 * width;
  }

  void Advance(GlobeParcel* parcels, std::size_t count, const StepWinds& winds) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->AdvanceOne(parcels[i], winds);
    }
  }

  // At the end of a path, what each step does at its beginning.
  void ClampLevel(GlobeParcel& parcel, const GlobeWinds& winds) const
  {
    const auto foot = this->Sampler.Locate(parcel.Direction, parcel.Hint);
    parcel.Level = this->Sampler.ClampedLevel(winds, foot, parcel.Level);
  }

  void SetHeight(GlobeParcel& parcel, const GlobeWinds& winds, double height) const
  {
    const auto foot = this->Sampler.Locate(parcel.Direction, parcel.Hint);
    parcel.Level = this->Sampler.LevelAtHeight(winds, foot, height, parcel.LevelHint);
  }

  double HeightOf(GlobeParcel& parcel, const GlobeWinds& winds) const
  {
    const auto foot = this->Sampler.Locate(parcel.Direction, parcel.Hint);
    return this->Sampler.HeightAt(winds, foot, parcel.Level, parcel.LevelHint);
  }

private:
  void AdvanceOne(GlobeParcel& parcel, const StepWinds& winds) const
  {
    const SphereState start = { { parcel.Direction[0], parcel.Direction[1], parcel.Direction[2] },
      parcel.Level };
    SphereState end;
    switch (this->Settings.Method)
    {
      case PathMethod::Euler:
        end = EulerStep(start, winds.Seconds, [&](SphereState& state, double) {
          return this->FirstStage(parcel, *winds.Begin, state);
        });
        break;
      case PathMethod::RungeKutta4:
        end = RungeKutta4Step(start, winds.Seconds, [&](SphereState& state, double fraction) {
          return fraction == 0.0
            ? this->FirstStage(parcel, *winds.Begin, state)
            : this->Rates(parcel, fraction == 1.0 ? *winds.End : *winds.Middle, state);
        });
        break;
      default:
        end = AdaptiveStep(start, winds.Seconds, this->Settings.Tolerance,
          this->Settings.LevelScale, this->LongestMove, [&](SphereState& state, double fraction) {
            return this->BlendedRates(parcel, winds, state, fraction);
          });
    }
    CountTurns(parcel, end.Direction);
    std::copy(end.Direction, end.Direction + 3, parcel.Direction);
    parcel.Level = end.Level;
  }

  // The first stage holds the parcel between the ground and the top, so that a path that would
  // leave slides along.
  SphereRates FirstStage(GlobeParcel& parcel, const GlobeWinds& winds, SphereState& state) const
  {
    const auto foot = this->Sampler.Locate(state.Direction, parcel.Hint);
    const double above = this->Sampler.FindLevel(winds.Levels, foot, state.Level, parcel.LevelHint);
    if (!winds.Ground.empty() || this->Sampler.IsAtEnd(above, parcel.LevelHint))
    {
      state.Level = this->Sampler.ClampedLevel(winds, foot, state.Level);
    }
    return Tangent(
      this->Sampler.Sample(winds, foot, state.Level, parcel.LevelHint), foot, state.Direction);
  }

  SphereRates Rates(GlobeParcel& parcel, const GlobeWinds& winds, const SphereState& state) const
  {
    const auto foot = this->Sampler.Locate(state.Direction, parcel.Hint);
    return Tangent(
      this->Sampler.Sample(winds, foot, state.Level, parcel.LevelHint), foot, state.Direction);
  }

  SphereRates BlendedRates(
    GlobeParcel& parcel, const StepWinds& winds, SphereState& state, double fraction) const
  {
    const auto foot = this->Sampler.Locate(state.Direction, parcel.Hint);
    if (fraction == 0.0)
    {
      state.Level = this->Sampler.ClampedLevel(*winds.Begin, foot, state.Level);
    }
    SphereRates rates = this->Sampler.Sample(*winds.Begin, foot, state.Level, parcel.LevelHint);
    if (winds.Begin != winds.End)
    {
      const SphereRates later =
        this->Sampler.Sample(*winds.End, foot, state.Level, parcel.LevelHint);
      for (int c = 0; c < 3; ++c)
      {
        rates.Direction[c] += fraction * (later.Direction[c] - rates.Direction[c]);
      }
      rates.Rise += fraction * (later.Rise - rates.Rise);
    }
    return Tangent(rates, foot, state.Direction);
  }

  // Beyond a border the wind is that on the border, which is tangent to the sphere there and not
  // here.
  static SphereRates Tangent(
    SphereRates rates, const GlobeWindSampler::Footprint& foot, const double p[3])
  {
    if (!foot.Inside)
    {
      const double* v = rates.Direction;
      const double along =
        (v[0] * p[0] + v[1] * p[1] + v[2] * p[2]) / (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      for (int c = 0; c < 3; ++c)
      {
        rates.Direction[c] -= along * p[c];
      }
    }
    return rates;
  }

  // The chord of a step crosses the meridian of 180 degrees where y changes its sign at a negative
  // x.
  static void CountTurns(GlobeParcel& parcel, const double to[3])
  {
    const double* from = parcel.Direction;
    const bool wasSouth = from[1] < 0.0;
    const bool isSouth = to[1] < 0.0;
    if (wasSouth != isSouth && (from[0] * to[1] - to[0] * from[1]) / (to[1] - from[1]) < 0.0)
    {
      parcel.Turns += isSouth ? 1 : -1;
    }
  }

  GlobeWindSampler Sampler;
  PathSettings Settings;
  double LongestMove;
};
}

#endif
