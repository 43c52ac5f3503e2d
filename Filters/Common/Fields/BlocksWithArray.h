// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of which only some have the array that a filter works on. The pipeline runs the filter for
// one block after the other, and hides the others.
#ifndef nephoscope_BlocksWithArray_h
#define nephoscope_BlocksWithArray_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include <functional>

class vtkAlgorithm;
class vtkDataSet;

namespace nephoscope
{
class VTKNEPHOSCOPEFILTERSCOMMON_EXPORT BlocksWithArray
{
public:
  // `has` tells whether a block has the array. This observes the filter, whose member it is.
  // `begin`, if given, is called before the first block, on all ranks.
  BlocksWithArray(vtkAlgorithm* filter, std::function<bool(vtkDataSet*)> has,
    std::function<void()> begin = nullptr);

  // While the filter runs: whether any block has the array, on any rank. False where the input has
  // no blocks.
  bool HasAny() const { return this->IsInAny; }

  // For RequestData: true where the filter has nothing to do for a block and nothing to tell,
  // because the block lacks the array and another has it, or because none has it and that has been
  // told for the first one.
  bool IsLackedBy(vtkDataSet* block);

  // To be added to the message that the array is missing.
  const char* NorInOthers() const;

private:
  void Begin();
  void Count();
  void End();

  vtkAlgorithm* Filter;
  std::function<bool(vtkDataSet*)> Has;
  std::function<void()> OnBegin;
  int Depth = 0;  // blocks begin and end within the whole
  int Blocks = 0; // 0: the input is no composite dataset
  bool IsInAny = false;
  bool Told = false;
};
}

#endif
