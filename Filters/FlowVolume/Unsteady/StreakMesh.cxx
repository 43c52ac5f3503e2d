// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreakMesh.h"

#include <algorithm>

namespace nephoscope
{
PointId StreakMesh::DropUnusedPoints(PointId first, std::size_t count)
{
  constexpr PointId unused = -1;
  std::vector<PointId> numbers(this->Positions.size(), unused);
  for (const TetrahedronPoints& tetrahedron : this->Tetrahedra)
  {
    for (const PointId id : tetrahedron)
    {
      numbers[static_cast<std::size_t>(id)] = 0;
    }
  }
  std::fill_n(numbers.begin() + first, count, 0);
  PointId next = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] != unused)
    {
      const auto to = static_cast<std::size_t>(next);
      this->Positions[to] = this->Positions[p];
      this->Hints[to] = this->Hints[p];
      this->Inside[to] = this->Inside[p];
      this->ReleaseTimes[to] = this->ReleaseTimes[p];
      numbers[p] = next++;
    }
  }
  const PointId moved = count > 0 ? numbers[static_cast<std::size_t>(first)] : next;
  const auto left = static_cast<std::size_t>(next);
  this->Positions.resize(left);
  this->Hints.resize(left);
  this->Inside.resize(left);
  this->ReleaseTimes.resize(left);
  for (TetrahedronPoints& tetrahedron : this->Tetrahedra)
  {
    for (PointId& id : tetrahedron)
    {
      id = numbers[static_cast<std::size_t>(id)];
    }
  }
  return moved;
}
}
