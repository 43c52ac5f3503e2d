// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points of a structured grid are neighbours: axes that close to a ring, a last point that
// repeats the first one, rows that are one point (a pole). Plain C++17.
#ifndef nephoscope_GridTopology_h
#define nephoscope_GridTopology_h

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{
using GridIndex = std::array<int, 3>;

// All points along `Along` coincide at the first or the last index of `Across`.
struct PoleRow
{
  int Along = 0;
  int Across = 1;
  bool AtEnd = false;
};

struct GridTopology
{
  GridIndex Size = { { 0, 0, 0 } }; // points that are stored
  std::array<bool, 3> Ring = { { false, false, false } };
  std::array<bool, 3> Repeated = { { false, false,
    false } }; // a ring whose last point is the first one again
  std::vector<PoleRow> Poles;

  std::int64_t Stride(int axis) const
  {
    return axis == 0 ? 1
      : axis == 1    ? this->Size[0]
                     : static_cast<std::int64_t>(this->Size[0]) * this->Size[1];
  }
  std::int64_t Count() const { return this->Stride(2) * this->Size[2]; }
  std::int64_t Id(const GridIndex& at) const
  {
    return at[0] + this->Stride(1) * at[1] + this->Stride(2) * at[2];
  }
  GridIndex Index(std::int64_t id) const
  {
    return { { static_cast<int>(id % this->Size[0]),
      static_cast<int>(id / this->Size[0] % this->Size[1]),
      static_cast<int>(id / this->Stride(2)) } };
  }

  // Points with distinct positions.
  int Distinct(int axis) const { return this->Size[axis] - (this->Repeated[axis] ? 1 : 0); }

  // The index of a point's position among the distinct ones.
  int Canonical(int axis, int i) const
  {
    return this->Ring[axis] && i >= this->Distinct(axis) ? i - this->Distinct(axis) : i;
  }
  GridIndex Canonical(const GridIndex& at) const
  {
    return { { this->Canonical(0, at[0]), this->Canonical(1, at[1]), this->Canonical(2, at[2]) } };
  }

  // The distinct index one step (+1 or -1) on; `i` itself, a distinct index, where the grid ends.
  int Step(int axis, int i, int step) const
  {
    const int last = this->Distinct(axis) - 1;
    const int next = i + step;
    if (next >= 0 && next <= last)
    {
      return next;
    }
    return this->Ring[axis] ? (next < 0 ? last : 0) : i;
  }

  // The pole row that a point belongs to; null if none.
  const PoleRow* PoleAt(const GridIndex& at) const
  {
    for (const PoleRow& pole : this->Poles)
    {
      if (at[pole.Across] == (pole.AtEnd ? this->Size[pole.Across] - 1 : 0))
      {
        return &pole;
      }
    }
    return nullptr;
  }
};
}

#endif
