// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A symmetric positive definite system that couples each point of a grid with its six neighbours:
 * conjugate gradients, with whole columns solved exactly as preconditioner (HestenesStiefel1952).
 * It is fast for columns that are lower than wide, as in the atmosphere. Plain C++17.
 */
#ifndef nephoscope_ColumnSolver_h
#define nephoscope_ColumnSolver_h

#include "ColumnLevels.h"
#include "LightGrid.h"

#include <cstddef>
#include <vector>

namespace nephoscope
{
class ColumnSolver
{
public:
  explicit ColumnSolver(const LightGrid& grid, Parallel parallel);

  std::vector<double> Diagonal;
  std::vector<double> Next[3]; ///< what couples each point with the one after it along each axis,
                               ///< with the sign of a conductance

  /** To be called once the matrix is set. */
  void Factor();

  /**
   * Starts from `x` and stops when the residual has fallen to that fraction of its initial value.
   * Returns iterations.
   */
  int Solve(const std::vector<double>& right, std::vector<double>& x, double reduction, int most);

private:
  template <typename Body>
  void ForRows(Body body);
  double Dot(const std::vector<double>& a, const std::vector<double>& b);
  void Multiply(const std::vector<double>& x, std::vector<double>& product);
  void Precondition(const std::vector<double>& right, std::vector<double>& x);

  const LightGrid& Grid;
  Parallel Rows;
  ColumnLevels Levels;
  std::vector<double> RowSums;
};
}

#endif
