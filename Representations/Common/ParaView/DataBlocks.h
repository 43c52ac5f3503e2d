// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** One dataset of all that counts in a composite one. */
#ifndef nephoscope_DataBlocks_h
#define nephoscope_DataBlocks_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace nephoscope
{

/**
 * The treatment of points where blocks of 3-D cells abut: each block keeps its own, or coincident
 * points are merged.
 */
enum class BorderPoints
{
  Kept,
  Merged
};

/**
 * `input` itself (a shallow copy) if it is a dataset that counts, or the blocks of a composite that
 * do, appended. Null without any. Arrays that differ in type between blocks become double; an array
 * that only some blocks have is missing (NaN) in the others; blocks without ghost flags, beside
 * some with them, get flags of 0.
 */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkSmartPointer<vtkDataSet> AppendedBlocks(vtkDataObject* input,
  const std::function<bool(vtkDataSet*)>& counts, BorderPoints border = BorderPoints::Kept);

/** Stores numbers with the data, so that every time step in ParaView's cache keeps its own. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT void StoreNumbers(
  vtkDataSet* data, const char* name, const std::vector<double>& values);

} // namespace nephoscope

#endif
