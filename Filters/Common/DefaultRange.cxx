// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultRange.h"

#include "ChosenPointArray.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace nephoscope
{
namespace
{
// A process that computes everything by itself must not wait for others.
bool IsPieceOfRank(vtkAlgorithm* filter, vtkMultiProcessController* controller)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* output = filter->GetOutputInformation(0);
  return controller && controller->GetNumberOfProcesses() > 1 &&
    output->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) &&
    output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) == controller->GetNumberOfProcesses();
}
}

std::array<double, 2> RangeOfAllPieces(vtkAlgorithm* filter)
{
  const std::array<double, 2> mine = RangeOfDefaultArrays(filter->GetInputDataObject(0, 0));
  std::array<double, 2> all = mine;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (IsPieceOfRank(filter, controller))
  {
    controller->AllReduce(&mine[0], &all[0], 1, vtkCommunicator::MIN_OP);
    controller->AllReduce(&mine[1], &all[1], 1, vtkCommunicator::MAX_OP);
  }
  return all;
}

bool isTrueOfAnyPiece(vtkAlgorithm* filter, bool mine)
{
  const int here = mine ? 1 : 0;
  int any = here;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (IsPieceOfRank(filter, controller))
  {
    controller->AllReduce(&here, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any > 0;
}
}
