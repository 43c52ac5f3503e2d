// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreakMesh.h"

#include "SmokeGeometry.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
constexpr PointId unused = -1;

// Keeps the values of the points that have a number.
template <typename Value>
void Keep(const std::vector<PointId>& numbers, std::vector<Value>& values)
{
  std::size_t kept = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] != unused)
    {
      values[kept++] = values[p];
    }
  }
  values.resize(kept);
}
}

PointId StreakMesh::AddMiddle(PointId a, PointId b)
{
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const PointId middle = this->AddPoint(Midpoint(this->Positions[i], this->Positions[j]),
    this->Hints[i], 1, 0.5 * (this->ReleaseTimes[i] + this->ReleaseTimes[j]));
  const auto m = static_cast<std::size_t>(middle);
  if (this->Steps[i] == this->Steps[j])
  {
    this->Ways[m] = Midpoint(this->Ways[i], this->Ways[j]);
    this->Steps[m] = this->Steps[i];
  }
  return middle;
}

void StreakMesh::DropUnusedPoints()
{
  std::vector<PointId> numbers(this->Positions.size(), unused);
  const auto use = [&](PointId id) { numbers[static_cast<std::size_t>(id)] = 0; };
  for (const TetrahedronPoints& tetrahedron : this->Tetrahedra)
  {
    std::for_each(tetrahedron.begin(), tetrahedron.end(), use);
  }
  std::fill_n(numbers.begin() + this->Front.First, this->Front.Count, 0);
  for (const HalvedEdge& edge : this->Front.Halved)
  {
    use(edge.Middle);
  }
  PointId next = 0;
  for (PointId& number : numbers)
  {
    number = number == unused ? unused : next++;
  }
  const auto renumber = [&](PointId& id) { id = numbers[static_cast<std::size_t>(id)]; };
  for (TetrahedronPoints& tetrahedron : this->Tetrahedra)
  {
    std::for_each(tetrahedron.begin(), tetrahedron.end(), renumber);
  }
  for (HalvedEdge& edge : this->Front.Halved)
  {
    renumber(edge.A);
    renumber(edge.B);
    renumber(edge.Middle);
  }
  if (this->Front.Count > 0)
  {
    renumber(this->Front.First);
  }
  Keep(numbers, this->Positions);
  Keep(numbers, this->Hints);
  Keep(numbers, this->Inside);
  Keep(numbers, this->ReleaseTimes);
  Keep(numbers, this->Ways);
  Keep(numbers, this->Steps);
}
}
