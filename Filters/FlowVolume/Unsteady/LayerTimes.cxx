// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerTimes.h"

#include "AdvanceParticles.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// The points of the front that are corners of the polygon's triangles, moved
// alone.
class FrontOnTheWay
{
public:
  FrontOnTheWay(const VelocityField& field, const PolygonMesh& polygon, const StreakMesh& smoke,
    const IntegrationSettings& integration)
    : Field(field)
    , Polygon(polygon)
    , Integration(integration)
    , Positions(Part(smoke.Positions, smoke.Front))
    , Hints(Part(smoke.Hints, smoke.Front))
    , Inside(Part(smoke.Inside, smoke.Front))
  {
  }

  void Advance(double from, double to)
  {
    AdvanceParticles(this->Field,
      { this->Positions.data(), this->Hints.data(), this->Inside.data(), this->Positions.size() },
      from, to - from, this->Integration);
    this->Velocities.Sample(this->Field, this->Polygon, to);
  }

  // The velocity is the tangent of the line of smoke at the polygon, which a
  // line that turns evenly leaves by half of its turn.
  bool Turns(double angle) const
  {
    for (std::size_t p = 0; p < this->Positions.size(); ++p)
    {
      if (this->Inside[p] && this->Velocities.Inside[p] &&
        TurnsTooMuch(this->Velocities.Values[p], 0.0, this->Positions[p] - this->Polygon.Points[p],
          1.0, angle))
      {
        return true;
      }
    }
    return false;
  }

private:
  template <typename Value>
  static std::vector<Value> Part(const std::vector<Value>& all, const StreakFront& front)
  {
    const auto first = all.begin() + front.First;
    return { first, first + static_cast<std::ptrdiff_t>(front.Count) };
  }

  const VelocityField& Field;
  const PolygonMesh& Polygon;
  const IntegrationSettings& Integration;
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
  std::vector<unsigned char> Inside;
  PolygonVelocities Velocities;
};
}

double TimeOfNextLayer(const VelocityField& field, const PolygonMesh& polygon,
  const StreakMesh& smoke, const IntegrationSettings& integration, const LayerTimes& times,
  double angle)
{
  if (!(angle > 0.0))
  {
    return times.End;
  }
  FrontOnTheWay front(field, polygon, smoke, integration);
  double before = times.Now;
  for (double part = std::floor((times.Now - times.Regular) / times.Part); before < times.End;)
  {
    const double whole = times.Regular + ++part * times.Part;
    const double next = whole < times.End - times.Rounding ? whole : times.End;
    if (next < times.End && next <= before + times.Rounding)
    {
      continue;
    }
    front.Advance(before, next);
    if (front.Turns(angle))
    {
      return before > times.Released + times.Rounding ? before : next;
    }
    before = next;
  }
  return times.End;
}
}
