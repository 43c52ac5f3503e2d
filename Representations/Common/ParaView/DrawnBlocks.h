// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which blocks of a composite dataset are drawn: those with the arrays that decide about colour and
 * opacity, where any has them.
 */
#ifndef nephoscope_DrawnBlocks_h
#define nephoscope_DrawnBlocks_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkDataObject;

namespace nephoscope
{

/**
 * An array, and what has it: vtkDataObject::POINT, CELL, or POINT_THEN_CELL for either. Without a
 * name every block has it.
 */
struct ArrayOfBlocks
{
  std::string Name;
  int Association;
};

struct DrawnBlocks
{
  vtkSmartPointer<vtkDataObject> Data; // the input itself if no block is left out
  std::string Message;                 // which blocks are left out, and what helps
};

/**
 * The blocks that have the array. A block of `input` for which `counts` is false stays and is not
 * named; so does every block if none has the array, and of AMR data. `onAnyRank` tells whether
 * something is true on any rank: called once, by all ranks.
 */
DrawnBlocks BlocksWith(const ArrayOfBlocks& array, vtkDataObject* input,
  const std::function<bool(vtkDataObject*)>& counts, const std::function<bool(bool)>& onAnyRank);

} // namespace nephoscope

#endif
