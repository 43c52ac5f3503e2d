// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeCells.h"

#include "SmokeData.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"

namespace nephoscope
{
namespace
{
vtkMultiProcessController* otherRanks()
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}
} // namespace

bool isSmoke(vtkDataSet* cells)
{
  int mine = smokeDensity(cells) ? 1 : 0, any = mine;
  if (auto controller = otherRanks())
  {
    controller->AllReduce(&mine, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any != 0;
}

double smokeThickness(vtkDataSet* cells)
{
  const double youngestHere = leastSmokeAge(cells);
  double youngest = youngestHere;
  if (auto controller = otherRanks())
  {
    controller->AllReduce(&youngestHere, &youngest, 1, vtkCommunicator::MIN_OP);
  }
  vtkBoundingBox box = boundsOfYoungSmoke(cells, youngest);
  if (auto controller = otherRanks())
  {
    const vtkBoundingBox mine = box;
    controller->AllReduce(mine, box);
  }
  return diameterOfSmoke(box);
}

} // namespace nephoscope
