// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra between two layers. Plain C++17.
#ifndef nephoscope_SlabTetrahedra_h
#define nephoscope_SlabTetrahedra_h

#include "SmokeFront.h"

namespace nephoscope
{
// The layer between a front and its position one step later.
struct Slab
{
  const SmokeFront* Below = nullptr;
  const SmokeFront* Above = nullptr; // the same points, and the triangles that go on
  std::vector<PointId>
    TopOf; // which point of Above each point of Below goes to: itself, if no edge was merged
  std::vector<std::size_t>
    Origins; // of every triangle of Above: its number in Below, where more may be
  std::vector<int>
    Patches; // of every triangle of Above: -1, or the number of the merged patch it belongs to
  int NumberOfPatches = 0;
  int EmissionStep = 0;
  double Age = 0.0; // s, in the middle
  double Step = 0.0;
  double SmallestVolume = 0.0; // below it a tetrahedron is flat but for rounding
};

struct SlabSums
{
  double Mass = 0.0;
  std::vector<std::size_t>
    Folded; // triangles of Below with tetrahedra inside out, which are not written
};

// Appends the tetrahedra and writes each triangle's density to `above`.
SlabSums AppendSlab(const Slab& slab, std::vector<FrontTriangle>& above, SmokeMesh& mesh);

// The smallest volume, with sign, of the tetrahedra above a triangle.
double SmallestTetrahedron(const Slab& slab, const TrianglePoints& triangle);

// Halves the tetrahedra from `first` on that contain edge `halved[i]`, at point `firstMiddle + i`;
// their triangles on the front divide as the front itself does. Their volume and what else belongs
// to them stay.
void HalveTetrahedra(const std::vector<std::array<PointId, 2>>& halved, PointId firstMiddle,
  std::size_t first, SmokeMesh& mesh);
}

#endif
