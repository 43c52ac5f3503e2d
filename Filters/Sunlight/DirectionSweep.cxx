// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionSweep.h"

#include "PhaseFunction.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr float pi = 3.14159265358979f;
constexpr int groups = 4; // of directions: sums do not depend on the number of threads

// Radiance that comes along a piece of optical depth t from a source that goes linearly from that upstream to that here.
struct PieceWeights
{
  float Transmittance, Upstream, Here;

  explicit PieceWeights(float t)
  {
    if (t < 1e-3f)
    {
      this->Transmittance = 1 - t;
      this->Upstream = this->Here = 0.5f * t;
      return;
    }
    this->Transmittance = std::exp(-t);
    const float mean = (1 - this->Transmittance) / t;
    this->Upstream = mean - this->Transmittance;
    this->Here = 1 - mean;
  }
};
}

// One direction through the grid, row by row.
struct DirectionSweep::OneDirection
{
  const LightGrid& Grid;
  const Direction& D;
  const std::vector<Vector>& Rate;
  const std::vector<float>& Emission;
  std::vector<float>& Radiance;
  const float Slope[3] = { std::abs(D.X), std::abs(D.Y), std::abs(D.Z) };
  const bool Forward[3] = { D.X > 0, D.Y > 0, D.Z > 0 };

  // Way upstream along an axis, and where its edge begins.
  struct Shift
  {
    std::ptrdiff_t By, Edge;
  };
  Shift ShiftAt(int index, int axis) const
  {
    const std::ptrdiff_t stride = this->Grid.Stride(axis);
    const int n = this->Grid.Size[axis];
    const int next = this->Forward[axis] ? index - 1 : index + 1;
    if (next >= 0 && next < n)
    {
      return { (next - index) * stride, this->Forward[axis] ? -stride : 0 };
    }
    if (axis == 0 && this->Grid.Periodic)
    {
      const std::ptrdiff_t other = next < 0 ? n - 2 : 1;
      return { other - index, next < 0 ? other - index : 1 - index - 1 };
    }
    return { 0, 0 }; // outside, the medium goes on as it is at the boundary
  }

  void Row(int j, int k)
  {
    const Shift y = this->ShiftAt(j, 1), z = this->ShiftAt(k, 2);
    const int n = this->Grid.Size[0];
    const std::size_t row = j * this->Grid.Stride(1) + k * this->Grid.Stride(2);
    for (int a = 0; a < n; ++a)
    {
      const int i = this->Forward[0] ? a : n - 1 - a;
      this->Visit(row + i, this->ShiftAt(i, 0), y, z);
    }
  }

  void Visit(std::size_t p, const Shift& x, const Shift& y, const Shift& z)
  {
    const float rx = this->Slope[0] * this->Rate[p + x.Edge][0],
                ry = this->Slope[1] * this->Rate[p + y.Edge][1],
                rz = this->Slope[2] * this->Rate[p + z.Edge][2];
    if (rz >= rx && rz >= ry)
    {
      this->Meet(p, 1 / rz, z.By, x.By, rx, y.By, ry);
    }
    else if (rx >= ry)
    {
      this->Meet(p, 1 / rx, x.By, y.By, ry, z.By, rz);
    }
    else
    {
      this->Meet(p, 1 / ry, y.By, z.By, rz, x.By, rx);
    }
  }

  // Light comes from between four neighbours on the next plane upstream.
  void Meet(std::size_t p, float length, std::ptrdiff_t base, std::ptrdiff_t du, float ru,
    std::ptrdiff_t dv, float rv)
  {
    const float u = ru * length, v = rv * length;
    const float weights[4] = { (1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v };
    const std::size_t from = p + base;
    const std::size_t points[4] = { from, from + du, from + dv, from + du + dv };
    const auto mean = [&](const std::vector<float>& values) {
      return weights[0] * values[points[0]] + weights[1] * values[points[1]] +
        weights[2] * values[points[2]] + weights[3] * values[points[3]];
    };
    const float here = this->Grid.Extinction[p], there = mean(this->Grid.Extinction);
    float value = mean(this->Radiance);
    if (here + there > 0)
    {
      const PieceWeights w(0.5f * (here + there) * length);
      const float emitted = this->Emission[p],
                  before = there > 0 ? mean(this->Emission) / there : 0;
      const float last = here > 0 ? emitted / here : before;
      value = value * w.Transmittance + w.Upstream * (there > 0 ? before : last) + w.Here * last;
    }
    this->Radiance[p] = value;
  }
};

struct DirectionSweep::Sums
{
  DiffuseField Field;
  std::vector<float> Emission, Radiance;
};

DirectionSweep::DirectionSweep(const LightGrid& grid, const std::vector<float>& beam,
  const std::vector<Direction>& directions, const Parallel& parallel)
  : Grid(grid)
  , Directions(directions)
  , Rows(parallel)
  , Seams(directions.size())
  , Rate(grid.Points())
{
  for (std::size_t p = 0; p < this->Rate.size(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const float step = grid.Step[p][axis];
      this->Rate[p][axis] = grid.Size[axis] > 1 ? 1 / std::max(step, 1e-30f) : 0;
    }
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

void DirectionSweep::Run(const DiffuseField& known, DiffuseField& found)
{
  const std::size_t n = this->Grid.Points(), columns = this->Grid.Columns();
  const std::vector<float> ground = this->GroundLight(known);
  std::vector<Sums> parts(groups);
  const auto emit = [&](std::size_t d, std::vector<float>& emission) {
    const Direction& to = this->Directions[d];
    for (std::size_t p = 0; p < n; ++p)
    {
      const Vector& f = known.Flux[p];
      const float along = to.X * f[0] + to.Y * f[1] + to.Z * f[2];
      const float source =
        known.Fluence[p] + 3 * this->Grid.Asymmetry[p] * along + this->Beams[d][p];
      emission[p] =
        std::max(source, 0.0f) * this->Grid.Extinction[p] * this->Grid.Albedo[p] / (4 * pi);
    }
  };
  const auto add = [n](const Direction& to, const Sums& part, DiffuseField& field) {
    for (std::size_t p = 0; p < n; ++p)
    {
      const float light = to.Weight * part.Radiance[p];
      field.Fluence[p] += light;
      field.Flux[p][0] += light * to.X;
      field.Flux[p][1] += light * to.Y;
      field.Flux[p][2] += light * to.Z;
      field.Vertical[p] += light * std::abs(to.Z);
    }
  };
  const auto sweep = [&](std::size_t d, Sums& part) {
    const Direction& to = this->Directions[d];
    OneDirection one{ this->Grid, to, this->Rate, part.Emission, part.Radiance };
    const int width = this->Grid.Size[0], start = one.Forward[0] ? 0 : width - 1;
    std::vector<float>& seam = this->Seams[d];
    seam.resize(this->Grid.Periodic ? n / width : 0, 0.0f);
    for (std::size_t row = 0; row < seam.size(); ++row) // the column that is met across the seam
    {
      part.Radiance[row * width + (one.Forward[0] ? width - 2 : 1)] = seam[row];
    }
    for (int c = 0; c < this->Grid.Size[2]; ++c)
    {
      const int k = one.Forward[2] ? c : this->Grid.Size[2] - 1 - c;
      for (int b = 0; b < this->Grid.Size[1]; ++b)
      {
        const int j = one.Forward[1] ? b : this->Grid.Size[1] - 1 - b;
        if (c == 0)
        {
          const std::size_t row = j * this->Grid.Stride(1) + k * columns;
          for (std::size_t p = row; p < row + width; ++p)
          {
            part.Radiance[p] =
              (one.Forward[2] ? ground[p % columns] : this->Grid.Sky[p % columns]) / pi;
          }
        }
        else
        {
          one.Row(j, k);
        }
      }
    }
    for (std::size_t row = 0; row < seam.size(); ++row)
    {
      seam[row] = part.Radiance[row * width + (one.Forward[0] ? width - 2 : 1)];
      part.Radiance[row * width + start] = part.Radiance[row * width + width - 1 - start];
    }
  };
  this->Rows(groups, [&](int group) {
    Sums& part = parts[group];
    part.Field.Clear(n);
    part.Emission.resize(n);
    part.Radiance.resize(n);
    for (std::size_t d = group; d < this->Directions.size(); d += groups)
    {
      emit(d, part.Emission);
      sweep(d, part);
      add(this->Directions[d], part, part.Field);
    }
  });
  found.Clear(n);
  for (const Sums& part : parts)
  {
    for (std::size_t p = 0; p < n; ++p)
    {
      found.Fluence[p] += part.Field.Fluence[p];
      found.Vertical[p] += part.Field.Vertical[p];
      for (int axis = 0; axis < 3; ++axis)
      {
        found.Flux[p][axis] += part.Field.Flux[p][axis];
      }
    }
  }
}
}
