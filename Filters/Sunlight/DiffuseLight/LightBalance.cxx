// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightBalance.h"

#include "LayerTransfer.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
void DiffuseField::Clear(std::size_t points)
{
  this->Fluence.assign(points, 0.0f);
  this->Flux.assign(points, Vector{ { 0, 0, 0 } });
  this->Vertical.assign(points, 0.0f);
  this->SecondMoment.assign(points, 0.0f);
  this->Tilt.assign(points, { { 0, 0 } });
}

LightBalance::LightBalance(
  const LightGrid& grid, const BeamDeposit& deposit, const Parallel& parallel)
  : Grid(grid)
  , Rows(parallel)
  , Solver(grid, parallel)
  , Deposit(deposit)
  , Height(HeightOf(grid))
  , Fluence(grid.Points(), 0.0)
{
  this->MakeEdges();
  this->MakeBoundaries();
  this->MakeMatrix();
}

void LightBalance::MakeMatrix()
{
  const std::size_t columns = this->Grid.Columns(), top = this->Grid.Points() - columns;
  this->ForPoints([&](std::size_t p, const Index& at) {
    double& sum = this->Solver.Diagonal[p];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int before = this->Grid.Before(at[axis], axis);
      sum += this->Edges[axis][p].Here +
        (before >= 0 ? this->Edges[axis][this->Neighbour(p, at, axis, before)].Here : 0.0f);
      this->Solver.Next[axis][p] = this->Edges[axis][p].There;
    }
    ForSides(*this, at, [&](int, int, const Boundary& side) { sum += side.Rate; });
    sum += p < columns ? this->Ground[p].Rate : 0.0f;
    sum += p >= top ? this->Top[p - top].Rate : 0.0f;
  });
  this->Solver.Factor();
}

void LightBalance::Compare(const DiffuseField& ordinates, const DiffuseField& known)
{
  const std::size_t columns = this->Grid.Columns(), top = this->Grid.Points() - columns;
  const auto different = [](auto& edge, double found, double expected) {
    edge.Extra = static_cast<float>(edge.Trust * (edge.Area * found - expected));
  };
  this->ForPoints([&](std::size_t p, const Index& at) {
    for (int axis = 0; axis < 3; ++axis)
    {
      Edge& edge = this->Edges[axis][p];
      const int next = this->Grid.After(at[axis], axis);
      if (next >= 0)
      {
        const std::size_t q = this->Neighbour(p, at, axis, next);
        const double a = ordinates.Fluence[p], b = ordinates.Fluence[q];
        edge.Extra = 0;
        const double found = 0.5 * (ordinates.Flux[p][axis] + ordinates.Flux[q][axis]);
        const double assumed = 0.5 * (known.Flux[p][axis] + known.Flux[q][axis]);
        // In deep clouds a change of the flux comes back as `Forward` of itself, in thin ones not
        // at all. Half of it makes the iteration converge in both.
        const double settled = (found - 0.5 * edge.Forward * assumed) / (1 - 0.5 * edge.Forward);
        different(edge, settled, 0.5 * (edge.Out(a, b) + edge.In(a, b)));
      }
    }
    ForSides(*this, at, [&](int axis, int outwards, Boundary& side) {
      side.Extra = 0;
      different(side, outwards * ordinates.Flux[p][axis], side.Out(ordinates.Fluence[p]));
    });
    if (p < columns)
    {
      this->Ground[p].Extra = 0;
      different(this->Ground[p], -ordinates.Flux[p][2], this->Ground[p].Out(ordinates.Fluence[p]));
    }
    if (p >= top)
    {
      Boundary& above = this->Top[p - top];
      above.Extra = 0;
      different(above, ordinates.Flux[p][2], above.Out(ordinates.Fluence[p]));
    }
  });
}

std::vector<double> LightBalance::RightSide() const
{
  std::vector<double> right(this->Grid.Points(), 0.0);
  const std::size_t columns = this->Grid.Columns(), top = this->Grid.Points() - columns;
  this->ForPoints([&](std::size_t p, const Index& at) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int before = this->Grid.Before(at[axis], axis);
      sum -= this->Edges[axis][p].Out(0, 0);
      sum += before >= 0 ? this->Edges[axis][this->Neighbour(p, at, axis, before)].In(0, 0) : 0.0;
    }
    ForSides(*this, at, [&](int, int, const Boundary& side) { sum -= side.Out(0); });
    sum -= p < columns ? this->Ground[p].Out(0) : 0.0;
    sum -= p >= top ? this->Top[p - top].Out(0) : 0.0;
    right[p] = sum;
  });
  return right;
}

void LightBalance::Solve(const DiffuseField* ordinates, DiffuseField& field, double reduction)
{
  if (ordinates)
  {
    this->Compare(*ordinates, field);
  }
  this->Solver.Solve(this->RightSide(), this->Fluence, reduction, 1000);
  field.Clear(this->Grid.Points());
  this->ForPoints(
    [&](std::size_t p, const Index& at) { this->WritePoint(p, at, ordinates, field); });
  this->CloseSeams(field);
}

// The flux is the mean of those before and after the point; ordinates add what such a mean of
// theirs lacks.
void LightBalance::WritePoint(
  std::size_t p, const Index& at, const DiffuseField* ordinates, DiffuseField& field) const
{
  const double here = this->Fluence[p];
  double trust = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    double flux = 0, theirs = 0, share = 1;
    int count = 0;
    const auto add = [&](const Edge& edge, double power, std::size_t other) {
      flux += edge.Area > 0 ? power / edge.Area : 0;
      theirs += ordinates ? 0.5 * (ordinates->Flux[p][axis] + ordinates->Flux[other][axis]) : 0;
      share = std::min<double>(share, edge.Trust);
      ++count;
    };
    const int after = this->Grid.After(at[axis], axis), before = this->Grid.Before(at[axis], axis);
    if (after >= 0)
    {
      const std::size_t q = this->Neighbour(p, at, axis, after);
      add(this->Edges[axis][p], this->Edges[axis][p].Out(here, this->Fluence[q]), q);
    }
    if (before >= 0)
    {
      const std::size_t q = this->Neighbour(p, at, axis, before);
      add(this->Edges[axis][q], this->Edges[axis][q].In(this->Fluence[q], here), q);
    }
    count = std::max(count, 1);
    trust = std::min(trust, share);
    field.Flux[p][axis] = static_cast<float>(
      flux / count + (ordinates ? share * (ordinates->Flux[p][axis] - theirs / count) : 0));
  }
  field.Fluence[p] = static_cast<float>(here);
  field.Vertical[p] = static_cast<float>(
    0.5 * here + (ordinates ? trust * (ordinates->Vertical[p] - 0.5 * ordinates->Fluence[p]) : 0));
  if (ordinates)
  {
    const float share = static_cast<float>(trust);
    field.SecondMoment[p] = share * ordinates->SecondMoment[p];
    field.Tilt[p] = { { share * ordinates->Tilt[p][0], share * ordinates->Tilt[p][1] } };
  }
  ForSides(*this, at, [&](int axis, int outwards, const Boundary& side) {
    field.Flux[p][axis] =
      static_cast<float>(side.Area > 0 ? outwards * side.Out(here) / side.Area : 0);
  });
  const std::size_t columns = this->Grid.Columns(), top = this->Grid.Points() - columns;
  const double white = this->Grid.GroundAlbedo;
  if (p >= top)
  {
    const Boundary& above = this->Top[p - top];
    field.Flux[p][2] = static_cast<float>(above.Area > 0 ? above.Out(here) / above.Area : 0);
    field.Vertical[p] = field.Flux[p][2] + 2 * this->Grid.Sky[p - top];
  }
  if (p < columns)
  {
    const Boundary& below = this->Ground[p];
    field.Flux[p][2] = static_cast<float>(below.Area > 0 ? -below.Out(here) / below.Area : 0);
    if (white < 0.5)
    {
      this->SettleGround(p, field);
    }
  }
}

// What comes down is what the ground takes, divided by the fraction of it that the ground takes:
// errors of the flux grow by that.
void LightBalance::SettleGround(std::size_t p, DiffuseField& field) const
{
  const double white = this->Grid.GroundAlbedo,
               beam = std::max(-this->Grid.SunAt(p)[2], 0.0f) * this->Grid.BeamAt(p),
               down = (white * beam - field.Flux[p][2]) / (1 - white);
  field.Vertical[p] = static_cast<float>(2 * down + field.Flux[p][2]);
}

void LightBalance::CloseSeams(DiffuseField& field) const
{
  this->Grid.CloseSeams(field.Fluence);
  this->Grid.CloseSeams(field.Flux);
  this->Grid.CloseSeams(field.Vertical);
  this->Grid.CloseSeams(field.SecondMoment);
  this->Grid.CloseSeams(field.Tilt);
}

// Negative values in a column are repeatedly balanced by the columns beside it.
void LightBalance::SpreadDebt(std::vector<double>& power) const
{
  const LightGrid& g = this->Grid;
  for (int pass = 0; pass < 20; ++pass)
  {
    std::vector<double> next(power.size(), 0.0);
    for (std::size_t c = 0; c < power.size(); ++c)
    {
      const int i = static_cast<int>(c % g.Size[0]), j = static_cast<int>(c / g.Size[0]);
      std::vector<std::size_t> beside;
      for (const int x : { g.Before(i, 0), g.After(i, 0) })
      {
        if (power[c] < 0 && x >= 0)
        {
          beside.push_back(c + x - i);
        }
      }
      for (const int y : { g.Before(j, 1), g.After(j, 1) })
      {
        if (power[c] < 0 && y >= 0)
        {
          beside.push_back(c + (y - j) * g.Stride(1));
        }
      }
      next[c] += beside.empty() ? power[c] : 0;
      for (const std::size_t other : beside)
      {
        next[other] += power[c] / beside.size();
      }
    }
    power.swap(next);
  }
}

void LightBalance::Finish(DiffuseField& field) const
{
  const std::size_t columns = this->Grid.Columns(), top = this->Grid.Points() - columns;
  for (std::size_t p = 0; p < columns && this->Grid.GroundAlbedo <= 0.9; ++p)
  {
    this->SettleGround(p, field);
  }
  for (const bool up : { false, true })
  {
    const std::vector<Boundary>& areas = up ? this->Top : this->Ground;
    std::vector<double> power(columns);
    for (std::size_t c = 0; c < columns; ++c)
    {
      power[c] = areas[c].Area * double(up ? field.Up(top + c) : field.Down(c));
    }
    this->SpreadDebt(power);
    for (std::size_t c = 0; c < columns; ++c)
    {
      const std::size_t p = up ? top + c : c;
      const float kept =
        areas[c].Area > 0 ? static_cast<float>(std::max(power[c], 0.0) / areas[c].Area) : 0;
      const float other = up ? field.Down(p) : field.Up(p);
      field.Vertical[p] = kept + other;
      field.Flux[p][2] = up ? kept - other : other - kept;
    }
  }
  this->CloseSeams(field);
}

std::vector<float> LightBalance::Absorption() const
{
  std::vector<float> absorbed(this->Grid.Points(), 0.0f);
  this->ForPoints([&](std::size_t p, const Index& at) {
    const std::size_t above = this->Grid.Columns();
    const auto half = [&](std::size_t q) {
      const Edge& e = this->Edges[2][q];
      const LayerMedium medium = this->Between(q, q + above, this->Grid.Step[q][2]);
      return e.Area * LayerAbsorption(medium) * this->Fluence[p] + 0.5 * e.Lost;
    };
    const double volume = this->AreaAt(p, at, 2) * this->WidthAt(p, at, 2);
    const double sum =
      (at[2] + 1 < this->Grid.Size[2] ? half(p) : 0.0) + (at[2] > 0 ? half(p - above) : 0.0);
    absorbed[p] = static_cast<float>(volume > 0 ? std::max(sum, 0.0) / volume : 0);
  });
  this->Grid.CloseSeams(absorbed);
  return absorbed;
}
}
