// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnSolver.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace nephoscope
{
ColumnSolver::ColumnSolver(const LightGrid& grid, Parallel parallel)
  : Diagonal(grid.Points(), 0.0)
  , Grid(grid)
  , Rows(std::move(parallel))
  , RowSums(grid.Size[1])
{
  for (auto& next : this->Next)
  {
    next.assign(grid.Points(), 0.0);
  }
}

template <typename Body>
void ColumnSolver::ForRows(Body body)
{
  const LightGrid& g = this->Grid;
  this->Rows(g.Width(1), [&](int j) {
    for (int k = 0; k < g.Size[2]; ++k)
    {
      const std::size_t row = j * g.Stride(1) + k * g.Stride(2);
      for (std::size_t p = row; p < row + g.Width(0); ++p)
      {
        body(p);
      }
    }
  });
}

void ColumnSolver::Factor()
{
  const LightGrid& g = this->Grid;
  ColumnMatrix matrix;
  matrix.Size[0] = g.Width(0);
  matrix.Size[1] = g.Width(1);
  matrix.Size[2] = g.Size[2];
  for (std::vector<float>* one : { &matrix.Next[0], &matrix.Next[1], &matrix.Next[2], &matrix.Sum })
  {
    one->assign(matrix.Points(), 0.0f);
  }
  this->Rows(g.Width(1), [&](int j) {
    for (int k = 0; k < g.Size[2]; ++k)
    {
      for (int i = 0; i < g.Width(0); ++i)
      {
        const int index[3] = { i, j, k };
        const std::size_t p = i + j * g.Stride(1) + k * g.Stride(2), q = matrix.Row(j, k) + i;
        double sum = this->Diagonal[p];
        for (int axis = 0; axis < 3; ++axis)
        {
          const int before = g.Before(index[axis], axis);
          sum -= this->Next[axis][p] +
            (before >= 0
                ? this->Next[axis][p + (before - index[axis]) * std::ptrdiff_t(g.Stride(axis))]
                : 0);
          matrix.Next[axis][q] = static_cast<float>(this->Next[axis][p]);
        }
        matrix.Sum[q] = static_cast<float>(std::max(sum, 0.0));
      }
    }
  });
  this->Levels = ColumnLevels(std::move(matrix), this->Rows);
}

void ColumnSolver::Precondition(const std::vector<double>& right, std::vector<double>& x)
{
  const LightGrid& g = this->Grid;
  const std::size_t width = g.Width(0), rows = g.Width(1);
  const auto forRows = [&](const auto& body) {
    this->Rows(g.Width(1), [&](int j) {
      for (int k = 0; k < g.Size[2]; ++k)
      {
        body(j * g.Stride(1) + k * g.Stride(2), (k * rows + j) * width);
      }
    });
  };
  std::vector<float>& coarse = this->Levels.Right();
  forRows([&](std::size_t from, std::size_t to) {
    std::transform(right.begin() + from, right.begin() + from + width, coarse.begin() + to,
      [](double v) { return static_cast<float>(v); });
  });
  const std::vector<float>& found = this->Levels.Solve(this->Rows);
  forRows([&](std::size_t to, std::size_t from) {
    std::copy(found.begin() + from, found.begin() + from + width, x.begin() + to);
  });
}

void ColumnSolver::Multiply(const std::vector<double>& x, std::vector<double>& product)
{
  const LightGrid& g = this->Grid;
  const std::size_t above = g.Columns(), north = g.Stride(1);
  const int width = g.Width(0);
  this->Rows(g.Width(1), [&](int j) {
    const int southern = g.Before(j, 1), northern = g.After(j, 1);
    for (int k = 0; k < g.Size[2]; ++k)
    {
      const std::size_t row = j * north + k * above, southOf = southern * north + k * above,
                        northOf = northern * north + k * above;
      for (int i = 0; i < width; ++i)
      {
        const std::size_t p = row + i;
        const int before = g.Before(i, 0), after = g.After(i, 0);
        double sum = this->Diagonal[p] * x[p];
        sum -= before >= 0 ? this->Next[0][row + before] * x[row + before] : 0;
        sum -= after >= 0 ? this->Next[0][p] * x[row + after] : 0;
        sum -= southern >= 0 ? this->Next[1][southOf + i] * x[southOf + i] : 0;
        sum -= northern >= 0 ? this->Next[1][p] * x[northOf + i] : 0;
        sum -= k > 0 ? this->Next[2][p - above] * x[p - above] : 0;
        sum -= k + 1 < g.Size[2] ? this->Next[2][p] * x[p + above] : 0;
        product[p] = sum;
      }
    }
  });
}

// Sums of rows, then of these: the same for any number of threads.
double ColumnSolver::Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  const LightGrid& g = this->Grid;
  this->Rows(g.Width(1), [&](int j) {
    double sum = 0;
    for (int k = 0; k < g.Size[2]; ++k)
    {
      const std::size_t row = j * g.Stride(1) + k * g.Stride(2);
      sum = std::inner_product(a.begin() + row, a.begin() + row + g.Width(0), b.begin() + row, sum);
    }
    this->RowSums[j] = sum;
  });
  return std::accumulate(this->RowSums.begin(), this->RowSums.end(), 0.0);
}

int ColumnSolver::Solve(
  const std::vector<double>& right, std::vector<double>& x, double reduction, int most)
{
  const std::size_t n = right.size();
  std::vector<double> residual(n, 0.0), direction(n, 0.0), image(n, 0.0), fitted(n, 0.0);
  this->Multiply(x, image);
  std::transform(right.begin(), right.end(), image.begin(), residual.begin(), std::minus<>());
  this->Precondition(residual, fitted);
  direction = fitted;
  double along = this->Dot(residual, fitted);
  const double enough = reduction * reduction * along;
  int iteration = 0;
  for (; iteration < most && along > enough && along > 0; ++iteration)
  {
    this->Multiply(direction, image);
    const double step = along / this->Dot(direction, image);
    this->ForRows([&](std::size_t p) {
      x[p] += step * direction[p];
      residual[p] -= step * image[p];
    });
    this->Precondition(residual, fitted);
    const double now = this->Dot(residual, fitted), share = now / along;
    this->ForRows([&](std::size_t p) { direction[p] = fitted[p] + share * direction[p]; });
    along = now;
  }
  return iteration;
}
}
