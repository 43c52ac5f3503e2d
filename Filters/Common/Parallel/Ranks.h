// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Values over all ranks, which must call these functions together.
#ifndef nephoscope_Ranks_h
#define nephoscope_Ranks_h

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

namespace nephoscope
{
// Null where there is one rank alone.
inline vtkMultiProcessController* OtherRanks()
{
  auto* ranks = vtkMultiProcessController::GetGlobalController();
  return ranks && ranks->GetNumberOfProcesses() > 1 ? ranks : nullptr;
}

template <typename Number>
Number MaximumOverRanks(Number mine)
{
  Number maximum = mine;
  if (auto* ranks = OtherRanks())
  {
    ranks->AllReduce(&mine, &maximum, 1, vtkCommunicator::MAX_OP);
  }
  return maximum;
}
}

#endif
