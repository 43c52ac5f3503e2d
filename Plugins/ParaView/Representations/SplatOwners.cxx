// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatOwners.h"

#include "vtkBoundingBox.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
std::vector<vtkBoundingBox> boundsOfRanks(
  vtkMultiProcessController* controller, const std::vector<SplatVector>& places)
{
  vtkBoundingBox box;
  for (const SplatVector& place : places)
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

// Sorted places of lower ranks that may be ours too.
std::vector<SplatVector> placesOfLowerRanks(
  vtkMultiProcessController* controller, const std::vector<SplatVector>& shared)
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
  for (const SplatVector& place : shared)
  {
    mine.insert(mine.end(), place.begin(), place.end());
  }
  controller->AllGatherV(mine.data(), all.data(), length, lengths.data(), offsets.data());
  std::vector<SplatVector> lower;
  const auto end =
    static_cast<std::size_t>(offsets[static_cast<std::size_t>(controller->GetLocalProcessId())]);
  for (std::size_t i = 0; i < end; i += 3)
  {
    lower.push_back({ { all[i], all[i + 1], all[i + 2] } });
  }
  std::sort(lower.begin(), lower.end());
  return lower;
}
} // namespace

std::vector<bool> ownedByThisRank(const std::vector<SplatVector>& places)
{
  std::vector<bool> owned(places.size(), true);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return owned;
  }
  const std::vector<vtkBoundingBox> boxes = boundsOfRanks(controller, places);
  std::vector<SplatVector> shared;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    {
      if (static_cast<int>(rank) != controller->GetLocalProcessId() && boxes[rank].IsValid() &&
        boxes[rank].ContainsPoint(places[i].data()))
      {
        shared.push_back(places[i]);
        indices.push_back(i);
        break;
      }
    }
  }
  const std::vector<SplatVector> lower = placesOfLowerRanks(controller, shared);
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    owned[indices[i]] = !std::binary_search(lower.begin(), lower.end(), shared[i]);
  }
  return owned;
}

} // namespace nephoscope
