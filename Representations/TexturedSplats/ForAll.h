// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** A loop by several threads. */
#ifndef ForAll_h
#define ForAll_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <cstddef>

namespace nephoscope
{

/** Calls body(0) to body(count - 1). */
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
