// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Threads for our own work, without changing the application's choice of backend. */
#ifndef nephoscope_OwnThreads_h
#define nephoscope_OwnThreads_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <cstddef>

namespace nephoscope
{

/** Calls work(), in which vtkSMPTools has as many threads; 0: one for each core. */
template <typename Work>
void WithThreads(Work&& work, int threads = 0)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false), work);
}

/**
 * Calls body(begin, end) for parts of 0 to count, `grain` at a time (0: as vtkSMPTools likes), by
 * threads of our own.
 */
template <typename Body>
void InParallel(vtkIdType count, Body&& body, vtkIdType grain = 0)
{
  WithThreads([&]() { vtkSMPTools::For(0, count, grain, body); });
}

/** Calls body(0) to body(count - 1), by the threads that vtkSMPTools has. */
template <typename Body>
void ForAll(std::size_t count, Body body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      body(static_cast<std::size_t>(i));
    }
  });
}

} // namespace nephoscope

#endif
