// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Volume, centre and covariance of a cell, of the tetrahedra or triangles that it consists of.
// Plain C++17.
#ifndef nephoscope_CellMoments_h
#define nephoscope_CellMoments_h

#include "SplatMatrix.h"
#include "Tetrahedron.h"

#include <cmath>
#include <cstddef>

namespace nephoscope
{
/*
 * A splat is its cell, blurred: its covariance is that of the cell plus that of the blur, which is
 * the same for neighbours of like shape. On a lattice both are multiples of the square of the
 * shape, and the sum is the variance of the kernel, 0.45 squared.
 */
constexpr double varianceOfKernel = 0.45 * 0.45, varianceOfCube = 1.0 / 12;
constexpr double blurOfSquare = 1 - varianceOfCube / varianceOfKernel;

class CellMoments
{
public:
  // `origin`: near the cell, for the precision.
  explicit CellMoments(const Vector3& origin)
    : Origin(origin)
  {
  }

  void AddTetrahedron(
    const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, double times = 1)
  {
    const Vector3 corners[4] = { a - this->Origin, b - this->Origin, c - this->Origin,
      d - this->Origin };
    const double volume = times * std::abs(SignedVolume(a, b, c, d));
    Vector3 sum{};
    this->Size += volume;
    for (const Vector3& corner : corners)
    {
      this->AddSquare(corner, volume / 20);
      for (std::size_t i = 0; i < 3; ++i)
      {
        sum[i] += corner[i];
        this->First[i] += volume * corner[i] / 4;
      }
    }
    this->AddSquare(sum, volume / 20);
  }

  // Corners in the order of VTK_HEXAHEDRON.
  void AddHexahedron(const Vector3 (&x)[8])
  {
    constexpr int around[6] = { 1, 2, 3, 7, 4, 5 }; // the diagonal from 0 to 6
    for (int i = 0; i < 6; ++i)
    {
      this->AddTetrahedron(x[0], x[around[i]], x[around[(i + 1) % 6]], x[6]);
    }
  }

  double GetSize() const { return this->Size; }

  // Only if the size is not 0.
  Vector3 GetCenter() const
  {
    Vector3 center;
    for (std::size_t i = 0; i < 3; ++i)
    {
      center[i] = this->Origin[i] + this->First[i] / this->Size;
    }
    return center;
  }

  // That of a cube of edge 1 is a twelfth along each axis.
  SplatMatrix GetCovariance() const
  {
    SplatMatrix covariance;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t r = 0; r < 3; ++r)
      {
        covariance[c][r] = this->Second[c][r] / this->Size -
          this->First[c] / this->Size * this->First[r] / this->Size;
      }
    }
    return covariance;
  }

private:
  void AddSquare(const Vector3& x, double weight)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t r = 0; r < 3; ++r)
      {
        this->Second[c][r] += weight * x[c] * x[r];
      }
    }
  }

  Vector3 Origin;
  double Size = 0;
  Vector3 First{};
  SplatMatrix Second{};
};
}

#endif
