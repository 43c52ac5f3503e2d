// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolumePlacement.h"

#include "DataSets.h"
#include "VelocityChoice.h"
#include "VelocityFields.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkFlowVolumePlacement);

namespace
{
using nephoscope::DataSetField;
using nephoscope::Vector3;

constexpr vtkIdType mostCandidates = 2000;
constexpr int mostHalvings = 7;
constexpr double speedStep = 0.05; // of the greatest speed: speeds closer than this are as good
constexpr double leastSpeed = 0.5; // of the greatest

struct Candidate
{
  Vector3 Place{};
  Vector3 Velocity{};
  double Speed = 0.0;
  double Rank = 0.0;     // speed in steps
  double Distance = 0.0; // squared, from the middle
};

// The choice that vtkFlowVolume makes.
bool Choose(vtkDataObject* data, const std::string& name, bool onCells,
  nephoscope::VelocityArray& choice, std::string& problem)
{
  vtkNew<vtkInformation> wanted;
  if (!name.empty())
  {
    wanted->Set(vtkDataObject::FIELD_NAME(), name.c_str());
    wanted->Set(vtkDataObject::FIELD_ASSOCIATION(),
      onCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS);
  }
  return nephoscope::ChooseVelocity(data, wanted, choice, problem);
}

// The middles of evenly chosen cells.
std::vector<Vector3> Middles(const std::vector<vtkDataSet*>& leaves)
{
  vtkIdType cells = 0;
  for (vtkDataSet* leaf : leaves)
  {
    cells += leaf->GetNumberOfCells();
  }
  const double stride = std::max(1.0, static_cast<double>(cells) / mostCandidates);
  std::vector<Vector3> middles;
  vtkNew<vtkGenericCell> cell;
  for (vtkDataSet* leaf : leaves)
  {
    for (double i = 0.5 * (stride - 1.0); i < static_cast<double>(leaf->GetNumberOfCells());
         i += stride)
    {
      leaf->GetCell(static_cast<vtkIdType>(i), cell);
      const vtkIdType corners = cell->GetNumberOfPoints();
      Vector3 middle{};
      for (vtkIdType c = 0; c < corners; ++c)
      {
        double x[3];
        cell->Points->GetPoint(c, x);
        for (std::size_t k = 0; k < 3; ++k)
        {
          middle[k] += x[k] / static_cast<double>(corners);
        }
      }
      if (corners > 0)
      {
        middles.push_back(middle);
      }
    }
  }
  return middles;
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

// Places with flow, the best first.
std::vector<Candidate> Candidates(
  const DataSetField& field, const std::vector<Vector3>& places, const vtkBoundingBox& box)
{
  std::vector<Vector3> velocities;
  const auto inside = SampleAt(field, places, velocities);
  double middle[3];
  box.GetCenter(middle);
  std::vector<Candidate> candidates;
  double greatest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    Candidate c{ places[i], velocities[i], vtkMath::Norm(velocities[i].data()), 0.0,
      vtkMath::Distance2BetweenPoints(places[i].data(), middle) };
    if (inside[i] && c.Speed > 0.0 && std::isfinite(c.Speed))
    {
      candidates.push_back(c);
      greatest = std::max(greatest, c.Speed);
    }
  }
  for (Candidate& c : candidates)
  {
    c.Rank = std::round(c.Speed / (speedStep * greatest));
  }
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [&](const Candidate& c) { return c.Speed < leastSpeed * greatest; }),
    candidates.end());
  std::stable_sort(
    candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.Rank != b.Rank ? a.Rank > b.Rank : a.Distance < b.Distance;
    });
  return candidates;
}

// Is the rim of a disc across the flow inside the data, eight points of it?
bool Fits(const DataSetField& field, const Candidate& candidate, double radius)
{
  double across[3], along[3];
  vtkMath::Perpendiculars(candidate.Velocity.data(), across, along, 0.0);
  std::vector<Vector3> rim, velocities;
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
  const auto inside = SampleAt(field, rim, velocities);
  return std::all_of(inside.begin(), inside.end(), [](unsigned char i) { return i != 0; });
}
}

bool vtkFlowVolumePlacement::Find(vtkDataObject* data, const std::string& velocity, bool onCells)
{
  this->Problem.clear();
  this->Speed = 0.0;
  const auto leaves = nephoscope::DataSetsOf(data);
  nephoscope::VelocityArray array;
  if (leaves.empty() || !Choose(data, velocity, onCells, array, this->Problem))
  {
    return false;
  }
  const auto field = nephoscope::MakeVelocityField(data, array, this->Problem);
  if (!field)
  {
    return false;
  }
  vtkBoundingBox box;
  for (vtkDataSet* leaf : leaves)
  {
    box.AddBounds(leaf->GetBounds());
  }
  const auto candidates = Candidates(*field, Middles(leaves), box);
  if (candidates.empty())
  {
    return false;
  }
  this->Radius = (this->Diagonal > 0.0 ? this->Diagonal : box.GetDiagonalLength()) / 50.0;
  auto best = candidates.end();
  for (int halving = 0; halving <= mostHalvings && best == candidates.end(); ++halving)
  {
    this->Radius *= halving > 0 ? 0.5 : 1.0;
    best = std::find_if(candidates.begin(), candidates.end(),
      [&](const Candidate& c) { return Fits(*field, c, this->Radius); });
  }
  const Candidate& chosen = best == candidates.end() ? candidates.front() : *best;
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
