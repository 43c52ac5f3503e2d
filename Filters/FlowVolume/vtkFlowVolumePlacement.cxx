// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolumePlacement.h"

#include "DataSets.h"
#include "EvenChoice.h"
#include "FlowReach.h"
#include "FlowVolumeExchange.h"
#include "UpstreamPlace.h"
#include "VelocityFields.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkFlowVolumePlacement);

namespace
{
using nephoscope::Candidate;
using nephoscope::DataSetField;
using nephoscope::FindRoom;
using nephoscope::MeanReaches;
using nephoscope::PolygonPoints;
using nephoscope::SampleAt;
using nephoscope::Step;
using nephoscope::Vector3;

constexpr std::size_t mostCandidates = 2000;
constexpr std::size_t atOnce = 32; // candidates: ranks exchange them together
constexpr int mostHalvings = 7;
constexpr std::size_t mostTraced = 400;
constexpr std::size_t mostWithRim = 24;
constexpr double speedStep = 0.05; // of the greatest speed: speeds closer than this are as good
constexpr double leastSpeed = 0.5; // of the greatest
constexpr double farEnough = 0.35; // that smoke from the fastest place goes, of half the diagonal
constexpr double distanceStep = 1e-5; // of the square of the diagonal
constexpr double qualityStep = 0.05;  // of the best quality: those closer than this are as good

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

// Gives each the greatest of the radii, halved up to 7 times, whose polygon is inside the data;
// else the least.
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

// The first of the sorted candidates whose polygon is inside, with the greatest radius for which
// there is one.
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

// The fastest place with room around it, in steps of 5 % of speed times room, that holds the
// largest polygon; of those that are as good the nearest to the middle.
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
  chosen = nephoscope::UpstreamPlace(*field, polygon, chosen, 0.5 * diagonal, reach);
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
