// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether what comes in at two ports has been made by the same algorithm somewhere upstream.
#ifndef nephoscope_SharedSource_h
#define nephoscope_SharedSource_h

#include "vtkAlgorithm.h"

#include <algorithm>
#include <set>

namespace nephoscope
{
using Algorithms = std::set<vtkAlgorithm*>;

// All that feed one port.
inline void AddUpstream(vtkAlgorithm* consumer, int port, Algorithms& found)
{
  for (int c = 0; c < consumer->GetNumberOfInputConnections(port); ++c)
  {
    vtkAlgorithm* producer = consumer->GetInputAlgorithm(port, c);
    if (!producer || !found.insert(producer).second)
    {
      continue;
    }
    for (int p = 0; p < producer->GetNumberOfInputPorts(); ++p)
    {
      AddUpstream(producer, p, found);
    }
  }
}

inline bool HaveSharedSource(vtkAlgorithm* consumer, int firstPort, int secondPort)
{
  Algorithms first;
  Algorithms second;
  AddUpstream(consumer, firstPort, first);
  AddUpstream(consumer, secondPort, second);
  return std::any_of(
    second.begin(), second.end(), [&](vtkAlgorithm* a) { return first.count(a) > 0; });
}
}

#endif
