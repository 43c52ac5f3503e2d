// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The names of blocks, for a filter that the pipeline runs for one block after the other.
#ifndef nephoscope_InputBlocks_h
#define nephoscope_InputBlocks_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include <string>

class vtkAlgorithm;
class vtkCompositeDataIterator;
class vtkDataSet;

namespace nephoscope
{
// "'air'" or, without a name, "3" (the flat index) of the leaf at which an iterator stands.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT std::string NameOfBlock(vtkCompositeDataIterator* leaf);

// "Block 'air': " or "Block 3: " (the flat index), as the start of a message; empty where the input
// has no blocks, or they cannot be seen: the pipeline of VTK hides them, ParaView's shows them.
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT std::string InBlock(vtkAlgorithm* filter, vtkDataSet* block);
}

#endif
