// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** One dataset of all that counts in a composite one. */
#ifndef DataBlocks_h
#define DataBlocks_h

#include "vtkSmartPointer.h"

#include <functional>

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/** `input` itself (a shallow copy) if it is a dataset that counts, or the blocks of a composite that do, appended. Null without any. */
vtkSmartPointer<vtkDataSet> appendedBlocks(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts);

} // namespace nephoscope

#endif
