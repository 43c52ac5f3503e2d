// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatVectors.h"

#include "EllipsoidSplat.h"
#include "GridSamples.h"
#include "SplatClasses.h"
#include "SplatSamples.h"
#include "VectorTexture.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
double CellAlong(const SplatSamples::Jacobian& j, const std::array<float, 3>& v)
{
  return ReachAlong({ { ToDouble(j[0]), ToDouble(j[1]), ToDouble(j[2]) } }, ToDouble(v));
}

std::array<float, 3> VectorAt(vtkDataArray* vectors, vtkIdType id)
{
  double v[3];
  vectors->GetTuple(id, v);
  return { { float(v[0]), float(v[1]), float(v[2]) } };
}
}

void SplatVectors::Read(
  vtkDataSet* data, bool onCells, vtkDataArray* vectors, const SplatSamples& samples)
{
  const std::size_t count = samples.Size();
  const GridSamples grid(data, onCells);
  const auto all = static_cast<std::size_t>(vectors->GetNumberOfTuples());
  const bool first = this->Moved.size() != all;
  if (first)
  {
    this->Moved.assign(all, 0.0);
    this->KeptTime = 0;
  }
  this->Ids = samples.Ids;
  this->Vectors.resize(count);
  this->Seeds.resize(count);
  this->Speeds = SpeedCounts();
  this->NotFinite = 0;
  double cells = 0;
  std::size_t moving = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    // The place in the file: as it is relative to a centre it differs between ranks.
    const double cell = SpeedOf(samples.JacobianOf(i)[0]);
    this->Seeds[i] = nephoscope::SeedOf(PlaceOf(data, grid, onCells, samples.Ids[i]).data(), cell);
    this->Vectors[i] = VectorAt(vectors, samples.Ids[i]);
    const float speed = SpeedOf(this->Vectors[i]);
    if (!std::isfinite(speed))
    {
      this->Vectors[i] = { { 0, 0, 0 } };
      ++this->NotFinite;
    }
    else if (speed > 0)
    {
      this->Speeds.Add(speed);
      cells += CellAlong(samples.JacobianOf(i), this->Vectors[i]);
      ++moving;
    }
  }
  this->Cell = moving > 0 && cells > 0 ? cells / static_cast<double>(moving) : 1.0;
  this->Full = static_cast<float>(this->Speeds.GetFull());
  if (first || this->FirstFull <= 0)
  {
    this->FirstFull = this->Full;
    this->FirstCell = this->Cell;
  }
}

// By a number that does not depend on the other two, which the pattern is made of.
bool SplatVectors::IsShown(std::size_t sample, double share) const
{
  const double mixed = 7919.0 * this->Seeds[sample].Phase + 104729.0 * this->Seeds[sample].Rest;
  return share >= 1 || mixed - std::floor(mixed) < share;
}

void SplatVectors::Advance(double time, double period)
{
  for (std::size_t i = 0; i < this->Vectors.size(); ++i)
  {
    double& moved = this->Moved[static_cast<std::size_t>(this->Ids[i])];
    moved = AdvancePhase(moved, SpeedOf(this->Vectors[i]), period, time);
  }
}

void SplatVectors::KeepMotion(const SplatLoop& last, const SplatLoop& next)
{
  if (next.Period > 0 && next.Time == 0)
  {
    std::fill(this->Moved.begin(), this->Moved.end(), 0.0);
    this->KeptTime = 0;
  }
  else if (last.Period > 0)
  {
    this->Advance(last.Time - this->KeptTime, last.Period);
    this->KeptTime = last.Time;
  }
}

double SplatVectors::PhaseOf(
  std::size_t sample, double speed, double greatest, const SplatLoop& loop) const
{
  const double moved = loop.Period > 0 ? speed * this->PeriodsPerSpeed(loop)
    : greatest > 0                     ? loop.Share * std::round(loop.Cycles * speed / greatest)
                                       : 0.0;
  return this->Seeds[sample].Phase + this->Moved[static_cast<std::size_t>(this->Ids[sample])] +
    moved;
}

std::vector<std::array<float, 4>> SplatVectors::Pack(
  const SplatClasses& classes, const SplatLoop& loop) const
{
  std::vector<std::array<float, 4>> packed;
  packed.reserve(classes.Samples.size());
  const double greatest = loop.MaximumSpeed > 0 ? loop.MaximumSpeed : this->Full;
  for (const std::int32_t sample : classes.Samples)
  {
    const auto i = static_cast<std::size_t>(sample);
    const std::array<float, 3> v = this->IsShown(i, loop.VectorFraction)
      ? this->Vectors[i]
      : std::array<float, 3>{ { 0, 0, 0 } };
    const double phase = this->PhaseOf(i, SpeedOf(v), greatest, loop);
    packed.push_back({ { v[0], v[1], v[2], static_cast<float>(StoredPhase(phase, 0)) } });
  }
  return packed;
}

} // namespace nephoscope
