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
vtkMultiProcessController* OtherRanks()
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}
} // namespace

bool IsSmoke(vtkDataSet* cells)
{
  int mine = SmokeDensity(cells) ? 1 : 0, any = mine;
  if (auto controller = OtherRanks())
  {
    controller->AllReduce(&mine, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any != 0;
}

double SmokeThickness(vtkDataSet* cells)
{
  const double youngestHere = LeastSmokeAge(cells);
  double youngest = youngestHere;
  if (auto controller = OtherRanks())
  {
    controller->AllReduce(&youngestHere, &youngest, 1, vtkCommunicator::MIN_OP);
  }
  vtkBoundingBox box = BoundsOfYoungSmoke(cells, youngest);
  if (auto controller = OtherRanks())
  {
    const vtkBoundingBox mine = box;
    controller->AllReduce(mine, box);
  }
  return DiameterOfSmoke(box);
}

} // namespace nephoscope
