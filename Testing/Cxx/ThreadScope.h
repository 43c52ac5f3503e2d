// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Runs a function with so many threads, whatever VTK's own default. */
#ifndef nephoscope_ThreadScope_h
#define nephoscope_ThreadScope_h

#include "vtkSMPTools.h"

namespace nephoscope_test
{

template <typename Function>
void WithThreads(int threads, Function&& function)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false), function);
}

} // namespace nephoscope_test

#endif
