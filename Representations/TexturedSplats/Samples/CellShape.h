// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Size and shape of linear cells, and the share of them that falls to each corner. Plain C++17.
#ifndef nephoscope_CellShape_h
#define nephoscope_CellShape_h

#include "SplatMatrix.h"
#include "Tetrahedron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
// Solid angle between three edges from one corner (VanOosteromStrackee1983).
inline double SolidAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double x = Norm(a), y = Norm(b), z = Norm(c);
  const double below = x * y * z + Dot(a, b) * z + Dot(b, c) * x + Dot(c, a) * y;
  const double angle = 2.0 * std::atan2(std::abs(Dot(a, Cross(b, c))), below);
  return std::isfinite(angle) ? angle : 0.0;
}

// Adds e e^T.
inline void AddOuterProduct(SplatMatrix& sum, const Vector3& e)
{
  for (std::size_t column = 0; column < 3; ++column)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      sum[column][row] += e[column] * e[row];
    }
  }
}

inline void AddWeighted(SplatMatrix& sum, const SplatMatrix& m, double weight)
{
  for (std::size_t i = 0; i < 9; ++i)
  {
    sum[i / 3][i % 3] += weight * m[i / 3][i % 3];
  }
}

// Columns of a Jacobian that is stored as nine numbers.
inline SplatMatrix MatrixOfShape(const std::array<float, 9>& shape)
{
  SplatMatrix m;
  for (std::size_t i = 0; i < 9; ++i)
  {
    m[i / 3][i % 3] = shape[i];
  }
  return m;
}

// J J^T, which is all that a kernel depends on.
inline SplatMatrix SquareOfShape(const std::array<float, 9>& shape)
{
  SplatMatrix square{};
  for (const Vector3& column : MatrixOfShape(shape))
  {
    AddOuterProduct(square, column);
  }
  return square;
}

// A lower triangle L with L L^T = m (Cholesky): the kernel of a splat depends on nothing else of
// its Jacobian. Columns are 0 where m has no extent of its own.
inline SplatMatrix TriangularRoot(const SplatMatrix& m)
{
  const double least = 1e-12 * (m[0][0] + m[1][1] + m[2][2]);
  SplatMatrix root{};
  for (std::size_t column = 0; column < 3; ++column)
  {
    double pivot = m[column][column];
    for (std::size_t k = 0; k < column; ++k)
    {
      pivot -= root[k][column] * root[k][column];
    }
    if (!(pivot > least))
    {
      continue;
    }
    root[column][column] = std::sqrt(pivot);
    for (std::size_t row = column + 1; row < 3; ++row)
    {
      double rest = m[column][row];
      for (std::size_t k = 0; k < column; ++k)
      {
        rest -= root[k][column] * root[k][row];
      }
      root[column][row] = rest / root[column][column];
    }
  }
  return root;
}

inline SplatMatrix BallOfEdge(double edge)
{
  return { { { { edge, 0, 0 } }, { { 0, edge, 0 } }, { { 0, 0, edge } } } };
}

// Cells without an extent, to rounding, are nothing: filters leave them where they cut a mesh in
// its corners. `length`: the cell's, in the mean; `edge`: of a cube or square of its size;
// `rounding`: how far apart corners in one place may be.
inline bool HasExtent(double edge, double length, double rounding)
{
  constexpr double thinnest = 1e-4; // so that flat cells of any use remain
  return edge > thinnest * length && length > rounding;
}

// What cells give to a sample: a corner, or their middle.
struct CellShare
{
  int Dimension = 0;       // of the cells; those of fewer dimensions do not count
  double Size = 0;         // volume or area
  double Angle = 0;        // share of all directions that the cells lie in
  double MeanAngle = 0;    // the same, if all corners of a hexahedron or wedge were alike
  double LatticeAngle = 0; // the same, if corners were alike along and across those cells
  bool Tetrahedra = false; // some of the cells are tetrahedra
  bool Overlaps = false;   // the edges span more than falls to the sample, by intent
  SplatMatrix Edges{};     // sum over corners of e e^T over the edges there, weighted
  SplatMatrix Normals{};   // of surfaces: sum of n n^T over unit normals, weighted

  void Add(const CellShare& other)
  {
    if (other.Dimension > this->Dimension)
    {
      *this = other;
      return;
    }
    if (other.Dimension < this->Dimension)
    {
      return;
    }
    this->Size += other.Size;
    this->Angle += other.Angle;
    this->MeanAngle += other.MeanAngle;
    this->LatticeAngle += other.LatticeAngle;
    this->Tetrahedra |= other.Tetrahedra;
    this->Overlaps |= other.Overlaps;
    AddWeighted(this->Edges, other.Edges, 1);
    AddWeighted(this->Normals, other.Normals, 1);
  }

  // Tetrahedra at an edge or corner of the data lie in so few directions that their edges do not
  // tell of a shape.
  bool IsOneSided() const { return this->Dimension == 3 && this->Tetrahedra && this->Angle < 0.45; }

  // The part of the ball that the cells fill.
  double Around() const { return this->Angle > 0.999 ? this->Angle : this->LatticeAngle; }

  // The edge of a ball's cell that is as large; 0 if there is no cell. On a boundary cells lie on
  // one side: as much is added on the other; there cells that go on beyond it count, as in a
  // lattice, whose corners at an oblique edge are not alike.
  double EdgeLength() const
  {
    const double around = this->Around();
    const double size = around > 0 ? this->Size / around : 0.0;
    return this->Dimension == 3 ? std::cbrt(size) : std::sqrt(size);
  }

  // Where many thin tetrahedra meet in a point, little of them falls to it, far less than its edges
  // span: its shape is that of the edges, and this is the part of it that counts. So it is where
  // shapes overlap by intent. Else 1.
  double Fill() const
  {
    constexpr double least = 0.1;
    if (this->Dimension < 3 || !(this->MeanAngle > 0))
    {
      return 1;
    }
    const double spanned =
      Determinant(TriangularRoot(this->Edges)) / std::pow(this->MeanAngle, 1.5);
    const double fill = spanned > 0 ? std::pow(this->EdgeLength(), 3) / spanned : 1.0;
    return fill < least || this->Overlaps ? fill : 1.0;
  }

  // Jacobian of the sample: the mean of the corners' edges, scaled to the volume.
  SplatMatrix Jacobian() const
  {
    const double edge = this->EdgeLength() / std::cbrt(this->Fill());
    SplatMatrix root = TriangularRoot(this->Dimension < 3 ? this->SurfaceEdges(edge) : this->Edges);
    const double volume = Determinant(root);
    if (!(volume > 0))
    {
      return BallOfEdge(edge);
    }
    const double scale = edge / std::cbrt(volume);
    for (Vector3& column : root)
    {
      for (double& component : column)
      {
        component *= scale;
      }
    }
    return root;
  }

  // The edges of a surface, scaled to its area; across it, it is as thick as a ball's cell of this
  // edge.
  SplatMatrix SurfaceEdges(double edge) const
  {
    const auto trace = [](const SplatMatrix& m) { return m[0][0] + m[1][1] + m[2][2]; };
    const double extent = trace(this->Edges), normals = trace(this->Normals);
    SplatMatrix padded = this->Edges;
    AddWeighted(padded, this->Normals, normals > 0 ? extent / normals : 0);
    const double area = Determinant(TriangularRoot(padded)) / std::sqrt(extent);
    SplatMatrix scaled{};
    if (area > 0 && std::isfinite(area))
    {
      AddWeighted(scaled, this->Edges, edge * edge / area);
      AddWeighted(scaled, this->Normals, edge * edge / normals);
    }
    return scaled;
  }
};
}

#endif
