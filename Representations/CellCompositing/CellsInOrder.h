// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A cell compositing mapper among the volumes of a renderer.
#ifndef nephoscope_CellsInOrder_h
#define nephoscope_CellsInOrder_h

#include "VolumeOrder.h"

#include <functional>

class vtkCellCompositingMapper;

namespace nephoscope
{

struct CellsInOrder
{
  /** The part of the mapper that `find` returns. */
  static VolumeOrder::Part PartOf(const std::function<vtkCellCompositingMapper*()>& find);
};

} // namespace nephoscope

#endif
