// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A uniform grid of bins about tetrahedra, each with a list of those that may touch it, so that a
 * ray that walks from bin to bin meets all tetrahedra on its way. Bins are about as large as the
 * tetrahedra or, for flat ones, as cubes of their volume, so that no tetrahedron is in many lists
 * and no list is long.
 */
#ifndef nephoscope_DensityBins_h
#define nephoscope_DensityBins_h

#include "DensityTetrahedra.h"

#include <cstdint>
#include <vector>

namespace nephoscope
{

struct DensityBins
{
  void Sort(const DensityTetrahedra& cells);

  float Low[3] = { 0, 0, 0 };  ///< corner of the first bin
  float Size[3] = { 1, 1, 1 }; ///< of a bin
  int Counts[3] = { 1, 1, 1 }; ///< of bins along each axis
  /**
   * For bin i = x + Counts[0] (y + Counts[1] z) elements [Lists[i], Lists[i + 1]) are its
   * tetrahedra.
   */
  std::vector<std::int32_t> Lists{ 2, 2 };

private:
  void ChooseSize(const DensityTetrahedra& cells);
  void FindCounts();
  double EntriesPerTetrahedron(const DensityTetrahedra& cells) const;
  template <typename Visit>
  void VisitBins(const DensityTetrahedra& cells, std::size_t tetrahedron, Visit visit) const;

  double Extents[3] = { 0, 0, 0 }; ///< of tetrahedra, on average
  double Bounds[6] = { 0, 0, 0, 0, 0, 0 };
  std::size_t Number = 0; ///< of tetrahedra
};

} // namespace nephoscope

#endif
