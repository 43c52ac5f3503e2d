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
  , Seams(directions.size(), std::vector<float>(grid.Periodic ? grid.Points() / grid.Size[0] : 0))
  , NoRates(grid.Size[0], 0.0f)
{
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
        phase[d] =
          henyeyGreenstein(this->Grid.Asymmetry[p], to.X * s[0] + to.Y * s[1] + to.Z * s[2]);
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
    const float forward = 3 * this->Grid.Asymmetry[p],
                all = known.Fluence[p] + forward * cone.Z * flux[2],
                scale = this->Grid.Extinction[p] * this->Grid.Albedo[p] / (4 * pi);
    for (std::size_t d = 0; d < cone.Count; ++d)
    {
      const Direction& to = this->Directions[cone.First + d];
      const float source =
        all + forward * (to.X * flux[0] + to.Y * flux[1]) + this->Beams[cone.First + d][p];
      cone.Emission[0][d][q] = std::max(source, 0.0f) * scale;
    }
  }
}

// The light of one direction in a plane. Outside, the medium goes on as it is at the boundary.
void DirectionSweep::SweepPlane(Cone& cone, std::size_t d, int level, RowSweep& sweep)
{
  const LightGrid& g = this->Grid;
  const Direction& to = this->Directions[cone.First + d];
  const int width = g.Size[0], rows = g.Size[1], alongX = to.X > 0 ? 1 : -1,
            alongY = to.Y > 0 ? 1 : -1, alongZ = to.Z > 0 ? 1 : -1;
  const int start = alongX > 0 ? 0 : width - 1,
            across = alongX > 0 ? width - 2 : 1; // which is met across the seam
  const std::ptrdiff_t columns = g.Columns();
  sweep.Slopes[0] = std::abs(to.X);
  sweep.Slopes[1] = std::abs(to.Y);
  sweep.Slopes[2] = std::abs(to.Z);
  float* radiance = cone.Radiance[0][d].data();
  for (int b = 0; b < rows; ++b)
  {
    const int j = alongY > 0 ? b : rows - 1 - b;
    const std::ptrdiff_t row = std::ptrdiff_t(j) * width, p = level * columns + row,
                         y = b > 0 ? -std::ptrdiff_t(alongY) * width : 0, z = -alongZ * columns;
    sweep.Here = { &g.Extinction[p], &cone.Emission[0][d][row], radiance + row };
    sweep.Beside = sweep.Here.Moved(y);
    sweep.Before = { &g.Extinction[p + z], &cone.Emission[1][d][row], &cone.Radiance[1][d][row] };
    sweep.Diagonal = sweep.Before.Moved(y);
    sweep.Rates[1] =
      b > 0 ? &this->Rates[1][p + std::min<std::ptrdiff_t>(y, 0)] : this->NoRates.data();
    sweep.Rates[2] = &this->Rates[2][p + std::min<std::ptrdiff_t>(z, 0)];
    float* seam = g.Periodic ? &this->Seams[cone.First + d][p / width] : nullptr;
    if (seam)
    {
      radiance[row + across] = *seam;
      const std::ptrdiff_t edge = alongX > 0 ? across : 0;
      sweep.Rates[0] = &this->Rates[0][p + edge] - start;
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
      *seam = radiance[row + across];
      radiance[row + start] = radiance[row + width - 1 - start];
    }
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
        found.Vertical[p] += std::abs(cone.Z) * cone.Fluence[p];
      }
    }
  });
}
}
