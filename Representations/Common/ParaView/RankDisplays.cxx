// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankDisplays.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderingCapabilitiesInformation.h"

#include <utility>

namespace nephoscope
{

std::string WhyRanksWait()
{
  static bool isTold = false;
  auto* ranks = vtkMultiProcessController::GetGlobalController();
  if (!ranks || ranks->GetNumberOfProcesses() < 2 || std::exchange(isTold, true))
  {
    return std::string();
  }
  using Information = vtkPVRenderingCapabilitiesInformation;
  const bool draws =
    Information::Supports(Information::GetLocalCapabilities(), Information::RENDERING);
  const int count = ranks->GetNumberOfProcesses(), own = ranks->GetLocalProcessId();
  const int mine[2] = { draws ? own : count, draws ? count : own };
  int first[2] = { 0, 0 }; // that draws, and that does not
  ranks->AllReduce(mine, first, 2, vtkCommunicator::MIN_OP);
  return first[0] == count || first[1] == count
    ? std::string()
    : "Rank " + std::to_string(first[1]) + " has no display, but rank " + std::to_string(first[0]) +
      " has: ParaView then waits for ever when it draws. Start all ranks with DISPLAY set to a display that they can open, or "
      "use a ParaView with EGL or OSMesa.";
}

} // namespace nephoscope
