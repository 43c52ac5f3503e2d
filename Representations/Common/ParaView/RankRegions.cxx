// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankRegions.h"

#include "vtkBoundingBox.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"

namespace nephoscope
{
namespace
{
std::size_t OwnRank()
{
  return static_cast<std::size_t>(
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId());
}
} // namespace

const std::vector<vtkBoundingBox>* BoxesOfRanks(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  auto* manager = renderView
    ? vtkPVRenderViewDataDeliveryManager::SafeDownCast(renderView->GetDeliveryManager())
    : nullptr;
  return manager && manager->GetUseRedistributedDataAsDeliveredData() ? &manager->GetCuts()
                                                                      : nullptr;
}

bool HasRegion(vtkView* view)
{
  const std::vector<vtkBoundingBox>* boxes = BoxesOfRanks(view);
  return !boxes || (OwnRank() < boxes->size() && (*boxes)[OwnRank()].IsValid());
}

RankRegion RegionOfRank(vtkView* view)
{
  const std::vector<vtkBoundingBox>* boxes = BoxesOfRanks(view);
  const std::size_t rank = OwnRank();
  RankRegion region = wholeSpace;
  if (!boxes || !HasRegion(view))
  {
    return region;
  }
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : *boxes)
  {
    all.AddBox(box);
  }
  for (int side = 0; side < 6; ++side)
  {
    const double bound = (*boxes)[rank].GetBound(side);
    if (bound != all.GetBound(side))
    {
      region[static_cast<std::size_t>(side)] = bound;
    }
  }
  return region;
}

} // namespace nephoscope
