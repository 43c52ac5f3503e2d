// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** One dataset of all that counts in a composite one. */
#ifndef DataBlocks_h
#define DataBlocks_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/** `input` itself (a shallow copy) if it is a dataset that counts, or the blocks of a composite that do, appended. Null without any. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkSmartPointer<vtkDataSet> appendedBlocks(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts);

/** Stores numbers with the data, so that every time step in ParaView's cache keeps its own. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT void storeNumbers(vtkDataSet* data, const char* name, const std::vector<double>& values);

} // namespace nephoscope

#endif
