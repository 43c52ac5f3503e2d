// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightBalance.h"

#include "LayerTransfer.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double leastDepth =
  0.1; // of layers beside one another: clear air does not join points too firmly

// Short characteristics are good for layers of a depth well below 1.
float TrustAt(double depth)
{
  return static_cast<float>(1 / (1 + 4 * depth * depth));
}

LayerMedium Between(const LightGrid& grid, std::size_t p, std::size_t q, double length)
{
  const double a = grid.Extinction[p], b = grid.Extinction[q];
  const double sa = a * grid.Albedo[p], sb = b * grid.Albedo[q];
  LayerMedium medium;
  medium.Depth = 0.5 * (a + b) * length;
  medium.Albedo = a + b > 0 ? (sa + sb) / (a + b) : 0.5 * (grid.Albedo[p] + grid.Albedo[q]);
  medium.Asymmetry =
    sa + sb > 0 ? (sa * grid.Asymmetry[p] + sb * grid.Asymmetry[q]) / (sa + sb) : 0;
  return medium;
}
}

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
  , Fluence(grid.Points(), 0.0)
{
  this->MakeEdges();
  this->MakeBoundaries();
  this->MakeMatrix();
}

template <typename Body>
void LightBalance::ForPoints(Body body) const
{
  this->Rows(this->Grid.Width(1), [&](int j) {
    for (int k = 0; k < this->Grid.Size[2]; ++k)
    {
      const std::size_t row = j * this->Grid.Stride(1) + k * this->Grid.Stride(2);
      for (int i = 0; i < this->Grid.Width(0); ++i)
      {
        body(row + i, Index{ i, j, k });
      }
    }
  });
}

// The width of the box around a point.
double LightBalance::WidthAt(std::size_t p, const Index& at, int axis) const
{
  const int before = this->Grid.Before(at[axis], axis), after = this->Grid.After(at[axis], axis);
  return 0.5 * (after >= 0 ? this->Grid.Step[p][axis] : 0.0f) +
    0.5 * (before >= 0 ? this->Grid.Step[this->Neighbour(p, at, axis, before)][axis] : 0.0f);
}

double LightBalance::AreaAt(std::size_t p, const Index& at, int axis) const
{
  return this->WidthAt(p, at, (axis + 1) % 3) * this->WidthAt(p, at, (axis + 2) % 3);
}

// The depth of the layer from a point to the next one above.
double LightBalance::LayerDepth(std::size_t p) const
{
  const std::size_t columns = this->Grid.Columns();
  const std::size_t below = p + columns < this->Grid.Points() ? p : p - columns;
  return Between(this->Grid, below, below + columns, this->Grid.Step[below][2]).Depth;
}

LightBalance::Edge LightBalance::MakeEdge(std::size_t p, std::size_t q, int axis) const
{
  Edge edge;
  LayerMedium medium = Between(this->Grid, p, q, this->Grid.Step[p][axis]);
  edge.Trust = TrustAt(std::min(medium.Depth, 0.5 * (this->LayerDepth(p) + this->LayerDepth(q))));
  edge.Forward = static_cast<float>(1 - medium.Transport());
  if (axis == 2)
  {
    const LayerConductance conductance(medium);
    edge.Here = static_cast<float>(conductance.Here);
    edge.There = static_cast<float>(conductance.There);
  }
  else
  {
    edge.Here = edge.There =
      static_cast<float>(1 / (3 * medium.Transport() * std::max(medium.Depth, leastDepth)));
  }
  return edge;
}

void LightBalance::AddBeam(
  Edge& edge, std::size_t p, std::size_t q, int axis, const LayerMedium& medium) const
{
  const double slant = 0.5 * (this->Grid.SunAt(p)[axis] + this->Grid.SunAt(q)[axis]);
  const double forward = slant * medium.Albedo * medium.Asymmetry / medium.Transport();
  if (axis == 2)
  {
    const double lost = this->Deposit.InLayer[p], scattered = medium.Albedo * lost;
    const double directed = medium.Depth > 0 ? forward * lost / medium.Depth : 0;
    const LayerShares shares(this->Grid.Depth[p] - this->Grid.Depth[q], medium.Decay());
    edge.First = static_cast<float>(scattered * shares.First - directed * shares.FirstForward);
    edge.Second = static_cast<float>(scattered * shares.Second + directed * shares.SecondForward);
    edge.Lost = static_cast<float>(lost - edge.First - edge.Second);
    return;
  }
  const double a = this->Grid.Depth[p], b = this->Grid.Depth[q], mean = MeanBeam(a, b);
  edge.Second = static_cast<float>(
    edge.Area * (forward * mean + medium.Albedo * slant * (mean - std::exp(-0.5 * (a + b)))));
  edge.First = -edge.Second;
}

void LightBalance::MakeEdges()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Edges[axis].resize(this->Grid.Points());
    this->ForPoints([&](std::size_t p, Index at) {
      const int next = this->Grid.After(at[axis], axis);
      if (next >= 0)
      {
        const std::size_t q = this->Neighbour(p, at, axis, next);
        Edge edge = this->MakeEdge(p, q, axis);
        edge.Area = static_cast<float>(this->AreaAt(p, at, axis));
        at[axis] = next;
        edge.Area = 0.5f * (edge.Area + static_cast<float>(this->AreaAt(q, at, axis)));
        edge.Here *= edge.Area;
        edge.There *= edge.Area;
        this->AddBeam(edge, p, q, axis, Between(this->Grid, p, q, this->Grid.Step[p][axis]));
        this->Edges[axis][p] = edge;
      }
    });
  }
}

// Marshak's conditions: the incoming light is that of the sky, or that reflected by the ground.
void LightBalance::MakeBoundaries()
{
  const std::size_t columns = this->Grid.Columns(), top = this->Grid.Points() - columns;
  this->Top.resize(columns);
  this->Ground.resize(columns);
  const double white = this->Grid.GroundAlbedo;
  this->ForPoints([&](std::size_t p, const Index& at) {
    if (at[2] == 0)
    {
      Boundary& ground = this->Ground[p];
      const double area = this->AreaAt(p, at, 2);
      const double beam = std::max(-this->Grid.SunAt(p)[2], 0.0f) * this->Grid.BeamAt(p);
      ground = { float(area * (1 - white) / (2 + 2 * white)),
        float(area * 2 * white * beam / (1 + white)), float(area), this->Edges[2][p].Trust, 0 };
    }
    if (p >= top)
    {
      const double area = this->AreaAt(p, at, 2);
      this->Top[p - top] = { float(0.5 * area), float(2 * area * this->Grid.Sky[p - top]),
        float(area), this->Edges[2][p - columns].Trust, 0 };
    }
  });
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
      const LayerMedium medium = Between(this->Grid, q, q + above, this->Grid.Step[q][2]);
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
