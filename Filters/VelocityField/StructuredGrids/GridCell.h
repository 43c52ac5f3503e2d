// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A position in a structured grid: a cell and the coordinates within it. Plain C++17.
#ifndef nephoscope_GridCell_h
#define nephoscope_GridCell_h

#include "VelocityField.h"

#include <cmath>

namespace nephoscope
{
// How far outside a cell a position still counts as inside, in parametric coordinates: above
// rounding, below anything that is visible.
constexpr double PARAMETRIC_TOLERANCE = 1e-9;

struct GridCell
{
  std::array<int, 3> Index{ { 0, 0, 0 } };
  Vector3 Parametric{ { 0.5, 0.5, 0.5 } };
};

// Numbers of points, and ids of points and cells, along axis 0 first.
struct GridSize
{
  std::array<int, 3> Points{ { 0, 0, 0 } };

  int Cells(std::size_t axis) const { return this->Points[axis] - 1; }

  std::int64_t CellCount() const
  {
    return std::int64_t{ this->Cells(0) } * this->Cells(1) * this->Cells(2);
  }

  std::int64_t PointId(const std::array<int, 3>& p) const
  {
    return p[0] + std::int64_t{ this->Points[0] } * (p[1] + std::int64_t{ this->Points[1] } * p[2]);
  }

  std::int64_t CellId(const std::array<int, 3>& c) const
  {
    return c[0] + std::int64_t{ this->Cells(0) } * (c[1] + std::int64_t{ this->Cells(1) } * c[2]);
  }

  // False if there is no such cell.
  bool IndexOfCell(std::int64_t id, std::array<int, 3>& index) const
  {
    if (id < 0 || id >= this->CellCount())
    {
      return false;
    }
    if (id <= 0xffffffff) // a short division takes half the time
    {
      const auto small = static_cast<std::uint32_t>(id);
      const auto row = small / static_cast<std::uint32_t>(this->Cells(0));
      const auto layer = row / static_cast<std::uint32_t>(this->Cells(1));
      index = { static_cast<int>(small - row * static_cast<std::uint32_t>(this->Cells(0))),
        static_cast<int>(row - layer * static_cast<std::uint32_t>(this->Cells(1))),
        static_cast<int>(layer) };
      return true;
    }
    const std::int64_t row = id / this->Cells(0);
    index = { static_cast<int>(id % this->Cells(0)), static_cast<int>(row % this->Cells(1)),
      static_cast<int>(row / this->Cells(1)) };
    return true;
  }

  // Ids of the corners, as offsets from the first: along axis 0 fastest.
  std::array<std::int64_t, 8> CornerOffsets() const
  {
    const std::int64_t row = this->Points[0];
    const std::int64_t layer = row * this->Points[1];
    return { 0, 1, row, row + 1, layer, layer + 1, layer + row, layer + row + 1 };
  }
};

// Trilinear weights of the corners, along axis 0 fastest.
inline std::array<double, 8> TrilinearWeights(const Vector3& r)
{
  const double a = 1.0 - r[0];
  const double b = 1.0 - r[1];
  const double c = 1.0 - r[2];
  return { a * b * c, r[0] * b * c, a * r[1] * c, r[0] * r[1] * c, a * b * r[2], r[0] * b * r[2],
    a * r[1] * r[2], r[0] * r[1] * r[2] };
}

// The same interpolation axis by axis, of triples at `values`, which is the first corner.
template <typename Value>
Vector3 InterpolateTrilinear(
  const Value* values, const std::array<std::int64_t, 8>& corners, const Vector3& r)
{
  Vector3 rows[4];
  for (std::size_t e = 0; e < 4; ++e)
  {
    const Value* a = values + 3 * corners[2 * e];
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double first = a[c];
      rows[e][c] = first + r[0] * (a[c + 3] - first);
    }
  }
  Vector3 result;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double bottom = rows[0][c] + r[1] * (rows[1][c] - rows[0][c]);
    const double top = rows[2][c] + r[1] * (rows[3][c] - rows[2][c]);
    result[c] = bottom + r[2] * (top - bottom);
  }
  return result;
}

// Index and fraction of a coordinate that counts cells from 0 to `cells`; false if it is outside or
// NaN. The upper end belongs to the last cell.
inline bool SplitCoordinate(double coordinate, int cells, int& index, double& fraction)
{
  if (!(coordinate >= -PARAMETRIC_TOLERANCE && coordinate <= cells + PARAMETRIC_TOLERANCE))
  {
    return false;
  }
  index = coordinate <= 0.0 ? 0 : static_cast<int>(coordinate);
  index = index >= cells ? cells - 1 : index;
  fraction = coordinate - index;
  fraction = fraction < 0.0 ? 0.0 : fraction > 1.0 ? 1.0 : fraction;
  return true;
}
}

#endif
