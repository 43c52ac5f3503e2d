// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The wind over a globe at one time, on columns and rows of points at levels whose heights differ
// from column to column.
// Plain C++17.
#ifndef nephoscope_GlobeWinds_h
#define nephoscope_GlobeWinds_h

#include "GlobeColumns.h"
#include "SphereSteps.h"

#include <cstdint>

namespace nephoscope
{
// Angular velocity as a Cartesian vector of the unit sphere, tangent to it, 1/s; and the rate of
// the vertical coordinate.
// Not the longitude's and latitude's own rates: those have no limit at a pole.
struct WindVector
{
  float X = 0.0f;
  float Y = 0.0f;
  float Z = 0.0f;
  float Rise = 0.0f;
};

// The vertical coordinate is any that rises from level to level: height, radius, or pressure with
// its sign turned. Followed as such, it needs no chain rule: the motion relative to the levels,
// however they slope and move, comes of looking the levels up where the air is. (For a coordinate q
// with the rate Dq/Dt following the air, the rate of the level k would be (Dq/Dt - dq/dt|k - V .
// grad_k q) / (dq/dk).)
struct GlobeWinds
{
  // Axis 0 (columns) fastest, then rows, then levels.
  std::vector<WindVector> Vectors;
  std::vector<float> Levels;
  std::vector<float>
    Ground; // of each column and row; empty if there is none: air does not sink below it
  std::vector<float> Heights; // of each point, where the vertical coordinate is another one
};

// A moving parcel of air.
struct GlobeParcel
{
  double Direction[3]; // from the centre, unit length
  double Level = 0.0;  // vertical coordinate
  std::int32_t Turns =
    0; // how often it has crossed the meridian of 180 degrees eastwards, less westwards
  ColumnHint Hint;
  std::int32_t LevelHint = 0;
};

class GlobeWindSampler
{
public:
  GlobeWindSampler(const GlobeColumns& columns, int levels)
    : Columns(columns)
    , Row(columns.ColumnCount())
    , Layer(static_cast<std::int64_t>(columns.ColumnCount()) * columns.RowCount())
    , LevelCount(levels)
  {
  }

  struct Footprint
  {
    std::int64_t First;
    double Weights[4]; // south-west, south-east, north-west, north-east
    double Scale;
    bool Inside;
  };

  Footprint Locate(const double direction[3], ColumnHint& hint) const
  {
    const ColumnPosition column = this->Columns.Find(direction, hint);
    const double west = 1.0 - column.East;
    const double south = 1.0 - column.North;
    return { column.Column + this->Row * static_cast<std::int64_t>(column.Row),
      { west * south, column.East * south, west * column.North, column.East * column.North },
      column.Scale, column.Inside };
  }

  // Keeps a level between the ground, or the lowest level, and the highest.
  double ClampedLevel(const GlobeWinds& winds, const Footprint& foot, double level) const
  {
    const double lowest = winds.Ground.empty() ? this->SurfaceAt(winds.Levels, foot, 0)
                                               : this->Mean(winds.Ground.data() + foot.First, foot);
    const double highest = this->SurfaceAt(winds.Levels, foot, this->LevelCount - 1);
    return std::clamp(level, lowest, std::max(lowest, highest));
  }

  SphereRates Sample(
    const GlobeWinds& winds, const Footprint& foot, double level, std::int32_t& hint) const
  {
    const double above = this->FindLevel(winds.Levels, foot, level, hint);
    double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
    const WindVector* corner = winds.Vectors.data() + foot.First + hint * this->Layer;
    this->Add(corner, foot, 1.0 - above, sums);
    if (above > 0.0)
    {
      this->Add(corner + this->Layer, foot, above, sums);
    }
    return { { foot.Scale * sums[0], foot.Scale * sums[1], foot.Scale * sums[2] }, sums[3] };
  }

  // The index of the level below goes into `hint`; returned is the fraction of the way to the one
  // above. Held at the ends.
  double FindLevel(const std::vector<float>& surfaces, const Footprint& foot, double level,
    std::int32_t& hint) const
  {
    const int last = this->LevelCount - 2;
    if (last < 0)
    {
      hint = 0;
      return 0.0;
    }
    hint = std::clamp(hint, 0, last);
    double below = this->SurfaceAt(surfaces, foot, hint);
    double above = this->SurfaceAt(surfaces, foot, hint + 1);
    while (level < below && hint > 0)
    {
      --hint;
      above = below;
      below = this->SurfaceAt(surfaces, foot, hint);
    }
    while (level > above && hint < last)
    {
      ++hint;
      below = above;
      above = this->SurfaceAt(surfaces, foot, hint + 1);
    }
    const double thickness = above - below;
    return thickness > 0.0 ? std::clamp((level - below) / thickness, 0.0, 1.0) : 0.0;
  }

  double HeightAt(
    const GlobeWinds& winds, const Footprint& foot, double level, std::int32_t& hint) const
  {
    return winds.Heights.empty() ? level
                                 : this->Convert(winds.Levels, winds.Heights, foot, level, hint);
  }

  double LevelAtHeight(
    const GlobeWinds& winds, const Footprint& foot, double height, std::int32_t& hint) const
  {
    return winds.Heights.empty() ? height
                                 : this->Convert(winds.Heights, winds.Levels, foot, height, hint);
  }

  // Whether a level is at or beyond an end of those of the grid.
  bool IsAtEnd(double above, std::int32_t hint) const
  {
    return (above <= 0.0 && hint == 0) || (above >= 1.0 && hint >= this->LevelCount - 2);
  }

private:
  double Mean(const float* corner, const Footprint& foot) const
  {
    return foot.Weights[0] * corner[0] + foot.Weights[1] * corner[1] +
      foot.Weights[2] * corner[this->Row] + foot.Weights[3] * corner[this->Row + 1];
  }

  double SurfaceAt(const std::vector<float>& surfaces, const Footprint& foot, int level) const
  {
    return this->Mean(surfaces.data() + foot.First + level * this->Layer, foot);
  }

  double Convert(const std::vector<float>& from, const std::vector<float>& to,
    const Footprint& foot, double value, std::int32_t& hint) const
  {
    const double above = this->FindLevel(from, foot, value, hint);
    const double low = this->SurfaceAt(to, foot, hint);
    return above > 0.0 ? low + above * (this->SurfaceAt(to, foot, hint + 1) - low) : low;
  }

  void Add(const WindVector* corner, const Footprint& foot, double fraction, double sums[4]) const
  {
    const WindVector* const corners[4] = { corner, corner + 1, corner + this->Row,
      corner + this->Row + 1 };
    for (int c = 0; c < 4; ++c)
    {
      const double weight = fraction * foot.Weights[c];
      sums[0] += weight * corners[c]->X;
      sums[1] += weight * corners[c]->Y;
      sums[2] += weight * corners[c]->Z;
      sums[3] += weight * corners[c]->Rise;
    }
  }

  const GlobeColumns& Columns;
  std::int64_t Row;
  std::int64_t Layer;
  int LevelCount;
};
}

#endif
