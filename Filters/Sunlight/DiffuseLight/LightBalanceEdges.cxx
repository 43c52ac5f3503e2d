// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The coefficients of the balance: between points, at top, ground and open sides.
#include "LayerTransfer.h"
#include "LightBalance.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double leastDepth =
  0.1; // of layers beside one another: clear air does not join points too firmly
}

// The layer between two points.
LayerMedium LightBalance::Between(std::size_t p, std::size_t q, double length) const
{
  const double a = this->Grid.Extinction[p], b = this->Grid.Extinction[q];
  const double sa = a * this->Grid.Albedo[p], sb = b * this->Grid.Albedo[q];
  LayerMedium medium;
  medium.Depth = 0.5 * (a + b) * length;
  medium.Albedo =
    a + b > 0 ? (sa + sb) / (a + b) : 0.5 * (this->Grid.Albedo[p] + this->Grid.Albedo[q]);
  medium.Asymmetry =
    sa + sb > 0 ? (sa * this->Grid.Asymmetry[p] + sb * this->Grid.Asymmetry[q]) / (sa + sb) : 0;
  return medium;
}

// That of the first column.
double LightBalance::HeightOf(const LightGrid& grid)
{
  double height = 1e-30;
  for (std::size_t p = 0; p + grid.Columns() < grid.Points(); p += grid.Columns())
  {
    height += grid.Step[p][2];
  }
  return height;
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
  return this->Between(below, below + columns, this->Grid.Step[below][2]).Depth;
}

// From the middle of an edge to the nearest side of the grid.
double LightBalance::DistanceToSide(std::size_t p, const Index& at, int axis) const
{
  double least = 1e30;
  for (int across = 0; across < 2; ++across)
  {
    const double index = at[across] + (across == axis ? 0.5 : 0.0);
    least = std::min(
      least, std::min(index, this->Grid.Size[across] - 1 - index) * this->Grid.Step[p][across]);
  }
  return least;
}

// Short characteristics are good for layers of a depth well below 1. Within half of the height from
// open sides, Eddington's approximation is worse than they are, and may give a flux below 0.
float LightBalance::TrustAt(std::size_t p, const Index& at, int axis, double depth) const
{
  double loss = 4;
  if (this->Grid.Open)
  {
    const double away = this->DistanceToSide(p, at, axis) / this->Height;
    loss = 1 + 3 * std::max(0.0, std::min(2 * away - 1, 1.0));
  }
  return static_cast<float>(1 / (1 + loss * depth * depth));
}

LightBalance::Edge LightBalance::MakeEdge(
  std::size_t p, std::size_t q, int axis, const Index& at) const
{
  Edge edge;
  LayerMedium medium = this->Between(p, q, this->Grid.Step[p][axis]);
  edge.Trust = this->TrustAt(
    p, at, axis, std::min(medium.Depth, 0.5 * (this->LayerDepth(p) + this->LayerDepth(q))));
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
        Edge edge = this->MakeEdge(p, q, axis, at);
        edge.Area = static_cast<float>(this->AreaAt(p, at, axis));
        at[axis] = next;
        edge.Area = 0.5f * (edge.Area + static_cast<float>(this->AreaAt(q, at, axis)));
        edge.Here *= edge.Area;
        edge.There *= edge.Area;
        this->AddBeam(edge, p, q, axis, this->Between(p, q, this->Grid.Step[p][axis]));
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
  this->MakeSides();
}

// Half of the light of the sky, which comes from above only, enters through an upright side.
void LightBalance::MakeSides()
{
  for (int axis = 0; axis < 2 && this->Grid.Open; ++axis)
  {
    this->Sides[axis].resize(2 * this->Grid.Points() / this->Grid.Size[axis]);
  }
  this->ForPoints([&](std::size_t p, const Index& at) {
    ForSides(*this, at, [&](int axis, int outwards, Boundary& side) {
      const std::size_t before = outwards > 0 ? p - this->Grid.Stride(axis) : p;
      const double area = this->AreaAt(p, at, axis);
      side = { float(0.5 * area), float(area * this->Grid.Sky[p % this->Grid.Columns()]),
        float(area), this->Edges[axis][before].Trust, 0 };
    });
  });
}
}
