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
// v(x, t) = (1 - w) first(x) + w second(x) with w = (t - firstTime) / (secondTime - firstTime),
// held at 0 and 1 outside the two times. A position is inside if it is inside both fields, or
// inside the one that has all the weight. The two may be of different grids: the hint keeps a cell
// of each. Both must outlive this object.
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
    bool onlyFirst = true;
    bool onlySecond = true;
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      const double weight = this->SecondWeight(batch.TimeOf(i));
      onlyFirst = onlyFirst && weight == 0.0;
      onlySecond = onlySecond && weight == 1.0;
    }
    if (onlyFirst)
    {
      this->First.Sample(batch);
      return;
    }
    const std::vector<CellHint> before(batch.Hints, batch.Hints + batch.Count);
    if (!onlySecond)
    {
      this->First.Sample(batch);
    }
    this->AddSecond(batch, before);
  }

private:
  void AddSecond(const SampleBatch& batch, const std::vector<CellHint>& before) const
  {
    std::vector<CellHint> hints(batch.Count);
    std::vector<Vector3> velocities(batch.Count);
    std::vector<unsigned char> inside(batch.Count);
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      hints[i] = HintOfSecond(before[i], batch.Hints[i]);
    }
    this->Second.Sample({ batch.Count, batch.Positions, batch.Time, velocities.data(),
      inside.data(), hints.data(), batch.Times });
    for (std::size_t i = 0; i < batch.Count; ++i)
    {
      batch.Hints[i].SecondCell = hints[i].Cell;
      batch.Hints[i].SecondBlock = hints[i].Block;
      const double weight = this->SecondWeight(batch.TimeOf(i));
      if (weight == 0.0)
      {
        continue;
      }
      batch.Inside[i] = inside[i] && (weight == 1.0 || batch.Inside[i]);
      for (std::size_t c = 0; batch.Inside[i] && c < 3; ++c)
      {
        const double first = weight == 1.0 ? 0.0 : (1.0 - weight) * batch.Velocities[i][c];
        batch.Velocities[i][c] = first + weight * velocities[i][c];
      }
    }
  }

  double SecondWeight(double time) const
  {
    const double span = this->SecondTime - this->FirstTime;
    return span == 0.0 ? 0.0 : std::clamp((time - this->FirstTime) / span, 0.0, 1.0);
  }

  // Fields of the same grid were in the same cell before, so the cell that the first has found is
  // the best hint.
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
