// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** One number for each cut, however many batches have made it. */
#ifndef nephoscope_CutNumbering_h
#define nephoscope_CutNumbering_h

#include "SplitBatch.h"

#include <vector>

namespace nephoscope
{

struct CutNumbering
{
  std::vector<PointCut> Cuts;                  // each once, sorted
  std::vector<std::vector<vtkIdType>> Numbers; // [batch][cut of the batch]: place in Cuts

  CutNumbering(const std::vector<SplitBatch>& batches, vtkIdType numberOfPoints);
};

} // namespace nephoscope

#endif
