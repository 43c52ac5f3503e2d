// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankPlaces.h"

#include "RankExchange.h"

#include "vtkBoundingBox.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nephoscope
{
namespace
{
std::vector<vtkBoundingBox> BoundsOfRanks(
  vtkMultiProcessController* controller, const std::vector<Vector3>& places)
{
  vtkBoundingBox box;
  for (const Vector3& place : places)
  {
    box.AddPoint(place[0], place[1], place[2]);
  }
  double mine[6];
  box.GetBounds(mine);
  std::vector<double> all(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(mine, all.data(), 6);
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t i = 0; i < all.size(); i += 6)
  {
    boxes.emplace_back(&all[i]);
  }
  return boxes;
}

// A rounded place and the rank that has it.
using PlaceOnRank = std::pair<Vector3, int>;

// Sorted places of other ranks that may be ours too; `own`: those of this rank, for each rank that
// may have them. Each goes to few ranks, whatever their number.
std::vector<PlaceOnRank> PlacesOfOtherRanks(
  vtkMultiProcessController* controller, const std::vector<std::vector<Vector3>>& own)
{
  std::vector<PlaceOnRank> others;
  int rank = 0;
  for (const std::vector<Vector3>& places : TradeRecords(controller, own))
  {
    for (const Vector3& place : places)
    {
      others.push_back({ place, rank });
    }
    ++rank;
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return others;
}

// Places rounded, such that ranks that computed one of them in different ways have the same.
class RoundedPlaces
{
public:
  explicit RoundedPlaces(const std::vector<vtkBoundingBox>& boxes)
  {
    vtkBoundingBox all;
    for (const vtkBoundingBox& box : boxes)
    {
      all.AddBox(box);
    }
    const double diagonal = all.IsValid() ? all.GetDiagonalLength() : 0.0;
    this->Step = diagonal > 0.0 ? 1e-12 * diagonal : 1.0;
  }

  Vector3 Round(const Vector3& place) const
  {
    constexpr double offset = 0.382; // so that round numbers are not between two steps
    Vector3 rounded;
    std::transform(place.begin(), place.end(), rounded.begin(),
      [&](double x) { return std::floor(x / this->Step + offset); });
    return rounded;
  }

  double GetStep() const { return this->Step; }

private:
  double Step;
};
} // namespace

std::vector<SharedPlace> PlacesOfSeveralRanks(const std::vector<Vector3>& places)
{
  std::vector<SharedPlace> found;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return found;
  }
  std::vector<vtkBoundingBox> boxes = BoundsOfRanks(controller, places);
  const RoundedPlaces rounded(boxes);
  for (vtkBoundingBox& box : boxes)
  {
    box.Inflate(box.IsValid() ? rounded.GetStep() : 0.0);
  }
  std::vector<Vector3> shared;
  std::vector<std::size_t> indices;
  std::vector<std::vector<Vector3>> ofRanks(boxes.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Vector3 place = rounded.Round(places[i]);
    bool isShared = false;
    for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    {
      if (static_cast<int>(rank) != controller->GetLocalProcessId() && boxes[rank].IsValid() &&
        boxes[rank].ContainsPoint(places[i].data()))
      {
        ofRanks[rank].push_back(place);
        isShared = true;
      }
    }
    if (isShared)
    {
      shared.push_back(place);
      indices.push_back(i);
    }
  }
  const std::vector<PlaceOnRank> others = PlacesOfOtherRanks(controller, ofRanks);
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    auto other = std::lower_bound(others.begin(), others.end(), PlaceOnRank{ shared[i], 0 });
    for (; other != others.end() && other->first == shared[i]; ++other)
    {
      found.push_back({ indices[i], other->second, shared[i] });
    }
  }
  return found;
}

} // namespace nephoscope
