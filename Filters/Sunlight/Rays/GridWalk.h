// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From tetrahedron to tetrahedron of a structured grid (ChessboardGrid.h). What changes is looked
 * up in a table: processors foretell decisions badly.
 *
 * Each vertex has a label: the axis along which it is beside the odd vertex of the tetrahedron, or
 * `odd` for that itself. Between the four even vertices of a cell labels are those of the
 * tetrahedron where the ray came from, and `odd` is the vertex which that had not. Plain C++17.
 */
#ifndef nephoscope_GridWalk_h
#define nephoscope_GridWalk_h

#include "ChessboardGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{
class GridWalk
{
public:
  using Index = std::array<int, 3>;
  static constexpr int odd = 3;

  GridWalk() = default;
  /**
   * Through a face with these labels into the tetrahedron on this side (1 or -1 along each axis) of
   * an odd vertex, or between even ones.
   */
  GridWalk(const ChessboardGrid& grid, const std::array<bool, 3>& closed, const Index& oddVertex,
    const Index& side, const Index& face, bool isBetween)
    : Labels(code(face, isBetween))
    , Moves(moves().data())
    , Odd(static_cast<std::int32_t>(grid.PointNumber(oddVertex[0], oddVertex[1], oddVertex[2])))
  {
    std::int32_t stride = 1;
    const int beyond = next(face, isBetween);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cells[axis] = grid.Size[axis] - 1;
      this->Cell[axis] = oddVertex[axis] + (side[axis] < 0 ? -1 : 0);
      this->Beside[axis] = side[axis] * stride;
      this->Around[axis] = closed[axis] ? this->Cells[axis] * stride : 0;
      this->Offset += isBetween || beyond == axis ? this->Beside[axis] : 0;
      stride *= grid.Size[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->IsInside = this->Enter(axis) && this->IsInside;
    }
  }

  /** Whether the tetrahedron exists. */
  bool Inside() const { return this->IsInside; }
  /** The cell that it is part of. */
  std::int64_t CellNumber() const
  {
    return this->Cell[0] +
      this->Cells[0] * (this->Cell[1] + std::int64_t(this->Cells[1]) * this->Cell[2]);
  }
  /** Its vertex beyond the face. */
  std::int32_t Vertex() const { return this->Odd + this->Offset; }

  /** Whether the walk has crossed a seam since the last TakeTurns. */
  bool HasTurned() const { return this->HasTurns; }
  /**
   * How often it has crossed the seam along each axis: 1 from the first cell to the last, -1 back.
   */
  Index TakeTurns()
  {
    const Index turns = this->Turns;
    this->Turns = { { 0, 0, 0 } };
    this->HasTurns = false;
    return turns;
  }

  /** Leaves the tetrahedron where the new vertex replaces one of the face (0 to 2). */
  void Leave(int replaced)
  {
    const Move& move = this->Moves[3 * this->Labels + replaced];
    this->Labels = move.Labels;
    this->Offset = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Odd += this->Beside[axis] & move.Go[axis];
      this->Beside[axis] = (this->Beside[axis] ^ move.Flip[axis]) - move.Flip[axis];
      this->Offset += this->Beside[axis] & move.Next[axis];
    }
    this->Cell[move.Axis] += (this->Beside[move.Axis] > 0 ? 1 : -1) & move.Cross;
    this->IsInside = this->Enter(move.Axis);
  }

private:
  struct Move // masks: -1 is yes
  {
    std::int32_t Labels = 0, Axis = 0, Cross = 0;
    std::int32_t Go[3] = { 0, 0, 0 }, Flip[3] = { 0, 0, 0 }, Next[3] = { 0, 0, 0 };
  };

  static int code(const Index& face, bool isBetween)
  {
    return face[0] + 4 * face[1] + 16 * face[2] + 64 * int(isBetween);
  }
  // The label that the face has not.
  static int next(const Index& face, bool isBetween)
  {
    return isBetween ? odd : 6 - face[0] - face[1] - face[2];
  }

  static Move moveFrom(Index face, bool isBetween, int replaced)
  {
    Move move;
    const int label = face[replaced];
    face[replaced] = next(face, isBetween);
    const bool goesBetween = !isBetween && label == odd;
    if (isBetween) // the odd vertex across from the even one: seen from there the two other axes
                   // change places
    {
      const int b = (label + 1) % 3, c = (label + 2) % 3;
      move.Go[b] = move.Go[c] = move.Flip[b] = move.Flip[c] = -1;
      for (int& one : face)
      {
        one = one == odd ? label : b + c - one;
      }
    }
    else if (goesBetween)
    {
      move.Next[0] = move.Next[1] = move.Next[2] = -1;
    }
    else
    {
      move.Axis = label;
      move.Cross = move.Flip[label] = move.Next[label] = -1;
    }
    move.Labels = code(face, goesBetween);
    return move;
  }

  static const std::vector<Move>& moves()
  {
    static const std::vector<Move> all = [] {
      std::vector<Move> made(3 * 128);
      for (int number = 0; number < 128; ++number)
      {
        const Index face{ { number & 3, number >> 2 & 3, number >> 4 & 3 } };
        const bool isBetween = number >= 64,
                   differ = face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
        for (int replaced = 0; replaced < 3 && differ && !(isBetween && face[replaced] == odd);
             ++replaced)
        {
          made[3 * number + replaced] = moveFrom(face, isBetween, replaced);
        }
      }
      return made;
    }();
    return all;
  }

  bool Enter(int axis)
  {
    int& cell = this->Cell[axis];
    if (unsigned(cell) < unsigned(this->Cells[axis]))
    {
      return true;
    }
    if (this->Around[axis] == 0)
    {
      return false;
    }
    const int turn = cell < 0 ? 1 : -1;
    cell += turn * this->Cells[axis];
    this->Odd += turn * this->Around[axis];
    this->Turns[axis] += turn;
    this->HasTurns = true;
    return true;
  }

  std::int32_t Labels = 0;
  const Move* Moves = nullptr;
  std::int32_t Odd = 0, Offset = 0, Beside[3] = { 0, 0, 0 };
  int Cell[3] = { 0, 0, 0 }, Cells[3] = { 0, 0, 0 };
  std::int32_t Around[3] = { 0, 0, 0 }; // to the same point, along a closed axis
  Index Turns{ { 0, 0, 0 } };
  bool IsInside = true, HasTurns = false;
};
}

#endif
