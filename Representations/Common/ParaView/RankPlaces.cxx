// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankPlaces.h"

#include "vtkBoundingBox.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

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

// Sorted places of other ranks that may be ours too.
std::vector<PlaceOnRank> PlacesOfOtherRanks(
  vtkMultiProcessController* controller, const std::vector<Vector3>& shared)
{
  const auto ranks = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const vtkIdType length = 3 * static_cast<vtkIdType>(shared.size());
  std::vector<vtkIdType> lengths(ranks), offsets(ranks + 1, 0);
  controller->AllGather(&length, lengths.data(), 1);
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    offsets[rank + 1] = offsets[rank] + lengths[rank];
  }
  std::vector<double> mine, all(static_cast<std::size_t>(offsets[ranks]) + 1);
  mine.reserve(static_cast<std::size_t>(length) + 1);
  for (const Vector3& place : shared)
  {
    mine.insert(mine.end(), place.begin(), place.end());
  }
  controller->AllGatherV(mine.data(), all.data(), length, lengths.data(), offsets.data());
  std::vector<PlaceOnRank> others;
  for (int rank = 0; rank < static_cast<int>(ranks); ++rank)
  {
    const auto at = static_cast<std::size_t>(rank);
    for (auto i = static_cast<std::size_t>(offsets[at]);
         rank != controller->GetLocalProcessId() && i < static_cast<std::size_t>(offsets[at + 1]);
         i += 3)
    {
      others.push_back({ { { all[i], all[i + 1], all[i + 2] } }, rank });
    }
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
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    {
      if (static_cast<int>(rank) != controller->GetLocalProcessId() && boxes[rank].IsValid() &&
        boxes[rank].ContainsPoint(places[i].data()))
      {
        shared.push_back(rounded.Round(places[i]));
        indices.push_back(i);
        break;
      }
    }
  }
  const std::vector<PlaceOnRank> others = PlacesOfOtherRanks(controller, shared);
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
