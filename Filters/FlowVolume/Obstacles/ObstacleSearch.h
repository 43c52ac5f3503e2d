// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Obstacles between the corners of smoke: holes in the field that are too small
// for a corner to meet them.
#ifndef nephoscope_ObstacleSearch_h
#define nephoscope_ObstacleSearch_h

#include "VelocityField.h"

#include <array>
#include <vector>

namespace nephoscope
{
// Samples the field inside prisms and tetrahedra, and on their sides, at
// positions that are no farther from each other than a length; at most
// `mostIntervals` of them along an edge.
class ObstacleSearch
{
public:
  static constexpr int mostIntervals = 64;

  // spacing: a length; 0: no search.
  ObstacleSearch(const VelocityField& field, double time, double spacing, std::size_t count);

  // Number `owner` is a prism between two triangles, with its bottom or
  // without. `hint` of one of its corners.
  void AddPrism(std::size_t owner, const std::array<Vector3, 3>& bottom,
    const std::array<Vector3, 3>& top, bool withBottom, const CellHint& hint);

  void AddTetrahedron(
    std::size_t owner, const std::array<Vector3, 4>& corners, const CellHint& hint);

  // 1 for those with a position outside the field.
  const std::vector<unsigned char>& Find();

private:
  int Intervals(double length) const;
  void Add(std::size_t owner, const Vector3& position, const CellHint& hint);
  void Sample();

  const VelocityField& Field;
  double Time;
  double Spacing;
  std::vector<unsigned char> Blocked;
  std::vector<std::size_t> Owners;
  std::vector<Vector3> Positions;
  std::vector<CellHint> Hints;
};
}

#endif
