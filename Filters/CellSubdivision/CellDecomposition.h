// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Convex cells to tetrahedra, the same way on both sides of every face.
 *
 * A cell is coned from its least vertex: the faces that do not contain it are triangulated as fans
 * from their own least vertices, and each triangle makes a tetrahedron with the apex. A face that
 * does contain the apex has it as its least vertex too, so every face is cut as a fan from its
 * least vertex, for both of its cells (the smallest-index rule of Dompierre1999, for any convex
 * polyhedron). "Least" is any total order of the vertices; TetrahedronSource says which one the
 * mapper takes.
 */
#ifndef nephoscope_CellDecomposition_h
#define nephoscope_CellDecomposition_h

#include <algorithm>
#include <array>
#include <cstddef>

namespace nephoscope
{

/** The faces of a cell as lists of vertices, in a flat form: size, vertices, size, vertices, ... */
template <typename Index>
struct FaceList
{
  const Index* Begin;
  const Index* End;
};

// VTK's linear 3-D cells, every face seen from outside counter-clockwise.
constexpr int tetrahedronFaceList[] = { 3, 1, 2, 3, 3, 0, 3, 2, 3, 0, 1, 3, 3, 0, 2, 1 };
constexpr int hexahedronFaceList[] = { 4, 0, 4, 7, 3, 4, 1, 2, 6, 5, 4, 0, 1, 5, 4, 4, 3, 7, 6, 2,
  4, 0, 3, 2, 1, 4, 4, 5, 6, 7 };
constexpr int voxelFaceList[] = { 4, 0, 4, 6, 2, 4, 1, 3, 7, 5, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0,
  2, 3, 1, 4, 4, 5, 7, 6 };
constexpr int wedgeFaceList[] = { 3, 0, 1, 2, 3, 3, 5, 4, 4, 0, 3, 4, 1, 4, 1, 4, 5, 2, 4, 2, 5, 3,
  0 };
constexpr int pyramidFaceList[] = { 4, 0, 3, 2, 1, 3, 0, 1, 4, 3, 1, 2, 4, 3, 2, 3, 4, 3, 3, 0, 4 };
constexpr int pentagonalPrismFaceList[] = { 5, 0, 4, 3, 2, 1, 5, 5, 6, 7, 8, 9, 4, 0, 1, 6, 5, 4, 1,
  2, 7, 6, 4, 2, 3, 8, 7, 4, 3, 4, 9, 8, 4, 4, 0, 5, 9 };
constexpr int hexagonalPrismFaceList[] = { 6, 0, 5, 4, 3, 2, 1, 6, 6, 7, 8, 9, 10, 11, 4, 0, 1, 7,
  6, 4, 1, 2, 8, 7, 4, 2, 3, 9, 8, 4, 3, 4, 10, 9, 4, 4, 5, 11, 10, 4, 5, 0, 6, 11 };

template <std::size_t N>
constexpr FaceList<int> MakeFaceList(const int (&faces)[N])
{
  return { faces, faces + N };
}

/**
 * Calls emit({a, b, c, d}) for each tetrahedron of a convex cell. `less` orders the vertices that
 * `faces` names.
 */
template <typename Index, typename Less, typename Emit>
void DecomposeCell(FaceList<Index> faces, Less less, Emit emit)
{
  if (faces.Begin == faces.End)
  {
    return;
  }
  Index apex = faces.Begin[1];
  for (const Index* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    const Index least = *std::min_element(face + 1, face + 1 + *face, less);
    apex = less(least, apex) ? least : apex;
  }
  for (const Index* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    const Index* vertices = face + 1;
    const Index size = *face;
    if (std::find(vertices, vertices + size, apex) != vertices + size)
    {
      continue;
    }
    const Index first =
      static_cast<Index>(std::min_element(vertices, vertices + size, less) - vertices);
    for (Index k = 1; k + 1 < size; ++k)
    {
      emit(std::array<Index, 4>{ { apex, vertices[first], vertices[(first + k) % size],
        vertices[(first + k + 1) % size] } });
    }
  }
}

} // namespace nephoscope

#endif
