// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cells of a dataset are copies of another rank's.
#ifndef nephoscope_GhostCells_h
#define nephoscope_GhostCells_h

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace nephoscope
{
inline bool IsGhostCell(vtkDataSet* data, vtkIdType cell)
{
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  return ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}
}

#endif
