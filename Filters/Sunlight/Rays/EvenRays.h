// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rays to the sun through a grid whose points are evenly spaced along its first two axes: an image,
 * or a rectilinear grid with levels at any height.
 *
 * Rays from the even points of a level cross the faces of the tetrahedra (ChessboardGrid.h) in the
 * same places relative to their points, and so do those from the odd points. These places are found
 * once per level. The integral is then the same sum of products for all points of a row, so that a
 * processor computes several points at a time. Plain C++17.
 */
#ifndef nephoscope_EvenRays_h
#define nephoscope_EvenRays_h

#include "ChessboardGrid.h"
#include "SunFrame.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nephoscope
{
class EvenRays : public SunPaths
{
public:
  /** Whether these are the points of such a grid, to 1e-4 of their distances. */
  static bool Fits(const ChessboardGrid& grid, const std::vector<SunPoint>& points);

  EvenRays(const ChessboardGrid& grid, const std::vector<SunPoint>& points);

  void FindDepths(
    std::int32_t first, std::int32_t last, std::array<double, 2>* depths) const override;

private:
  struct Vertex
  {
    int Offset[3] = { 0, 0, 0 }; // from the start of the ray; the third index is that of the grid
    float Weight = 0;
  };
  struct Face // or a place on one, whose value is that of the vertices times their weights
  {
    float Half = 0; // of the way from the face before
    std::array<Vertex, 4> Vertices;
  };
  struct Span // of points in a row that are all even, or all odd, with their depths so far
  {
    int Row = 0, Level = 0, Start = 0, Count = 0; // Start: of the first point in the row
    std::array<std::vector<float>, 2> Values;     // of the fields where the rays are
    std::array<std::vector<double>, 2> Depths;
  };

  bool IsOdd(int i, int j, int k) const { return (i + j + k + this->Grid.OddOffset) % 2 != 0; }
  void SortFields(const std::vector<SunPoint>& points);
  std::size_t RowNumber(int parity, int j, int k) const
  {
    return 2 * (j + std::size_t(this->Grid.Size[1]) * k) + parity;
  }

  std::vector<Face> FacesFrom(int level, bool isOdd) const;
  std::vector<double> Crossings(const Place& at, const Place& slope, int level, bool isOdd) const;
  Face FaceAt(const Place& middle, const Place& at, int level, bool isOdd) const;
  bool IsAboveClouds(const Face& face) const;
  void Follow(const std::vector<Face>& faces, Span& span) const;

  ChessboardGrid Grid;
  std::vector<Place> Slopes; // of the indices along a ray, in each layer between levels
  std::size_t Half;          // points of a row that are all even or all odd
  std::array<std::vector<float>, 2> Fields; // rows of even, then odd first indices
  std::vector<char> IsClear;                // rows
  std::array<int, 2> CloudyLevels{ { 0, -1 } };
};
}

#endif
