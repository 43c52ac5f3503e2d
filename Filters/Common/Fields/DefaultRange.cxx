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
vtkMultiProcessController* RanksOfPieces(vtkAlgorithm* filter)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkInformation* output = filter->GetOutputInformation(0);
  const bool isPiece = controller && controller->GetNumberOfProcesses() > 1 &&
    output->Has(SDDP::UPDATE_NUMBER_OF_PIECES()) &&
    output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) == controller->GetNumberOfProcesses();
  return isPiece ? controller : nullptr;
}

std::array<double, 2> RangeOfAllPieces(vtkAlgorithm* filter)
{
  const std::array<double, 2> mine = RangeOfDefaultArrays(filter->GetInputDataObject(0, 0));
  std::array<double, 2> all = mine;
  if (vtkMultiProcessController* controller = RanksOfPieces(filter))
  {
    controller->AllReduce(&mine[0], &all[0], 1, vtkCommunicator::MIN_OP);
    controller->AllReduce(&mine[1], &all[1], 1, vtkCommunicator::MAX_OP);
  }
  return all;
}

bool IsTrueOfAnyPiece(vtkAlgorithm* filter, bool mine)
{
  const int here = mine ? 1 : 0;
  int any = here;
  if (vtkMultiProcessController* controller = RanksOfPieces(filter))
  {
    controller->AllReduce(&here, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any > 0;
}
}
