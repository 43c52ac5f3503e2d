// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tetrahedra of a structured grid, found from indices alone.
 *
 * Vertices are even or odd by the sum of their indices, like the squares of a chessboard. A
 * hexahedral cell is divided into the tetrahedron of its four even vertices, and one at each of its
 * odd vertices with that vertex's three neighbours. All edges added run between even vertices, so
 * that cells agree on the diagonals of the faces they share, and diagonals alternate: with the same
 * direction everywhere, clouds would show parallel strokes.
 *
 * Indices are global (extents count), so that pieces of a grid fit together.
 * shaders/ChessboardTopology.glsl walks through it.
 */
#ifndef nephoscope_ChessboardGrid_h
#define nephoscope_ChessboardGrid_h

#include <array>
#include <cstdint>

namespace nephoscope
{

struct ChessboardGrid
{
  int Size[3] = { 0, 0, 0 }; ///< points along each axis
  int OddOffset = 0;         ///< 1 if the first point is odd
  int WrapCells = 0;         ///< cells after which the first axis closes on itself; 0: it is open

  bool IsEmpty() const { return this->Size[0] < 2 || this->Size[1] < 2 || this->Size[2] < 2; }

  std::int64_t NumberOfCells() const
  {
    return this->IsEmpty()
      ? 0
      : std::int64_t(this->Size[0] - 1) * (this->Size[1] - 1) * (this->Size[2] - 1);
  }

  std::int64_t PointNumber(int i, int j, int k) const
  {
    return i + std::int64_t(this->Size[0]) * (j + std::int64_t(this->Size[1]) * k);
  }

  std::array<int, 3> CellIndex(std::int64_t cell) const
  {
    const std::int64_t nx = this->Size[0] - 1;
    const std::int64_t ny = this->Size[1] - 1;
    return { { int(cell % nx), int(cell / nx % ny), int(cell / (nx * ny)) } };
  }

  static constexpr int TetrahedraPerCell = 5;

  /** The tetrahedron at an odd vertex of a cell. */
  struct CornerTetrahedron
  {
    std::array<int, 3> Corner; ///< 0 or 1: which corner of the cell
    std::int64_t Odd;
    std::array<std::int64_t, 3> Neighbors; ///< along each axis

    /** The neighbours along the two other axes, and that along `axis`. */
    std::array<std::int64_t, 3> Across(int axis) const
    {
      return { { this->Neighbors[(axis + 1) % 3], this->Neighbors[(axis + 2) % 3],
        this->Neighbors[axis] } };
    }
  };

  std::array<CornerTetrahedron, 4> CornerTetrahedra(const std::array<int, 3>& cell) const
  {
    std::array<CornerTetrahedron, 4> result;
    const auto corners = this->Corners(cell, 1);
    for (std::size_t k = 0; k < 4; ++k)
    {
      const int o = corners[k];
      result[k] = { { { o & 1, o >> 1 & 1, o >> 2 & 1 } }, this->CornerNumber(cell, o),
        { { this->CornerNumber(cell, o ^ 1), this->CornerNumber(cell, o ^ 2),
          this->CornerNumber(cell, o ^ 4) } } };
    }
    return result;
  }

  /**
   * Point numbers of a cell's tetrahedra: the one between even vertices first; the others begin
   * with their odd vertex.
   */
  std::array<std::array<std::int64_t, 4>, TetrahedraPerCell> Tetrahedra(std::int64_t number) const
  {
    const std::array<int, 3> cell = this->CellIndex(number);
    const auto even = this->Corners(cell, 0);
    const auto corners = this->CornerTetrahedra(cell);
    std::array<std::array<std::int64_t, 4>, TetrahedraPerCell> result;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const CornerTetrahedron& c = corners[k];
      result[0][k] = this->CornerNumber(cell, even[k]);
      result[k + 1] = { { c.Odd, c.Neighbors[0], c.Neighbors[1], c.Neighbors[2] } };
    }
    return result;
  }

private:
  // Corners as bits (x = 1, y = 2, z = 4): the four even (0) or odd (1) ones.
  std::array<int, 4> Corners(const std::array<int, 3>& cell, int parity) const
  {
    const bool evenBits = ((cell[0] + cell[1] + cell[2] + this->OddOffset + parity) & 1) == 0;
    return evenBits ? std::array<int, 4>{ { 0, 3, 5, 6 } } : std::array<int, 4>{ { 1, 2, 4, 7 } };
  }

  std::int64_t CornerNumber(const std::array<int, 3>& cell, int corner) const
  {
    return this->PointNumber(
      cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1));
  }
};

} // namespace nephoscope

#endif
