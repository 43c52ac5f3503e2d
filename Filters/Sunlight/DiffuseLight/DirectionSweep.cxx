// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionSweep.h"

#include "PhaseFunction.h"
#include "RowSweep.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr float pi = 3.14159265358979f;
}

// Directions of the same zenith angle, through the grid plane by plane.
struct DirectionSweep::Cone
{
  std::size_t First, Count; // directions
  float Z, Weight;
  std::vector<float> Fluence, X, Y; // of their light
  // The sources in a plane: the part that all directions share, the changes along x and y, and what
  // multiplies them.
  std::vector<float> Even, Slopes[2], Scale;
  // For each direction, in this plane and in that upstream.
  std::vector<std::vector<float>> Radiance[2], Emission[2];

  Cone(std::size_t first, std::size_t count, const Direction& direction, const LightGrid& grid)
    : First(first)
    , Count(count)
    , Z(direction.Z)
    , Weight(direction.Weight)
  {
    for (std::vector<float>* one : { &this->Fluence, &this->X, &this->Y })
    {
      one->assign(grid.Points(), 0.0f);
    }
    for (std::vector<float>* one :
      { &this->Even, &this->Slopes[0], &this->Slopes[1], &this->Scale })
    {
      one->resize(grid.Columns());
    }
    for (const int side : { 0, 1 })
    {
      this->Radiance[side].assign(count, std::vector<float>(grid.Columns()));
      this->Emission[side].assign(count, std::vector<float>(grid.Columns()));
    }
  }
};

DirectionSweep::DirectionSweep(const LightGrid& grid, const std::vector<float>& beam,
  const std::vector<Direction>& directions, const Parallel& parallel)
  : Grid(grid)
  , Directions(directions)
  , Rows(parallel)
  , NoRates(grid.Size[0], 0.0f)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Seams[axis].assign(directions.size(),
      std::vector<float>(grid.Closed[axis] ? grid.Points() / grid.Size[axis] : 0));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Rates[axis].resize(grid.Points());
    std::transform(grid.Step.begin(), grid.Step.end(), this->Rates[axis].begin(),
      [axis](const Vector& step) { return 1 / std::max(step[axis], 1e-30f); });
  }
  this->MakeBeams(beam);
}

// The beam keeps its energy: its phase function has the mean 1 over the directions.
void DirectionSweep::MakeBeams(const std::vector<float>& transmittance)
{
  this->Beams.assign(this->Directions.size(), std::vector<float>(this->Grid.Points(), 0.0f));
  this->Rows(this->Grid.Size[2], [&](int k) {
    std::vector<float> phase(this->Directions.size());
    const std::size_t first = k * this->Grid.Columns();
    for (std::size_t p = first; p < first + this->Grid.Columns(); ++p)
    {
      const float beam = transmittance[p];
      if (beam * this->Grid.Extinction[p] <= 0)
      {
        continue;
      }
      const Vector& s = this->Grid.SunAt(p);
      float sum = 0;
      for (std::size_t d = 0; d < phase.size(); ++d)
      {
        const Direction& to = this->Directions[d];
        phase[d] = PhaseOfTwo(
          this->Grid.Asymmetry[p], this->Grid.Second[p], to.X * s[0] + to.Y * s[1] + to.Z * s[2]);
        sum += phase[d] * to.Weight;
      }
      for (std::size_t d = 0; d < phase.size(); ++d)
      {
        this->Beams[d][p] = phase[d] * 4 * pi / sum * beam;
      }
    }
  });
}

std::vector<float> DirectionSweep::GroundLight(const DiffuseField& known) const
{
  std::vector<float> up(this->Grid.Columns());
  for (std::size_t c = 0; c < up.size(); ++c)
  {
    const float direct = std::max(-this->Grid.SunAt(c)[2], 0.0f) * this->Grid.BeamAt(c);
    up[c] = static_cast<float>(this->Grid.GroundAlbedo) * (direct + std::max(known.Down(c), 0.0f));
  }
  return up;
}

// The light that each direction gets in this plane, per volume.
void DirectionSweep::Emit(Cone& cone, const DiffuseField& known, int level) const
{
  const std::size_t columns = this->Grid.Columns(), first = level * columns;
  for (std::size_t q = 0; q < columns; ++q)
  {
    const std::size_t p = first + q;
    const Vector& flux = known.Flux[p];
    const float forward = 3 * this->Grid.Asymmetry[p], second = 5 * this->Grid.Second[p],
                tilt = 3 * second * cone.Z;
    cone.Even[q] = known.Fluence[p] + forward * cone.Z * flux[2] +
      second * SecondLegendre(cone.Z) * known.SecondMoment[p];
    cone.Slopes[0][q] = forward * flux[0] + tilt * known.Tilt[p][0];
    cone.Slopes[1][q] = forward * flux[1] + tilt * known.Tilt[p][1];
    cone.Scale[q] = this->Grid.Extinction[p] * this->Grid.Albedo[p] / (4 * pi);
  }
  const float *even = cone.Even.data(), *slopeX = cone.Slopes[0].data(),
              *slopeY = cone.Slopes[1].data(), *scale = cone.Scale.data();
  for (std::size_t d = 0; d < cone.Count; ++d)
  {
    const Direction& to = this->Directions[cone.First + d];
    const float* beam = &this->Beams[cone.First + d][first];
    float* __restrict emission = cone.Emission[0][d].data();
    for (std::size_t q = 0; q < columns; ++q)
    {
      const float source = even[q] + to.X * slopeX[q] + to.Y * slopeY[q] + beam[q];
      emission[q] = std::max(source, 0.0f) * scale[q];
    }
  }
}

// The light that enters through an open side: that of the sky, from above.
float DirectionSweep::Outside(float z, std::size_t column) const
{
  return z < 0 ? this->Grid.Sky[column] / pi : 0.0f;
}

// The light of one direction in a plane. The medium continues beyond a side as at the boundary,
// unless the side is open. Light across a seam is that of the last run.
void DirectionSweep::SweepPlane(Cone& cone, std::size_t d, int level, RowSweep& sweep)
{
  const LightGrid& g = this->Grid;
  const Direction& to = this->Directions[cone.First + d];
  const int width = g.Size[0], rows = g.Size[1], alongY = to.Y > 0 ? 1 : -1,
            start = alongY > 0 ? 0 : rows - 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    sweep.Slopes[axis] = std::abs(axis == 0 ? to.X : axis == 1 ? to.Y : to.Z);
  }
  float* radiance = cone.Radiance[0][d].data();
  if (g.IsOpenSide(start, 1))
  {
    for (std::size_t q = std::size_t(start) * width, n = 0; n < std::size_t(width); ++n, ++q)
    {
      radiance[q] = this->Outside(to.Z, q);
    }
  }
  else if (!g.Closed[1])
  {
    sweep.Rates[1] = this->NoRates.data();
    this->SweepRow(cone, d, level, start, 0, sweep);
  }
  else
  {
    const int across = alongY > 0 ? rows - 2 : 1; // the row upstream, across the seam
    float *seam = &this->Seams[1][cone.First + d][std::size_t(level) * width],
          *beside = radiance + std::ptrdiff_t(across) * width;
    std::copy_n(seam, width, beside);
    sweep.Rates[1] =
      &this->Rates[1][level * g.Columns() + std::size_t(alongY > 0 ? across : 0) * width];
    this->SweepRow(cone, d, level, start, across - start, sweep);
  }
  for (int b = 1; b < rows; ++b)
  {
    const int j = start + alongY * b;
    sweep.Rates[1] =
      &this->Rates[1][level * g.Columns() + std::size_t(std::min(j, j - alongY)) * width];
    this->SweepRow(cone, d, level, j, -alongY, sweep);
  }
  if (g.Closed[1])
  {
    const float* beside = radiance + std::ptrdiff_t(alongY > 0 ? rows - 2 : 1) * width;
    std::copy_n(beside, width, &this->Seams[1][cone.First + d][std::size_t(level) * width]);
    std::copy_n(radiance + std::ptrdiff_t(rows - 1 - start) * width, width,
      radiance + std::ptrdiff_t(start) * width);
  }
}

// The light of one direction in a row. The row upstream is `beside` rows away.
void DirectionSweep::SweepRow(
  Cone& cone, std::size_t d, int level, int j, int beside, RowSweep& sweep)
{
  const LightGrid& g = this->Grid;
  const Direction& to = this->Directions[cone.First + d];
  const int width = g.Size[0], alongX = to.X > 0 ? 1 : -1, start = alongX > 0 ? 0 : width - 1;
  const std::ptrdiff_t columns = g.Columns(), row = std::ptrdiff_t(j) * width,
                       p = level * columns + row, y = std::ptrdiff_t(beside) * width,
                       z = to.Z > 0 ? -columns : columns;
  float* radiance = cone.Radiance[0][d].data() + row;
  sweep.Here = { &g.Extinction[p], &cone.Emission[0][d][row], radiance };
  sweep.Beside = sweep.Here.Moved(y);
  sweep.Before = { &g.Extinction[p + z], &cone.Emission[1][d][row], &cone.Radiance[1][d][row] };
  sweep.Diagonal = sweep.Before.Moved(y);
  sweep.Rates[2] = &this->Rates[2][p + std::min<std::ptrdiff_t>(z, 0)];
  const int across = alongX > 0 ? width - 2 : 1; // the point upstream, across the seam
  float* seam = g.Closed[0] ? &this->Seams[0][cone.First + d][p / width] : nullptr;
  if (g.IsOpenSide(start, 0))
  {
    radiance[start] = this->Outside(to.Z, row + start);
  }
  else if (seam)
  {
    radiance[across] = *seam;
    sweep.Rates[0] = &this->Rates[0][p + (alongX > 0 ? across : 0)] - start;
    sweep.Run(start, 1, alongX, across - start);
  }
  else
  {
    sweep.Rates[0] = this->NoRates.data();
    sweep.Run(start, 1, alongX, 0);
  }
  sweep.Rates[0] = width > 1 ? &this->Rates[0][p] + std::min(-alongX, 0) : this->NoRates.data();
  sweep.Run(start + alongX, width - 1, alongX, -alongX);
  if (seam)
  {
    *seam = radiance[across];
    radiance[start] = radiance[width - 1 - start];
  }
}

void DirectionSweep::RunCone(
  Cone& cone, const DiffuseField& known, const std::vector<float>& ground)
{
  const int levels = this->Grid.Size[2];
  const std::size_t columns = this->Grid.Columns();
  RowSweep sweep(this->Grid.Size[0]);
  for (int c = 0; c < levels; ++c)
  {
    const int k = cone.Z > 0 ? c : levels - 1 - c;
    std::swap(cone.Radiance[0], cone.Radiance[1]);
    std::swap(cone.Emission[0], cone.Emission[1]);
    this->Emit(cone, known, k);
    for (std::size_t d = 0; d < cone.Count; ++d)
    {
      std::vector<float>& radiance = cone.Radiance[0][d];
      if (c == 0)
      {
        const std::vector<float>& light = cone.Z > 0 ? ground : this->Grid.Sky;
        std::transform(
          light.begin(), light.end(), radiance.begin(), [](float one) { return one / pi; });
      }
      else
      {
        this->SweepPlane(cone, d, k, sweep);
      }
      const Direction& to = this->Directions[cone.First + d];
      float *fluence = &cone.Fluence[k * columns], *x = &cone.X[k * columns],
            *y = &cone.Y[k * columns];
      for (std::size_t q = 0; q < columns; ++q)
      {
        const float light = cone.Weight * radiance[q];
        fluence[q] = (d > 0 ? fluence[q] : 0) + light;
        x[q] = (d > 0 ? x[q] : 0) + to.X * light;
        y[q] = (d > 0 ? y[q] : 0) + to.Y * light;
      }
    }
  }
}

// Sums do not depend on the number of threads.
void DirectionSweep::Run(const DiffuseField& known, DiffuseField& found)
{
  const std::vector<float> ground = this->GroundLight(known);
  std::vector<Cone> cones;
  for (std::size_t first = 0, next = 0; first < this->Directions.size(); first = next)
  {
    while (next < this->Directions.size() && this->Directions[next].Z == this->Directions[first].Z)
    {
      ++next;
    }
    cones.emplace_back(first, next - first, this->Directions[first], this->Grid);
  }
  this->Rows(
    static_cast<int>(cones.size()), [&](int c) { this->RunCone(cones[c], known, ground); });
  found.Clear(this->Grid.Points());
  this->Rows(this->Grid.Size[2], [&](int k) {
    const std::size_t columns = this->Grid.Columns();
    for (const Cone& cone : cones)
    {
      for (std::size_t p = k * columns; p < (k + 1) * columns; ++p)
      {
        found.Fluence[p] += cone.Fluence[p];
        found.Flux[p][0] += cone.X[p];
        found.Flux[p][1] += cone.Y[p];
        found.Flux[p][2] += cone.Z * cone.Fluence[p];
        found.SecondMoment[p] += SecondLegendre(cone.Z) * cone.Fluence[p];
        found.Tilt[p][0] += cone.Z * cone.X[p];
        found.Tilt[p][1] += cone.Z * cone.Y[p];
        found.Vertical[p] += std::abs(cone.Z) * cone.Fluence[p];
      }
    }
  });
}
}
