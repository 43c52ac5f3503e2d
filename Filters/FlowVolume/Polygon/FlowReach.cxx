// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlowReach.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr int stepsOfLength = 64;
constexpr double fullExtent = 0.25; // of the length

struct Trace
{
  std::size_t Place = 0;
  Vector3 Position{};
  double Time = 0.0;
  double TimeAllowed = 0.0;
  double Length = 0.0;
  vtkBoundingBox Box;
};

// Velocities at some positions, made unit vectors; speeds, 0 where the position is outside or
// nothing flows.
class Directions
{
public:
  explicit Directions(const VelocityField& field)
    : Field(field)
  {
  }

  void Find(const std::vector<Vector3>& positions)
  {
    const std::size_t count = positions.size();
    this->Hints.resize(count);
    this->Inside.assign(count, 0);
    this->Unit.resize(count);
    this->Speed.assign(count, 0.0);
    this->Field.Sample(
      { count, positions.data(), 0.0, this->Unit.data(), this->Inside.data(), this->Hints.data() });
    for (std::size_t i = 0; i < count; ++i)
    {
      const double speed = this->Inside[i] ? vtkMath::Normalize(this->Unit[i].data()) : 0.0;
      this->Speed[i] = std::isfinite(speed) ? speed : 0.0;
    }
  }

  std::vector<Vector3> Unit;
  std::vector<double> Speed;

private:
  const VelocityField& Field;
  std::vector<CellHint> Hints;
  std::vector<unsigned char> Inside;
};

Vector3 Moved(const Vector3& from, const Vector3& direction, double step)
{
  return { { from[0] + step * direction[0], from[1] + step * direction[1],
    from[2] + step * direction[2] } };
}

double ReachOf(const Trace& trace, double length)
{
  const double extent = trace.Box.IsValid() ? trace.Box.GetDiagonalLength() : 0.0;
  return std::min(trace.Length / length, 1.0) * std::min(extent / (fullExtent * length), 1.0);
}
}

std::vector<double> FlowReaches(
  const VelocityField& field, const std::vector<Vector3>& places, double length)
{
  std::vector<double> reaches(places.size(), 0.0);
  std::vector<Trace> traces(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    traces[i].Place = i;
    traces[i].Position = places[i];
    traces[i].Box.AddPoint(traces[i].Position.data());
  }
  const double step = length / stepsOfLength;
  Directions first(field), middle(field);
  // Steps of equal length along the direction of the flow, by the midpoint rule. Two searches a
  // step, with the hints of all traces mixed: the hints are only checked.
  for (int k = 0; k < stepsOfLength && !traces.empty(); ++k)
  {
    std::vector<Vector3> positions(traces.size());
    std::transform(
      traces.begin(), traces.end(), positions.begin(), [](const Trace& t) { return t.Position; });
    first.Find(positions);
    for (std::size_t i = 0; i < traces.size(); ++i)
    {
      positions[i] = Moved(positions[i], first.Unit[i], first.Speed[i] > 0.0 ? 0.5 * step : 0.0);
    }
    middle.Find(positions);
    std::vector<Trace> going;
    for (std::size_t i = 0; i < traces.size(); ++i)
    {
      Trace& trace = traces[i];
      const double speed = middle.Speed[i];
      if (k == 0)
      {
        trace.TimeAllowed = first.Speed[i] > 0.0 ? length / first.Speed[i] : 0.0;
      }
      if (first.Speed[i] > 0.0 && speed > 0.0)
      {
        const double share = std::min(1.0, (trace.TimeAllowed - trace.Time) * speed / step);
        trace.Position = Moved(trace.Position, middle.Unit[i], share * step);
        trace.Length += share * step;
        trace.Time += step / speed;
        trace.Box.AddPoint(trace.Position.data());
      }
      reaches[trace.Place] = ReachOf(trace, length);
      if (first.Speed[i] > 0.0 && speed > 0.0 && trace.Time < trace.TimeAllowed)
      {
        going.push_back(trace);
      }
    }
    traces.swap(going);
  }
  return reaches;
}
}
