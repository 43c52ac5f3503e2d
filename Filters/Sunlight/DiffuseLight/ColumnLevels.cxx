// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColumnLevels.h"

#include <algorithm>
#include <utility>

namespace nephoscope
{
namespace
{
constexpr float damping = 0.8f; // of the columns, which do not see one another
}

ColumnLevels::ColumnLevels(ColumnMatrix finest, const Parallel& parallel)
{
  this->Levels.push_back({ std::move(finest), {}, {}, {}, {} });
  while (this->Levels.back().Matrix.Size[0] > 2 || this->Levels.back().Matrix.Size[1] > 2)
  {
    this->Levels.push_back({ Coarser(this->Levels.back().Matrix), {}, {}, {}, {} });
  }
  for (Level& level : this->Levels)
  {
    for (std::vector<float>* one : { &level.Right, &level.Solution, &level.Work, &level.Pivot })
    {
      one->assign(level.Matrix.Points(), 0.0f);
    }
    level.Factor(parallel);
  }
}

// Half of the sum of couplings: those between points twice as far from one another.
ColumnMatrix ColumnLevels::Coarser(const ColumnMatrix& fine)
{
  ColumnMatrix coarse;
  const int nx = fine.Size[0], ny = fine.Size[1];
  coarse.Size[0] = (nx + 1) / 2;
  coarse.Size[1] = (ny + 1) / 2;
  coarse.Size[2] = fine.Size[2];
  for (std::vector<float>* one : { &coarse.Next[0], &coarse.Next[1], &coarse.Next[2], &coarse.Sum })
  {
    one->assign(coarse.Points(), 0.0f);
  }
  for (int k = 0; k < fine.Size[2]; ++k)
  {
    for (int j = 0; j < ny; ++j)
    {
      const std::size_t from = fine.Row(j, k), to = coarse.Row(j / 2, k);
      for (int i = 0; i < nx; ++i)
      {
        const std::size_t p = from + i, q = to + i / 2;
        coarse.Sum[q] += fine.Sum[p];
        coarse.Next[2][q] += fine.Next[2][p];
        coarse.Next[0][q] += i % 2 == 1 || i == nx - 1 ? 0.5f * fine.Next[0][p] : 0;
        coarse.Next[1][q] += j % 2 == 1 || j == ny - 1 ? 0.5f * fine.Next[1][p] : 0;
      }
    }
  }
  return coarse;
}

void ColumnLevels::Level::Factor(const Parallel& parallel)
{
  const ColumnMatrix& m = this->Matrix;
  const int nx = m.Size[0];
  const std::size_t above = m.Row(0, 1);
  parallel(m.Size[1], [&](int j) {
    const int southern = j > 0 ? j - 1 : m.Size[1] - 1;
    for (int k = 0; k < m.Size[2]; ++k)
    {
      for (int i = 0; i < nx; ++i)
      {
        const std::size_t p = m.Row(j, k) + i;
        double rest = double(m.Sum[p]) + m.Next[0][p] + m.Next[1][p] + m.Next[2][p];
        rest += i > 0 ? m.Next[0][p - 1] : m.Next[0][p + nx - 1];
        rest += m.Next[1][m.Row(southern, k) + i];
        if (k > 0)
        {
          const double lower = m.Next[2][p - above];
          rest += lower * (1 - lower * this->Pivot[p - above]);
        }
        this->Pivot[p] = static_cast<float>(rest > 0 ? 1 / rest : 0);
      }
    }
  });
}

void ColumnLevels::Level::SolveColumns(
  const std::vector<float>& right, bool adds, const Parallel& parallel)
{
  const ColumnMatrix& m = this->Matrix;
  const int nx = m.Size[0], levels = m.Size[2];
  const std::ptrdiff_t above = m.Row(0, 1);
  parallel(m.Size[1], [&](int j) {
    std::vector<float> found(std::size_t(nx) * levels);
    for (int k = 0; k < levels; ++k)
    {
      const std::size_t row = m.Row(j, k);
      const float *pivot = &this->Pivot[row], *r = &right[row],
                  *next = k > 0 ? &m.Next[2][row - above] : nullptr;
      float* x = &found[std::size_t(k) * nx];
      for (int i = 0; i < nx; ++i)
      {
        x[i] = pivot[i] * (k > 0 ? r[i] + next[i] * x[i - nx] : r[i]);
      }
    }
    for (int k = levels - 1; k >= 0; --k)
    {
      const std::size_t row = m.Row(j, k);
      const float *pivot = &this->Pivot[row], *next = &m.Next[2][row];
      float *x = &found[std::size_t(k) * nx], *solution = &this->Solution[row];
      for (int i = 0; i < nx && k < levels - 1; ++i)
      {
        x[i] += pivot[i] * next[i] * x[i + nx];
      }
      for (int i = 0; i < nx; ++i)
      {
        solution[i] = (adds ? solution[i] : 0) + damping * x[i];
      }
    }
  });
}

// Right less the matrix times the solution: differences between neighbours keep their digits.
void ColumnLevels::Level::Residual(const Parallel& parallel)
{
  const ColumnMatrix& m = this->Matrix;
  const int nx = m.Size[0], ny = m.Size[1];
  const std::ptrdiff_t above = m.Row(0, 1);
  parallel(ny, [&](int j) {
    for (int k = 0; k < m.Size[2]; ++k)
    {
      const std::size_t row = m.Row(j, k);
      const float *x = &this->Solution[row], *right = &this->Right[row], *sum = &m.Sum[row],
                  *east = &m.Next[0][row];
      float* r = &this->Work[row];
      for (int i = 0; i < nx; ++i)
      {
        r[i] = right[i] - sum[i] * x[i];
      }
      for (int i = 0; i + 1 < nx; ++i)
      {
        r[i] -= east[i] * (x[i] - x[i + 1]);
      }
      for (int i = 1; i < nx; ++i)
      {
        r[i] -= east[i - 1] * (x[i] - x[i - 1]);
      }
      r[0] -= east[nx - 1] * (x[0] - x[nx - 1]);
      r[nx - 1] -= east[nx - 1] * (x[nx - 1] - x[0]);
      const auto flow = [&](const float* coupling, const float* other) {
        for (int i = 0; i < nx; ++i)
        {
          r[i] -= coupling[i] * (x[i] - other[i]);
        }
      };
      const std::size_t south = m.Row((j + ny - 1) % ny, k), north = m.Row((j + 1) % ny, k);
      flow(&m.Next[1][south], &this->Solution[south]);
      flow(&m.Next[1][row], &this->Solution[north]);
      k > 0 ? flow(&m.Next[2][row - above], x - above) : void();
      k + 1 < m.Size[2] ? flow(&m.Next[2][row], x + above) : void();
    }
  });
}

void ColumnLevels::Restrict(const Level& fine, Level& coarse, const Parallel& parallel)
{
  const int nx = fine.Matrix.Size[0], ny = fine.Matrix.Size[1];
  parallel(coarse.Matrix.Size[1], [&](int j) {
    for (int k = 0; k < fine.Matrix.Size[2]; ++k)
    {
      float* to = &coarse.Right[coarse.Matrix.Row(j, k)];
      std::fill(to, to + coarse.Matrix.Size[0], 0.0f);
      for (int row = 2 * j; row < std::min(2 * j + 2, ny); ++row)
      {
        const float* from = &fine.Work[fine.Matrix.Row(row, k)];
        for (int i = 0; i < nx; ++i)
        {
          to[i / 2] += from[i];
        }
      }
    }
  });
}

void ColumnLevels::Interpolate(const Level& coarse, Level& fine, const Parallel& parallel)
{
  const int nx = fine.Matrix.Size[0];
  parallel(fine.Matrix.Size[1], [&](int j) {
    for (int k = 0; k < fine.Matrix.Size[2]; ++k)
    {
      const float* from = &coarse.Solution[coarse.Matrix.Row(j / 2, k)];
      float* to = &fine.Solution[fine.Matrix.Row(j, k)];
      for (int i = 0; i < nx; ++i)
      {
        to[i] += from[i / 2];
      }
    }
  });
}

const std::vector<float>& ColumnLevels::Solve(const Parallel& parallel)
{
  const std::size_t last = this->Levels.size() - 1;
  for (std::size_t l = 0; l <= last; ++l)
  {
    Level& level = this->Levels[l];
    level.SolveColumns(level.Right, false, parallel);
    for (int again = 0; again < (l == last ? 8 : 1); ++again)
    {
      level.Residual(parallel);
      l == last ? level.SolveColumns(level.Work, true, parallel)
                : this->Restrict(level, this->Levels[l + 1], parallel);
    }
  }
  for (std::size_t l = last; l-- > 0;)
  {
    Level& level = this->Levels[l];
    this->Interpolate(this->Levels[l + 1], level, parallel);
    level.Residual(parallel);
    level.SolveColumns(level.Work, true, parallel);
  }
  return this->Levels[0].Solution;
}
}
