// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What every cell gives to its corners, or to itself. */
#ifndef CellShares_h
#define CellShares_h

#include "CellShape.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

/** One for each point, or cell. `places`: for each point the first one in its place, which gets all, or empty. `hidden`: flags of cells that do not count, or
 * empty. */
std::vector<CellShare> FindCellShares(vtkDataSet* data, bool onCells,
  const std::vector<vtkIdType>& places, const std::vector<unsigned char>& hidden);

} // namespace nephoscope

#endif
