// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UpstreamPlace.h"

#include "Vector3.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double enoughRoom = 0.75;  // of `mostRoom`
constexpr double inflowRoom = 0.5;   // of `mostRoom`: as much around the polygon as in it
constexpr double fastEnough = 0.7;   // of the speed, inside the data
constexpr double fastAtRim = 0.6;    // of the speed in the middle of a wide polygon
constexpr double leastInflow = 0.25; // of the speed, where the flow enters the data
constexpr double reachStep = 0.05;   // reaches closer than this are as good
constexpr int stepsInside = 16;      // each a twentieth of half the diagonal
constexpr int stepsToInflow = 40;
constexpr int mostBisections = 20;

// The places upstream of the first, one step from another.
struct UpstreamPath
{
  std::vector<Candidate> Places;
  double Step = 0.0;
  bool LeavesData = false; // a step beyond the last
};

// By the midpoint rule; false if that is not inside the data. A negative distance is downstream.
bool StepUpstream(
  const DataSetField& field, const Candidate& from, double distance, Candidate& next)
{
  std::vector<Vector3> velocity;
  Vector3 along = from.Velocity;
  next = from;
  for (const double part : { 0.5, 1.0 })
  {
    next.Place = from.Place + (-part * distance) * Normalized(along);
    if (!SampleAt(field, { next.Place }, velocity).front())
    {
      return false;
    }
    along = velocity.front();
  }
  next.Velocity = along;
  next.Speed = Norm(along);
  return true;
}

// As far as there is flow that comes from inside the data.
UpstreamPath Upstream(const DataSetField& field, const Candidate& from, double step)
{
  UpstreamPath path{ { from }, step };
  Candidate next;
  for (int k = 0; k < stepsToInflow; ++k)
  {
    path.LeavesData = !StepUpstream(field, path.Places.back(), step, next);
    const bool flows = std::isfinite(next.Speed) && next.Speed >= leastInflow * from.Speed;
    if (path.LeavesData || !flows)
    {
      break;
    }
    path.Places.push_back(next);
  }
  return path;
}

// The first places of the path, while the flow is about as fast.
std::vector<Candidate> FastPart(const UpstreamPath& path)
{
  const double least = fastEnough * path.Places.front().Speed;
  const auto begin = path.Places.begin();
  const auto slow =
    std::find_if(begin, path.Places.end(), [least](const Candidate& c) { return c.Speed < least; });
  return { begin, begin + std::min<std::ptrdiff_t>(stepsInside + 1, slow - begin) };
}

// The place from which smoke goes farthest, of those with enough room; of those that are as good
// the nearest. The first has enough.
Candidate FarthestReaching(const DataSetField& field, const PolygonPoints& polygon,
  const std::vector<Candidate>& places, double halfDiagonal, double leastRoom, double& reach)
{
  const std::vector<bool> inside = polygon.AreInside(field, places);
  const std::vector<double> reaches = MeanReaches(field, places, halfDiagonal);
  std::size_t best = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    const bool fits = inside[i] && places[i].Room >= leastRoom;
    best = fits && Step(reaches[i] / reachStep) > Step(reaches[best] / reachStep) ? i : best;
  }
  reach = reaches[best];
  return places[best];
}

// How far upstream of the last place the path leaves the data.
double DistanceToBorder(const DataSetField& field, const UpstreamPath& path)
{
  double inside = 0.0, outside = path.Step;
  Candidate place;
  for (int i = 0; i < mostBisections; ++i)
  {
    const double middle = 0.5 * (inside + outside);
    (StepUpstream(field, path.Places.back(), middle, place) ? inside : outside) = middle;
  }
  return inside;
}

// One, two or four radii inside the border where the path leaves the data: the first with room.
// Where the border is very askew to the flow, as that of a shell of air in which it goes round,
// there is none.
bool FindInflow(
  const DataSetField& field, const UpstreamPath& path, double leastRoom, Candidate& inflow)
{
  const Candidate& last = path.Places.back();
  const double border = DistanceToBorder(field, path);
  for (const double radii : { 1.0, 2.0, 4.0 })
  {
    std::vector<Candidate> place(1);
    if (StepUpstream(field, last, border - radii * last.Radius, place.front()) &&
      place.front().Speed >= leastInflow * path.Places.front().Speed)
    {
      FindRoom(field, last.Radius, place);
      if (place.front().Room >= leastRoom)
      {
        inflow = place.front();
        return true;
      }
    }
  }
  return false;
}

// The place with the radii that the polygon may have there, the greatest first: up to four times as
// wide, with as much room around it as in it.
std::vector<Candidate> Widths(const DataSetField& field, const Candidate& place)
{
  std::vector<Candidate> room = { place }, widths = { place };
  FindRoom(field, 2.0 * place.Radius, room);
  for (double width = 2.0; width <= mostRoom * room.front().Room; width += 1.0)
  {
    widths.insert(widths.begin(), place);
    widths.front().Radius = width * place.Radius;
  }
  return widths;
}

// Whether the flow at the rim of the polygon is about as fast as in its middle: a jet may be
// narrower than the room around it.
bool IsFastAtRim(const DataSetField& field, const Candidate& place)
{
  const std::vector<Vector3> rim = Rim(place, place.Radius);
  std::vector<Vector3> velocities;
  SampleAt(field, rim, velocities);
  return std::all_of(velocities.begin(), velocities.end(),
    [&place](const Vector3& velocity) { return Norm(velocity) >= fastAtRim * place.Speed; });
}
}

Candidate UpstreamPlace(const DataSetField& field, const PolygonPoints& polygon,
  const Candidate& from, double halfDiagonal, double& reach)
{
  const UpstreamPath path = Upstream(field, from, halfDiagonal / 20.0);
  std::vector<Candidate> fast = FastPart(path);
  FindRoom(field, from.Radius, fast);
  const double room = std::min(fast.front().Room, enoughRoom);
  const Candidate best = FarthestReaching(field, polygon, fast, halfDiagonal, room, reach);
  Candidate inflow;
  if (path.LeavesData && FindInflow(field, path, std::min(room, inflowRoom), inflow))
  {
    for (const Candidate& c : Widths(field, inflow))
    {
      const double reachThere = MeanReaches(field, { c }, halfDiagonal).front();
      const bool isFast = IsFastAtRim(field, c) || c.Radius <= from.Radius;
      if (polygon.AreInside(field, { c }).front() && isFast &&
        Step(reachThere / reachStep) >= Step(reach / reachStep))
      {
        reach = reachThere;
        return c;
      }
    }
  }
  return best;
}
}
