// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cells of a dataset are blanked.
#ifndef nephoscope_HiddenCells_h
#define nephoscope_HiddenCells_h

#include "vtkDataSetAttributes.h"
#include "vtkNephoscopeFiltersVelocityFieldModule.h" // for export macro
#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{
// A cell is hidden by one of the flags in the vtkGhostType of the cells, HIDDENCELL or REFINEDCELL
// by default, or by a HIDDENPOINT corner.
// Duplicates (ghost copies of other pieces) hold valid values and stay.
class VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT HiddenCells
{
public:
  explicit HiddenCells(vtkDataSet* data,
    unsigned char flags = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL);

  bool Any() const { return !this->Flags.empty(); }
  bool operator[](vtkIdType cell) const
  {
    return this->Any() && this->Flags[static_cast<std::size_t>(cell)] != 0;
  }

private:
  std::vector<unsigned char> Flags; // empty if no cell is hidden
};
}

#endif
