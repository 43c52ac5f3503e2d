// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cells of blocks as tetrahedra with the density at their vertices; those without any density
 * are left out.
 */
#ifndef nephoscope_DensityTetrahedra_h
#define nephoscope_DensityTetrahedra_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

struct DensityBlock
{
  vtkDataSet* Data;
  vtkDataArray* Densities; ///< of one component
  bool OnCells;
};

struct DensityTetrahedra
{
  using Corners = std::array<std::int32_t, 4>; ///< points, by their coordinates: x, then y, then z

  /** The reason if there are none; otherwise empty. */
  std::string Take(const std::vector<DensityBlock>& blocks);

  double Center[3] = { 0, 0, 0 };
  std::vector<std::array<float, 4>> Points; ///< relative to the centre; the density there
  std::vector<Corners> Tetrahedra;
  std::vector<float>
    CellDensities; ///< one for each tetrahedron where densities are of cells, else none
  double MeanDensity = 1;
  double MeanBoxVolume = 0; ///< six times the mean volume of a tetrahedron
  std::string Warning;

private:
  struct Counts
  {
    std::size_t Solid = 0, Wrong = 0, NotFinite = 0, NotConvex = 0;
    double Mass = 0, Volume = 0;
  };

  void FindCenter(const std::vector<DensityBlock>& blocks);
  void TakeBlock(const DensityBlock& block, bool onCells, Counts& counts);
  void Add(Corners corners, double density, bool onCells, Counts& counts);
  std::string Judge(const Counts& counts);
};

} // namespace nephoscope

#endif
