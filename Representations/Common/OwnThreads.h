// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Threads for our own work, without changing the application's choice of backend. */
#ifndef OwnThreads_h
#define OwnThreads_h

#include "vtkSMPTools.h"

namespace nephoscope
{

template <typename Work>
void withThreads(Work work)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 0, "STDThread", false }, work);
}

} // namespace nephoscope

#endif
