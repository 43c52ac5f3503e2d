// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a cell gives to each of its corners, by where they are. Plain C++17.
#ifndef nephoscope_CornerShares_h
#define nephoscope_CornerShares_h

#include "CellKinds.h"
#include "CellShape.h"

#include <array>
#include <vector>

namespace nephoscope
{
// In the order of VTK_HEXAHEDRON.
using HexahedronCorners = std::array<Vector3, 8>;

// The part of all directions that a hexahedron's corner takes in a lattice.
constexpr double angleInLattice = 1.0 / 8;

// Fills `shares`, one for each corner of the solid at `x` with this volume, and returns the mean
// square of its edges. `times`: of parts of a cell that overlap; `weights`: the parts of the volume
// that are nearest to each corner, if not by their angles.
double SharesOfSolid(const CellKind& kind, const Vector3* x, double volume, double times,
  const double* weights, CellShare* shares);

// Without points in its faces and its middle, the parts of a quadratic hexahedron would leave gaps
// there. Its corners, and the middles of its edges along each axis, are four lattices, each with
// one sample for each cell: each sample has the shape of a whole cell, and a quarter of its volume.
// Curved edges count as straight ones. Returns the mean square of the edges.
double SharesOfQuadraticHexahedron(
  const HexahedronCorners& x, double volume, CellShare (&shares)[20]);

// The part of a hexahedron's volume that is nearest to each of its corners, by the volume that its
// edges span in the middle of that part.
std::array<double, 8> OctantsOfHexahedron(const HexahedronCorners& x);

struct SurfaceExtent
{
  double Area = 0;
  double Squares = 0; // of its greatest distance from the first corner
};

// `x`: the corners of a polygon, one edge after the other; `shares`: as many.
SurfaceExtent SharesOfPolygon(const std::vector<Vector3>& x, std::vector<CellShare>& shares);
}

#endif
