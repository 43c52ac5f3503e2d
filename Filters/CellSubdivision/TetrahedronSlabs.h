// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A tetrahedron with a linear scalar, divided at contour values into tetrahedra, pyramids, wedges
 * and hexahedra.
 *
 * Its vertices are sorted by code (ContourLevels.h). The part in one layer is a slab between two
 * parallel planes: of the vertices some are below the slab, some inside, some above, which makes
 * fifteen cases. On a face of the tetrahedron the slab is
 *
 *     a triangle or a quadrilateral                      which stays whole,
 *     a pentagon, where one vertex is inside,            which is cut as a fan from that vertex;
 *       one below and one above
 *
 * so how a face is divided follows from the face alone, and two tetrahedra that share it agree. The
 * cross sections are triangles or quadrilaterals and stay whole too.
 *
 * A vertex exactly on a value counts as inside both slabs that it touches. The cut on an edge that
 * starts there is the vertex itself; where corners of a piece become one, the piece becomes a
 * simpler one or vanishes.
 */
#ifndef nephoscope_TetrahedronSlabs_h
#define nephoscope_TetrahedronSlabs_h

#include "ContourLevels.h"

#include <algorithm>
#include <array>

namespace nephoscope
{

enum class PieceShape : unsigned char
{
  Nothing = 0,
  Triangle = 3,
  Quadrilateral,
  Tetrahedron,
  Pyramid,
  Wedge,
  Hexahedron
};

constexpr int NumberOfCorners(PieceShape shape)
{
  constexpr int corners[] = { 0, 0, 0, 3, 4, 4, 5, 6, 8 };
  return corners[static_cast<int>(shape)];
}

/**
 * Corners in VTK's order; those of a wedge in the order before VTK 9.7: its first triangle faces
 * away from the second one.
 */
template <typename Corner>
struct Piece
{
  PieceShape Shape = PieceShape::Nothing;
  std::array<Corner, 8> Corners{};
};

namespace slabs
{
// Corners of a piece: vertices 0 to 3, cuts of the six edges at the lower and at the upper value of
// the slab.
enum : signed char
{
  L01 = 4,
  L02,
  L03,
  L12,
  L13,
  L23,
  U01,
  U02,
  U03,
  U12,
  U13,
  U23
};
constexpr int numberOfCornerNames = 16;
constexpr int edgeVertices[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

struct Pattern
{
  PieceShape Shape;
  signed char Corners[8];
};
struct Slab
{
  int Size;
  Pattern Pieces[3];
};

constexpr PieceShape tetrahedron = PieceShape::Tetrahedron;
constexpr PieceShape pyramid = PieceShape::Pyramid;
constexpr PieceShape wedge = PieceShape::Wedge;
constexpr PieceShape hexahedron = PieceShape::Hexahedron;
constexpr Slab none = { 0, {} };

// clang-format off
// [vertices below][vertices inside]; right for a tetrahedron of positive volume.
constexpr Slab table[4][5] = {
  { none,
    { 1, { { tetrahedron, { 0, U01, U02, U03 } } } },
    { 1, { { wedge, { 0, U03, U02, 1, U13, U12 } } } },
    { 1, { { wedge, { U03, U13, U23, 0, 1, 2 } } } },
    { 1, { { tetrahedron, { 0, 1, 2, 3 } } } } },
  { { 1, { { wedge, { U01, U02, U03, L01, L02, L03 } } } },
    { 3, { { tetrahedron, { L01, L02, L03, 1 } }, { pyramid, { U12, U13, U03, U02, 1 } },
           { pyramid, { L02, U02, U03, L03, 1 } } } },
    { 3, { { pyramid, { L01, 1, 2, L02, L03 } }, { pyramid, { 1, U13, U23, 2, U03 } },
           { tetrahedron, { 1, 2, L03, U03 } } } },
    { 1, { { wedge, { 1, 2, 3, L01, L02, L03 } } } },
    none },
  { { 1, { { hexahedron, { L02, L03, L13, L12, U02, U03, U13, U12 } } } },
    { 3, { { tetrahedron, { U03, U23, U13, 2 } }, { pyramid, { L02, L03, L13, L12, 2 } },
           { pyramid, { L03, U03, U13, L13, 2 } } } },
    { 1, { { wedge, { 2, L12, L02, 3, L13, L03 } } } },
    none, none },
  { { 1, { { wedge, { U03, U13, U23, L03, L13, L23 } } } },
    { 1, { { tetrahedron, { L03, L13, L23, 3 } } } },
    none, none, none },
};
// clang-format on

// The cross section at the lower value, by the number of vertices below it; it faces the higher
// scalars.
constexpr Pattern crossSections[4] = {
  { PieceShape::Nothing, {} },
  { PieceShape::Triangle, { L01, L02, L03 } },
  { PieceShape::Quadrilateral, { L02, L03, L13, L12 } },
  { PieceShape::Triangle, { L03, L13, L23 } },
};
} // namespace slabs

/** The mirror image: for tetrahedra of negative volume. */
template <typename Corner>
void Mirror(Piece<Corner>& piece)
{
  auto& c = piece.Corners;
  switch (piece.Shape)
  {
    case PieceShape::Triangle:
    case PieceShape::Tetrahedron:
      std::swap(c[1], c[2]);
      break;
    case PieceShape::Quadrilateral:
    case PieceShape::Pyramid:
      std::swap(c[1], c[3]);
      break;
    case PieceShape::Wedge:
      std::swap_ranges(c.begin(), c.begin() + 3, c.begin() + 3);
      break;
    case PieceShape::Hexahedron:
      std::swap_ranges(c.begin(), c.begin() + 4, c.begin() + 4);
      break;
    default:
      break;
  }
}

namespace slabs
{
// Leaves out corners that repeat their neighbour in a loop; returns how many stay.
template <typename Corner>
int UniqueLoop(std::array<Corner, 8>& c, int size)
{
  int kept = 0;
  for (int i = 0; i < size; ++i)
  {
    if (c[i] != c[(i + 1) % size])
    {
      c[kept++] = c[i];
    }
  }
  return kept;
}

template <typename Corner>
void SimplifyPyramid(Piece<Corner>& piece)
{
  auto& c = piece.Corners;
  const Corner apex = c[4];
  const bool flat = std::find(c.begin(), c.begin() + 4, apex) != c.begin() + 4;
  const int kept = flat ? 0 : UniqueLoop(c, 4);
  c[kept == 3 ? 3 : 4] = apex;
  piece.Shape = kept == 4 ? pyramid : kept == 3 ? tetrahedron : PieceShape::Nothing;
}

// Lateral edges that shrink to a point leave a pyramid, a tetrahedron, nothing.
template <typename Corner>
void SimplifyLateral(Piece<Corner>& piece, int shrunk)
{
  const auto w = piece.Corners;
  int i = 0; // of one edge shrunk the first, of two the other one
  while ((w[i] == w[i + 3]) != (shrunk == 1))
  {
    ++i;
  }
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  if (shrunk == 1)
  {
    piece = { pyramid, { { w[k], w[k + 3], w[j + 3], w[j], w[i] } } };
  }
  else
  {
    piece = { tetrahedron, { { w[i], w[k], w[j], w[i + 3] } } };
  }
}

template <typename Corner>
void SimplifyWedge(Piece<Corner>& piece)
{
  const auto w = piece.Corners;
  const bool first = w[0] == w[1] && w[1] == w[2];
  const bool second = w[3] == w[4] && w[4] == w[5];
  const int shrunk = (w[0] == w[3]) + (w[1] == w[4]) + (w[2] == w[5]);
  if ((first && second) || shrunk == 3)
  {
    piece.Shape = PieceShape::Nothing;
  }
  else if (first)
  {
    piece = { tetrahedron, { { w[3], w[4], w[5], w[0] } } };
  }
  else if (second)
  {
    piece = { tetrahedron, { { w[0], w[2], w[1], w[3] } } };
  }
  else if (shrunk > 0)
  {
    SimplifyLateral(piece, shrunk);
  }
}
} // namespace slabs

/** The remainder of a piece after some of its corners have merged. */
template <typename Corner>
void Simplify(Piece<Corner>& piece)
{
  auto& c = piece.Corners;
  switch (piece.Shape)
  {
    case PieceShape::Triangle:
    case PieceShape::Quadrilateral:
    {
      const int kept = slabs::UniqueLoop(c, NumberOfCorners(piece.Shape));
      piece.Shape = kept < 3 ? PieceShape::Nothing
        : kept == 3          ? PieceShape::Triangle
                             : PieceShape::Quadrilateral;
      break;
    }
    case PieceShape::Tetrahedron:
      for (int i = 0; i < 4; ++i)
      {
        if (std::find(c.begin(), c.begin() + i, c[i]) != c.begin() + i)
        {
          piece.Shape = PieceShape::Nothing;
        }
      }
      break;
    case PieceShape::Pyramid:
      slabs::SimplifyPyramid(piece);
      break;
    case PieceShape::Wedge:
      slabs::SimplifyWedge(piece);
      break;
    default: // no vertex of a hexahedron's slab is on a value
      break;
  }
}

/**
 * Divides one tetrahedron at all values. Corner is a number of a point: `vertices` are given,
 * sorted by code; cut(i, j, level) gives the one where the edge from vertex i to vertex j crosses a
 * value.
 */
template <typename Corner, typename Cut>
class TetrahedronSplitter
{
public:
  TetrahedronSplitter(
    const std::array<Corner, 4>& vertices, const std::array<int, 4>& codes, bool mirrored, Cut cut)
    : Codes(codes)
    , Mirrored(mirrored)
    , MakeCut(cut)
  {
    std::copy(vertices.begin(), vertices.end(), this->Corners.begin());
  }

  /**
   * Calls emitPiece(piece, layer) for each part and emitSurface(polygon, level) for each cross
   * section inside.
   */
  template <typename EmitPiece, typename EmitSurface>
  void Split(EmitPiece emitPiece, EmitSurface emitSurface)
  {
    const int lowest = LowestLayer(this->Codes[0]);
    const int highest = HighestLayer(this->Codes[3]);
    for (int layer = lowest; layer < highest; ++layer)
    {
      this->CutEdges(layer);
      this->EmitSlab(layer, emitPiece, emitSurface);
    }
    this->EmitSlab(highest, emitPiece, emitSurface);
  }

private:
  // Upper cuts of a layer; the lower ones of the next. A vertex on the value is the cut of its
  // edges, on either side.
  void CutEdges(int level)
  {
    const int code = 2 * level + 1;
    for (int e = 0; e < 6; ++e)
    {
      const int i = slabs::edgeVertices[e][0];
      const int j = slabs::edgeVertices[e][1];
      if (this->Codes[i] > code || this->Codes[j] < code)
      {
        continue;
      }
      this->Cuts[e] = this->Codes[j] == code ? this->Corners[j]
        : this->Codes[i] == code             ? this->Corners[i]
                                             : this->MakeCut(i, j, level);
    }
    this->Upper = this->Cuts;
  }

  template <typename EmitPiece, typename EmitSurface>
  void EmitSlab(int layer, EmitPiece& emitPiece, EmitSurface& emitSurface)
  {
    int below = 0;
    int inside = 0;
    bool touched = false; // a vertex is on a value
    for (int c : this->Codes)
    {
      below += c < 2 * layer - 1;
      inside += c >= 2 * layer - 1 && c <= 2 * layer + 1;
      touched = touched || (c & 1) != 0;
    }
    std::copy(this->Lower.begin(), this->Lower.end(), this->Corners.begin() + slabs::L01);
    std::copy(this->Upper.begin(), this->Upper.end(), this->Corners.begin() + slabs::U01);
    this->Lower = this->Upper;
    const slabs::Slab& slab = slabs::table[std::min(below, 3)][inside];
    for (int p = 0; p < slab.Size; ++p)
    {
      this->Emit(slab.Pieces[p], touched, layer, emitPiece);
    }
    if (below > 0)
    {
      this->Emit(slabs::crossSections[below], touched, layer - 1, emitSurface);
    }
  }

  template <typename EmitOne>
  void Emit(const slabs::Pattern& pattern, bool touched, int number, EmitOne& emit)
  {
    Piece<Corner> piece;
    piece.Shape = pattern.Shape;
    for (int i = 0; i < NumberOfCorners(pattern.Shape); ++i)
    {
      piece.Corners[i] = this->Corners[pattern.Corners[i]];
    }
    if (touched)
    {
      Simplify(piece);
    }
    if (this->Mirrored)
    {
      Mirror(piece);
    }
    if (piece.Shape != PieceShape::Nothing)
    {
      emit(piece, number);
    }
  }

  std::array<Corner, slabs::numberOfCornerNames> Corners{};
  std::array<Corner, 6> Cuts{};
  std::array<Corner, 6> Lower{};
  std::array<Corner, 6> Upper{};
  std::array<int, 4> Codes;
  bool Mirrored;
  Cut MakeCut;
};

} // namespace nephoscope

#endif
