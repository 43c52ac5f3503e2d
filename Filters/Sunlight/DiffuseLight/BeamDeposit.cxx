// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BeamDeposit.h"

#include <algorithm>
#include <array>

namespace nephoscope
{
double MeanBeam(double from, double to)
{
  const double way = std::abs(to - from);
  return std::exp(-std::min(from, to)) * (way < 1e-4 ? 1 - 0.5 * way : -std::expm1(-way) / way);
}

namespace
{
// Half of the way from a point to its neighbour along one axis.
struct HalfWay
{
  double Length = 0;     // 0: there is no neighbour
  double Extinction = 0; // mean over this half
  double Beam = 0;       // at its end
  double Mean = 0;       // of the beam over it
  double Depth = 0;      // towards the sun, the larger one of point and neighbour

  // Extinction is linear: the beam's depth at the middle follows.
  HalfWay(const LightGrid& grid, std::size_t here, std::size_t there, double length)
    : Length(0.5 * length)
  {
    const double a = grid.Extinction[here], b = grid.Extinction[there];
    const double share = a + b > 0 ? (3 * a + b) / (4 * (a + b)) : 0.5;
    const double from = grid.Depth[here];
    this->Extinction = 0.25 * (3 * a + b);
    const double to = from + share * (grid.Depth[there] - from);
    this->Depth = std::max(from, double(grid.Depth[there]));
    this->Beam = std::exp(-to);
    this->Mean = MeanBeam(from, to);
  }
  HalfWay() = default;
};

class PointDeposit
{
public:
  PointDeposit(const LightGrid& grid, const std::array<int, 3>& at)
    : Beam(0)
  {
    std::size_t p = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      p += at[axis] * grid.Stride(axis);
    }
    this->Beam = grid.Transmittance(p);
    this->Extinction = grid.Extinction[p];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Slant[axis] = grid.SunAt(p)[axis];
      for (const bool up : { false, true })
      {
        const int next = up ? grid.After(at[axis], axis) : grid.Before(at[axis], axis);
        if (next >= 0)
        {
          const std::size_t q = p + next * grid.Stride(axis) - at[axis] * grid.Stride(axis);
          this->Ways[axis][up] = HalfWay(grid, p, q, grid.Step[up ? p : q][axis]);
        }
      }
    }
  }

  // In the four octants below (0) or above (1). `net` sums what goes in and out where it is day.
  double On(int side, double& net, double& depth) const
  {
    double sum = 0;
    for (int octant = 0; octant < 4; ++octant)
    {
      sum += this->InOctant({ octant & 1, octant >> 1, side }, net, depth);
    }
    return sum;
  }

private:
  // What enters through the faces and does not leave; where the edge of a shadow makes that too
  // much, what the volume can take.
  double InOctant(const std::array<int, 3>& sides, double& net, double& depth) const
  {
    double volume = 1, mean = this->Beam, extinction = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const HalfWay& way = this->Ways[axis][sides[axis]];
      const double change = this->Beam > 0 ? way.Mean / this->Beam : 1;
      volume *= way.Length;
      mean *= axis == 2 ? change : std::max(change, 1.0);
      extinction = std::max(extinction, way.Extinction);
    }
    depth += volume * this->MeanExtinction(sides);
    const double most = volume * extinction * std::min(mean, 1.0);
    double lost = 0;
    for (int axis = 0; axis < 3 && volume > 0; ++axis)
    {
      const HalfWay& way = this->Ways[axis][sides[axis]];
      const bool along = (this->Slant[axis] > 0) == (sides[axis] == 1);
      const double change = (along ? this->Beam - way.Beam : way.Beam - this->Beam) * volume /
        way.Length * std::abs(this->Slant[axis]);
      lost += std::max(change, 0.0);
      net += way.Depth < LightGrid::Night ? change : 0;
    }
    return std::min(most, lost);
  }

  // Linear along each axis.
  double MeanExtinction(const std::array<int, 3>& sides) const
  {
    return std::max(this->Ways[0][sides[0]].Extinction + this->Ways[1][sides[1]].Extinction +
        this->Ways[2][sides[2]].Extinction - 2 * this->Extinction,
      0.0);
  }

  double Beam, Extinction;
  double Slant[3];
  HalfWay Ways[3][2];
};

struct RowSums
{
  double Net = 0, Lost = 0;
};
}

// Edges of shadows are counted twice where they cross thick cells: the whole is made what the
// clouds take.
BeamDeposit FindBeamDeposit(const LightGrid& grid, const Parallel& parallel)
{
  BeamDeposit deposit;
  deposit.InLayer.assign(grid.Points(), 0.0f);
  deposit.Beam.assign(grid.Points(), 0.0f);
  std::vector<RowSums> rows(grid.Width(1));
  const std::size_t above = grid.Stride(2);
  parallel(grid.Width(1), [&](int j) {
    for (int k = 0; k < grid.Size[2]; ++k)
    {
      for (int i = 0; i < grid.Width(0); ++i)
      {
        const PointDeposit point(grid, { i, j, k });
        const std::size_t p = i + j * grid.Stride(1) + k * above;
        double depth = 0;
        const double below = k > 0 ? point.On(0, rows[j].Net, depth) : 0,
                     over = point.On(1, rows[j].Net, depth);
        rows[j].Lost += below + over;
        deposit.Beam[p] = static_cast<float>(depth > 0 ? std::min((below + over) / depth, 1.0) : 0);
        deposit.InLayer[p] += static_cast<float>(over);
        if (k > 0)
        {
          deposit.InLayer[p - above] += static_cast<float>(below);
        }
      }
    }
  });
  RowSums all;
  for (const RowSums& row : rows)
  {
    all.Net += row.Net;
    all.Lost += row.Lost;
  }
  const float share =
    all.Lost > 0 ? static_cast<float>(std::min(std::max(all.Net / all.Lost, 0.5), 2.0)) : 1;
  for (std::size_t p = 0; p < grid.Points(); ++p)
  {
    const std::size_t q = p + above < grid.Points() ? p + above : p;
    deposit.InLayer[p] *= share * 0.5f * (grid.ShadowAt(p) + grid.ShadowAt(q));
    deposit.Beam[p] *= share * grid.ShadowAt(p);
  }
  grid.CloseSeams(deposit.Beam); // the sweeps visit both sides of a seam
  return deposit;
}
}
