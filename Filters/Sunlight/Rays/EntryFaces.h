// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Boundary faces through which rays to the sun enter a mesh, in pixels across the direction of the
 * sun. A ray that has left the mesh goes on at the next of them: behind a hole, in another part of
 * the mesh, or where the faces of two cells do not fit. Plain C++17.
 */
#ifndef nephoscope_EntryFaces_h
#define nephoscope_EntryFaces_h

#include "SunRay.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{
class EntryFaces
{
public:
  struct Face
  {
    std::array<std::int32_t, 3> Points;
    std::int32_t Tetrahedron; ///< on its side towards the sun
  };

  EntryFaces() = default;
  EntryFaces(const std::vector<SunPoint>& points, std::vector<Face> faces);

  /**
   * Takes the ray to the next face, whose points are in the order of the ray's. Rounding may have
   * put it a little below; it is higher than `last`, where the ray has entered before. Returns the
   * tetrahedron behind the face; -1: there is none.
   */
  std::int32_t Next(const std::vector<SunPoint>& points, double last, SunRay& ray,
    std::array<std::int32_t, 3>& entered) const;

private:
  template <typename Body>
  void ForPixels(const std::vector<SunPoint>& points, Body body) const;
  std::int32_t Pixel(double x, int axis) const;

  std::vector<Face> Faces;
  std::int32_t Size = 1;
  double Origin[2] = { 0, 0 }, PerLength[2] = { 0, 0 };
  double Rounding = 0;               ///< of heights
  std::vector<std::size_t> First;    ///< of each pixel, in `InPixel`
  std::vector<std::int32_t> InPixel; ///< numbers of faces
};
}

#endif
