// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What every cell of a mesh gives to its corners, or to itself. */
#ifndef nephoscope_CellShares_h
#define nephoscope_CellShares_h

#include "CellShape.h"
#include "CornerRing.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

/** One for each point, or cell. */
struct CellShares
{
  std::vector<CellShare> Shares;
  std::vector<std::array<float, 6>>
    Covariances; ///< of cells of three dimensions: xx, xy, xz, yy, yz, zz
  /** Numbers of TaperNeed (CellTaper.h), in sum; empty: nothing is needed. */
  std::vector<std::array<float, 7>> Tapers;
  std::vector<CornerRing>
    Rings; ///< of points, by their places; empty where no cell is a hexahedron
};

/**
 * `places`: for each point the first one in its place, which gets all, or empty. `hidden`: flags of
 * cells that do not count, or empty.
 */
CellShares FindCellShares(vtkDataSet* data, bool onCells, const std::vector<vtkIdType>& places,
  const std::vector<unsigned char>& hidden);

/** A symmetric matrix of its six numbers, the first of an array. */
template <std::size_t size>
SplatMatrix SymmetricMatrix(const std::array<float, size>& m)
{
  return { { { { m[0], m[1], m[2] } }, { { m[1], m[3], m[4] } }, { { m[2], m[4], m[5] } } } };
}

} // namespace nephoscope

#endif
