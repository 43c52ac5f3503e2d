// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity between two times of a series, linear in time. Plain C++17.
#ifndef nephoscope_TemporalField_h
#define nephoscope_TemporalField_h

#include "VelocityField.h"

#include <algorithm>
#include <vector>

namespace nephoscope
{
// v(x, t) = (1 - w) first(x) + w second(x) with w = (t - firstTime) / (secondTime - firstTime), held at 0 and 1
// outside the two times. A position is inside if it is inside both fields, or inside the one that has all the
// weight. The two may be of different grids: the hint keeps a cell of each. Both must outlive this object.
class TemporalField : public VelocityField
{
public:
  TemporalField(
    const VelocityField& first, double firstTime, const VelocityField& second, double secondTime)
    : First(first)
    , Second(second)
    , FirstTime(firstTime)
    , SecondTime(secondTime)
  {
  }

  bool IsLocal() const override { return this->First.IsLocal() && this->Second.IsLocal(); }

  void Sample(const SampleBatch& batch) const override
  {
    const double weight = this->SecondWeight(batch.Time);
    if (weight == 0.0)
    {
      this->First.Sample(batch);
      return;
    }
    std::vector<CellHint> hints(batch.Count);
    const bool both = weight < 1.0;
    if (both)
    {
      for (std::size_t i = 0; i < batch.Count; ++i)
      {
        hints[i] = batch.Hints[i];
      }
      this->First.Sample(batch);
    }
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      hints[i] = HintOfSecond(both ? hints[i] : batch.Hints[i], batch.Hints[i]);
    }
    std::vector<Vector3> velocities(batch.Count);
    std::vector<unsigned char> inside(batch.Count);
    this->Second.Sample({ batch.Count, batch.Positions, batch.Time, velocities.data(),
      inside.data(), hints.data() });
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      batch.Inside[i] = inside[i] && (!both || batch.Inside[i]);
      for (std::size_t c = 0; batch.Inside[i] && c < 3; ++c)
      {
        const double before = both ? (1.0 - weight) * batch.Velocities[i][c] : 0.0;
        batch.Velocities[i][c] = before + weight * velocities[i][c];
      }
      batch.Hints[i].SecondCell = hints[i].Cell;
      batch.Hints[i].SecondBlock = hints[i].Block;
    }
  }

private:
  double SecondWeight(double time) const
  {
    const double span = this->SecondTime - this->FirstTime;
    return span == 0.0 ? 0.0 : std::clamp((time - this->FirstTime) / span, 0.0, 1.0);
  }

  // Fields of the same grid were in the same cell before, so the cell that the first has found is the best hint.
  static CellHint HintOfSecond(const CellHint& before, const CellHint& found)
  {
    CellHint hint = found;
    const bool same = before.SecondCell == before.Cell && before.SecondBlock == before.Block;
    if (before.SecondCell >= 0 && !same)
    {
      hint.Cell = before.SecondCell;
      hint.Block = before.SecondBlock;
    }
    return hint;
  }

  const VelocityField& First;
  const VelocityField& Second;
  double FirstTime;
  double SecondTime;
};
}

#endif
