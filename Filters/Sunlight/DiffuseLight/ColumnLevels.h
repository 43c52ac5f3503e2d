// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Approximate solution of the equations of ColumnSolver.h by multigrid: columns are solved exactly,
 * and what is smooth from column to column on coarser grids, each of two by two columns of the one
 * before (Brandt1977). The result is linear and symmetric in the right side. Plain C++17.
 */
#ifndef nephoscope_ColumnLevels_h
#define nephoscope_ColumnLevels_h

#include "LightGrid.h"

#include <array>
#include <vector>

namespace nephoscope
{
/**
 * Columns side by side; couplings of each point with the next one along each axis, and what its row
 * adds up to.
 */
struct ColumnMatrix
{
  int Size[3] = { 0, 0, 0 };
  std::array<std::vector<float>, 3> Next; ///< of last points: 0, or with the first
  std::vector<float> Sum;

  std::size_t Row(int j, int k) const
  {
    return (std::size_t(k) * this->Size[1] + j) * this->Size[0];
  }
  std::size_t Points() const { return std::size_t(this->Size[0]) * this->Size[1] * this->Size[2]; }
};

class ColumnLevels
{
public:
  ColumnLevels() = default;
  ColumnLevels(ColumnMatrix finest, const Parallel& parallel);

  /** The finest level takes the right side and gives the solution. */
  std::vector<float>& Right() { return this->Levels[0].Right; }
  const std::vector<float>& Solve(const Parallel& parallel);

private:
  struct Level
  {
    ColumnMatrix Matrix;
    std::vector<float> Pivot; ///< inverse
    std::vector<float> Right, Solution, Work;

    void Factor(const Parallel& parallel);
    void SolveColumns(const std::vector<float>& right, bool adds, const Parallel& parallel);
    void Residual(const Parallel& parallel);
  };
  static ColumnMatrix Coarser(const ColumnMatrix& fine);
  void Restrict(const Level& fine, Level& coarse, const Parallel& parallel);
  void Interpolate(const Level& coarse, Level& fine, const Parallel& parallel);

  std::vector<Level> Levels;
};
}

#endif
