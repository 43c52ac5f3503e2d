// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolumePlacement.h"

#include "DataSets.h"
#include "EvenChoice.h"
#include "FlowReach.h"
#include "FlowVolumeExchange.h"
#include "GeneratingPolygon.h"
#include "SmokeGeometry.h"
#include "VelocityFields.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkFlowVolumePlacement);

namespace
{
using nephoscope::DataSetField;
using nephoscope::operator+;
using nephoscope::operator*;
using nephoscope::Vector3;

constexpr std::size_t mostCandidates = 2000;
constexpr std::size_t atOnce = 32; // candidates: ranks exchange them together
constexpr int mostHalvings = 7;
constexpr std::size_t mostTraced = 400;
constexpr std::size_t mostWithRim = 24;
constexpr double mostRoom = 4.0;    // radii of the polygon, across the flow
constexpr double speedStep = 0.05;  // of the greatest speed: speeds closer than this are as good
constexpr double leastSpeed = 0.5;  // of the greatest
constexpr double farEnough = 0.35;  // that smoke from the fastest place goes, of half the diagonal
constexpr double enoughRoom = 0.75; // of `mostRoom`
constexpr double fastEnough = 0.7;  // upstream, of the speed
constexpr double reachStep = 0.05;  // reaches closer than this are as good
constexpr int stepsUpstream = 16;   // each a twentieth of half the diagonal
constexpr double distanceStep = 1e-5; // of the square of the diagonal
constexpr double qualityStep = 0.05;  // of the best quality: those closer than this are as good

// Rounded, and the same if it differs by rounding errors, as it does between numbers of ranks.
double Step(double value)
{
  return std::floor(value + 0.5 + 1e-7);
}

struct Candidate
{
  Vector3 Place{};
  Vector3 Velocity{};
  double Speed = 0.0;
  double Distance = 0.0; // squared, from the middle, in steps: equal ones differ by rounding
  double Radius = 0.0;   // that fits in
  double Room = 0.0;     // share of `mostRoom` radii that is free around it
  double Quality = 0.0;
};

// The choice that vtkFlowVolume makes.
bool Choose(const nephoscope::FlowVolumeExchange& exchange, vtkDataObject* data,
  const std::string& name, bool onCells, nephoscope::VelocityArray& choice, std::string& problem)
{
  vtkNew<vtkInformation> wanted;
  if (!name.empty())
  {
    wanted->Set(vtkDataObject::FIELD_NAME(), name.c_str());
    wanted->Set(vtkDataObject::FIELD_ASSOCIATION(),
      onCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS);
  }
  return exchange.ChooseVelocity(data, wanted, choice, problem);
}

std::vector<unsigned char> SampleAt(
  const DataSetField& field, const std::vector<Vector3>& places, std::vector<Vector3>& velocities)
{
  std::vector<unsigned char> inside(places.size());
  std::vector<nephoscope::CellHint> hints(places.size());
  velocities.resize(places.size());
  field.Sample(
    { places.size(), places.data(), 0.0, velocities.data(), inside.data(), hints.data() });
  return inside;
}

// Places with flow.
std::vector<Candidate> Candidates(
  const DataSetField& field, const std::vector<Vector3>& places, const vtkBoundingBox& box)
{
  std::vector<Vector3> velocities;
  const auto inside = SampleAt(field, places, velocities);
  double middle[3];
  box.GetCenter(middle);
  const double unit = std::max(distanceStep * std::pow(box.GetDiagonalLength(), 2), VTK_DBL_MIN);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    Candidate c{ places[i], velocities[i], vtkMath::Norm(velocities[i].data()),
      Step(vtkMath::Distance2BetweenPoints(places[i].data(), middle) / unit) };
    if (inside[i] && c.Speed > 0.0 && std::isfinite(c.Speed))
    {
      candidates.push_back(c);
    }
  }
  return candidates;
}

// Eight points on the rim of a disc across the flow.
std::vector<Vector3> Rim(const Candidate& candidate, double radius)
{
  double across[3], along[3];
  vtkMath::Perpendiculars(candidate.Velocity.data(), across, along, 0.0);
  std::vector<Vector3> rim;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = i * vtkMath::Pi() / 4.0;
    Vector3 x = candidate.Place;
    for (std::size_t k = 0; k < 3; ++k)
    {
      x[k] += radius * (std::cos(angle) * across[k] + std::sin(angle) * along[k]);
    }
    rim.push_back(x);
  }
  return rim;
}

// The points of the triangles that vtkFlowVolume divides its regular polygon into.
class PolygonPoints
{
public:
  explicit PolygonPoints(int sides)
  {
    const nephoscope::RegularPolygon unit{ {}, 1.0, sides, across };
    const Vector3 u = nephoscope::Perpendicular(across), v = nephoscope::cross(across, u);
    for (const Vector3& point : nephoscope::TriangulateRegularPolygon(unit, 0.0).Points)
    {
      this->Points.push_back({ { nephoscope::dot(point, u), nephoscope::dot(point, v) } });
    }
  }

  // For each of the candidates, with its radius.
  std::vector<bool> AreInside(
    const DataSetField& field, const std::vector<Candidate>& candidates) const
  {
    std::vector<Vector3> places, velocities;
    for (const Candidate& c : candidates)
    {
      this->AddPlaces(c, places);
    }
    const auto inside = SampleAt(field, places, velocities);
    std::vector<bool> all;
    for (auto first = inside.begin(); first != inside.end(); first += this->Count())
    {
      all.push_back(
        std::all_of(first, first + this->Count(), [](unsigned char i) { return i != 0; }));
    }
    return all;
  }

private:
  std::ptrdiff_t Count() const { return static_cast<std::ptrdiff_t>(this->Points.size()); }

  void AddPlaces(const Candidate& c, std::vector<Vector3>& places) const
  {
    const Vector3 normal = nephoscope::normalized(c.Velocity),
                  u = nephoscope::Perpendicular(normal), v = nephoscope::cross(normal, u);
    for (const auto& [a, b] : this->Points)
    {
      places.push_back(c.Place + (rounding * c.Radius * a) * u + (rounding * c.Radius * b) * v);
    }
  }

  static constexpr Vector3 across = { { 0.0, 0.0, 1.0 } };
  static constexpr double rounding = 1.0 + 1e-6;
  std::vector<std::array<double, 2>> Points; // of a polygon of radius 1, in its plane
};

// Gives each the greatest of the radii, halved up to 7 times, whose polygon is inside the data; else the least.
void FitRadii(const DataSetField& field, const PolygonPoints& polygon, double radius,
  std::vector<Candidate>& candidates)
{
  for (Candidate& c : candidates)
  {
    c.Radius = radius;
  }
  for (int halving = 0; halving < mostHalvings; ++halving)
  {
    const std::vector<bool> inside = polygon.AreInside(field, candidates);
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      candidates[i].Radius *= inside[i] ? 1.0 : 0.5;
    }
  }
}

// How far smoke from the middle and the rim of each goes on average.
std::vector<double> MeanReaches(
  const DataSetField& field, const std::vector<Candidate>& candidates, double length)
{
  std::vector<Vector3> places;
  for (const Candidate& c : candidates)
  {
    const std::vector<Vector3> rim = Rim(c, c.Radius);
    places.insert(places.end(), rim.begin(), rim.end());
    places.push_back(c.Place);
  }
  const std::vector<double> reaches = nephoscope::FlowReaches(field, places, length);
  const std::size_t each = places.size() / std::max<std::size_t>(1, candidates.size());
  std::vector<double> means;
  for (auto first = reaches.begin(); first != reaches.end();
       first += static_cast<std::ptrdiff_t>(each))
  {
    means.push_back(std::accumulate(first, first + static_cast<std::ptrdiff_t>(each), 0.0) /
      static_cast<double>(each));
  }
  return means;
}

// How far from the border of the data each is, across the flow: smoke beside a wall sticks to it, or leaves the data.
void FindRoom(const DataSetField& field, double radius, std::vector<Candidate>& candidates)
{
  constexpr std::size_t corners = 8;
  for (Candidate& c : candidates)
  {
    c.Room = 0.0;
  }
  double before = 0.0;
  for (const double radii :
    { 1.0 / 64, 1.0 / 32, 1.0 / 16, 0.125, 0.25, 0.5, 1.0, 2.0, 3.0, mostRoom })
  {
    std::vector<Vector3> places, velocities;
    for (const Candidate& c : candidates)
    {
      const std::vector<Vector3> rim = Rim(c, (1.0 + 1e-6) * radii * radius);
      places.insert(places.end(), rim.begin(), rim.end());
    }
    const auto inside = SampleAt(field, places, velocities);
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      const auto first = inside.begin() + static_cast<std::ptrdiff_t>(i * corners);
      const bool free = std::all_of(first, first + static_cast<std::ptrdiff_t>(corners),
        [](unsigned char j) { return j != 0; });
      const bool soFar = candidates[i].Room >= before;
      candidates[i].Room = free && soFar ? radii / mostRoom : candidates[i].Room;
    }
    before = radii / mostRoom;
  }
}

// The first of the sorted candidates whose polygon is inside, with the greatest radius for which there is one.
Candidate FirstThatFits(const DataSetField& field, const PolygonPoints& polygon,
  const std::vector<Candidate>& candidates, double radius)
{
  for (int halving = 0; halving <= mostHalvings; ++halving, radius *= 0.5)
  {
    for (std::size_t begin = 0; begin < candidates.size(); begin += atOnce)
    {
      const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(begin);
      std::vector<Candidate> some(
        first, first + static_cast<std::ptrdiff_t>(std::min(atOnce, candidates.size() - begin)));
      std::for_each(some.begin(), some.end(), [radius](Candidate& c) { c.Radius = radius; });
      const std::vector<bool> inside = polygon.AreInside(field, some);
      const auto found = std::find(inside.begin(), inside.end(), true);
      if (found != inside.end())
      {
        return some[static_cast<std::size_t>(found - inside.begin())];
      }
    }
  }
  Candidate least = candidates.front();
  least.Radius = radius;
  return least;
}

// The fastest place with room around it, in steps of 5 % of speed times room, that holds the largest polygon; of those that are as good the
// nearest to the middle.
Candidate Fastest(const DataSetField& field, const PolygonPoints& polygon,
  std::vector<Candidate> candidates, double radius)
{
  double greatest = 0.0;
  for (const Candidate& c : candidates)
  {
    greatest = std::max(greatest, c.Speed);
  }
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [&](const Candidate& c) { return c.Speed < leastSpeed * greatest; }),
    candidates.end());
  FindRoom(field, radius, candidates);
  const auto rank = [&](const Candidate& c) {
    return Step(c.Room * c.Speed / (speedStep * greatest));
  };
  std::stable_sort(
    candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
      return rank(a) != rank(b) ? rank(a) > rank(b) : a.Distance < b.Distance;
    });
  return FirstThatFits(field, polygon, candidates, radius);
}

// The best first; among those that are as good the one nearest to the middle.
void SortByQuality(std::vector<Candidate>& candidates)
{
  double best = 0.0;
  for (const Candidate& c : candidates)
  {
    best = std::max(best, c.Quality);
  }
  const double unit = best > 0.0 ? qualityStep * best : 1.0;
  std::stable_sort(
    candidates.begin(), candidates.end(), [unit](const Candidate& a, const Candidate& b) {
      const double first = Step(a.Quality / unit), second = Step(b.Quality / unit);
      return first != second ? first > second : a.Distance < b.Distance;
    });
}

// Evenly chosen ones of a list.
void Thin(std::vector<Candidate>& candidates, std::size_t most)
{
  const std::size_t count = candidates.size();
  for (std::size_t i = 0; count > most && i < most; ++i)
  {
    candidates[i] = candidates[i * count / most];
  }
  candidates.resize(std::min(count, most));
}

// How far smoke from the middle goes, times speed and room.
void JudgeByMiddle(const DataSetField& field, double length, std::vector<Candidate>& candidates)
{
  std::vector<Vector3> places;
  for (const Candidate& c : candidates)
  {
    places.push_back(c.Place);
  }
  const std::vector<double> reaches = nephoscope::FlowReaches(field, places, length);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    candidates[i].Quality = reaches[i] * candidates[i].Speed * candidates[i].Room;
  }
}

// With the rim too, and the share of the radius that fits in.
void JudgeByRim(const DataSetField& field, const PolygonPoints& polygon, double radius,
  double length, std::vector<Candidate>& candidates)
{
  FitRadii(field, polygon, radius, candidates);
  const std::vector<double> reaches = MeanReaches(field, candidates, length);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    Candidate& c = candidates[i];
    c.Quality = reaches[i] * c.Speed * c.Room * c.Radius / radius;
  }
}

// The place and, one after the other, places upstream of it, as far as the flow comes from inside the data and is about as fast.
std::vector<Candidate> Upstream(const DataSetField& field, const Candidate& from, double step)
{
  std::vector<Candidate> path = { from };
  for (int k = 0; k < stepsUpstream; ++k)
  {
    Candidate next = path.back();
    std::vector<Vector3> velocity;
    Vector3 along = next.Velocity;
    for (const double part : { 0.5, 1.0 }) // the midpoint rule
    {
      next.Place = path.back().Place + (-part * step) * nephoscope::normalized(along);
      if (!SampleAt(field, { next.Place }, velocity).front())
      {
        return path;
      }
      along = velocity.front();
    }
    next.Velocity = velocity.front();
    next.Speed = nephoscope::norm(next.Velocity);
    if (!(next.Speed >= fastEnough * from.Speed) || !std::isfinite(next.Speed))
    {
      return path;
    }
    path.push_back(next);
  }
  return path;
}

// The place on that path from which smoke goes farthest, with as much room for the same polygon; of those that are as good the nearest.
Candidate FarthestUpstream(const DataSetField& field, const PolygonPoints& polygon,
  const Candidate& from, double halfDiagonal, double& reach)
{
  std::vector<Candidate> path = Upstream(field, from, halfDiagonal / 20.0);
  FindRoom(field, from.Radius, path);
  const std::vector<bool> inside = polygon.AreInside(field, path);
  const std::vector<double> reaches = MeanReaches(field, path, halfDiagonal);
  const double room = std::min(path.front().Room, enoughRoom);
  std::size_t best = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const bool fits = inside[i] && path[i].Room >= room;
    best = fits && Step(reaches[i] / reachStep) > Step(reaches[best] / reachStep) ? i : best;
  }
  reach = reaches[best];
  return path[best];
}

// Where the product of speed, reach, room and radius is greatest.
Candidate BestTraced(const DataSetField& field, const PolygonPoints& polygon,
  std::vector<Candidate> candidates, double diagonal)
{
  Thin(candidates, mostTraced);
  FindRoom(field, diagonal / 50.0, candidates);
  JudgeByMiddle(field, 0.5 * diagonal, candidates);
  SortByQuality(candidates);
  candidates.resize(std::min(candidates.size(), mostWithRim));
  JudgeByRim(field, polygon, diagonal / 50.0, 0.5 * diagonal, candidates);
  SortByQuality(candidates);
  return candidates.front();
}
}

vtkFlowVolumePlacement::~vtkFlowVolumePlacement()
{
  this->SetController(nullptr);
}

vtkCxxSetObjectMacro(vtkFlowVolumePlacement, Controller, vtkMultiProcessController);

bool vtkFlowVolumePlacement::Find(vtkDataObject* data, const std::string& velocity, bool onCells)
{
  this->Problem.clear();
  this->Speed = this->Quality = 0.0;
  const auto leaves = nephoscope::DataSetsOf(data);
  nephoscope::VelocityArray array;
  const nephoscope::FlowVolumeExchange exchange(this->Controller);
  if (!exchange.AnyTrue(!leaves.empty()) ||
    !Choose(exchange, data, velocity, onCells, array, this->Problem))
  {
    return false;
  }
  const auto field = exchange.MakeVelocityField(data, array, this->Problem);
  if (!field)
  {
    return false;
  }
  const vtkBoundingBox box = exchange.BoundsOf(leaves);
  auto candidates =
    Candidates(*field, nephoscope::EvenlyChosenMiddles(data, box, mostCandidates, exchange), box);
  if (candidates.empty())
  {
    return false;
  }
  const double diagonal = this->Diagonal > 0.0 ? this->Diagonal : box.GetDiagonalLength();
  const PolygonPoints polygon(this->NumberOfSides);
  Candidate chosen = Fastest(*field, polygon, candidates, diagonal / 50.0);
  double reach = MeanReaches(*field, { chosen }, 0.5 * diagonal).front();
  if (reach < farEnough)
  {
    chosen = BestTraced(*field, polygon, candidates, diagonal);
  }
  chosen = FarthestUpstream(*field, polygon, chosen, 0.5 * diagonal, reach);
  this->Quality = reach * chosen.Speed * chosen.Radius / (diagonal / 50.0);
  this->Radius = chosen.Radius;
  std::copy_n(chosen.Place.begin(), 3, this->Center);
  std::copy_n(chosen.Velocity.begin(), 3, this->Normal);
  vtkMath::Normalize(this->Normal);
  this->Speed = chosen.Speed;
  return true;
}

void vtkFlowVolumePlacement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
}
