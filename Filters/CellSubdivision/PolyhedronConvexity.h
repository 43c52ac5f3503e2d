// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a polyhedral cell is convex, and whether the division of CellDecomposition.h fills it.
 *
 * A face of more than three vertices is seldom plane: those of dual meshes and of layers that
 * follow the ground are warped. The surface then consists of the triangles into which both
 * neighbours cut the face, and it is not strictly convex where a diagonal lies inside. Two
 * questions replace the strict one:
 *
 * 1. Is the cell convex apart from the warp of its faces? No vertex lies further outside the mean
 *    plane of a face than the most warped face's own vertices lie from theirs, nor is that warp
 *    more than a part of the cell's size.
 * 2. Does the cone from the least vertex fill the cell? The cones from any point over the triangles
 *    of a closed surface, counted with their signs, add up to the indicator function of the inside:
 *    1 inside, 0 outside. So if no cone is inverted, none overlaps another, none leaves the cell,
 *    and nothing is left out. This holds for warped faces without exception, and needs no
 *    convexity.
 *
 * If both answers are yes, the cell is drawn and divided correctly as it is.
 *
 * All lengths are compared with `slack`: PlaneTolerance times the cell's size, for faces that are
 * planar apart from rounding, plus the displacement of the vertices by rounding (eight steps of the
 * number format at the largest coordinate).
 */
#ifndef nephoscope_PolyhedronConvexity_h
#define nephoscope_PolyhedronConvexity_h

#include "PolyhedronSurface.h"

#include <limits>

namespace nephoscope
{

constexpr double planeTolerance = 1e-6; ///< of the cell's size

/** Lengths below this are rounding. `isFloat`: the coordinates were stored in 32 bits. */
inline double SlackOf(const PolyhedronSurface& surface, bool isFloat)
{
  const double step = isFloat ? double(std::numeric_limits<float>::epsilon())
                              : std::numeric_limits<double>::epsilon();
  return planeTolerance * surface.Size() + 8 * step * surface.Magnitude();
}

/**
 * Question 2: no tetrahedron of the division is inverted by more than `slack` times the square of
 * the cell's size, which is the volume that a face as large as the cell sweeps when it moves by
 * `slack`.
 */
inline bool ConeFillsCell(const PolyhedronSurface& surface, double slack)
{
  const double lowest = -slack * surface.Size() * surface.Size();
  bool fills = true;
  DecomposeCell(
    surface.Faces(), [](int a, int b) { return a < b; },
    [&](const std::array<int, 4>& t) {
      fills = fills &&
        SixVolumes(surface.Position(t[0]), surface.Position(t[1]), surface.Position(t[2]),
          surface.Position(t[3])) >= lowest;
    });
  return fills;
}

/** A plane through the middle of a face: area-weighted mean normal (Newell's), outward. */
struct MeanPlane
{
  Vector3 Normal;
  Vector3 Middle;
  double Height(const Vector3& x) const { return Dot(this->Normal, Difference(x, this->Middle)); }
};

inline MeanPlane MeanPlaneOf(const PolyhedronSurface& surface, const int* face)
{
  MeanPlane plane{ { { 0, 0, 0 } }, { { 0, 0, 0 } } };
  const Vector3& origin = surface.Position(face[1]);
  for (int k = 1; k <= *face; ++k)
  {
    const Vector3 a = Difference(surface.Position(face[k]), origin);
    const Vector3 b = Difference(surface.Position(face[k % *face + 1]), origin);
    const Vector3 twice = Cross(a, b);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      plane.Normal[axis] += twice[axis];
      plane.Middle[axis] += a[axis] / *face;
    }
  }
  const double length = std::sqrt(Dot(plane.Normal, plane.Normal));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    plane.Normal[axis] /= length > 0 ? length : 1;
    plane.Middle[axis] += origin[axis];
  }
  return plane;
}

/** Largest distance of a face's vertices from its mean plane. */
inline double WarpOf(const PolyhedronSurface& surface, const int* face)
{
  const MeanPlane plane = MeanPlaneOf(surface, face);
  double warp = 0;
  for (int k = 1; k <= *face; ++k)
  {
    warp = std::max(warp, std::abs(plane.Height(surface.Position(face[k]))));
  }
  return warp;
}

struct Bulge
{
  double Warp = 0;    ///< largest distance of a face's vertex from the face's mean plane
  double Outside = 0; ///< largest height of another vertex above a face's mean plane
};

inline Bulge MeasureBulge(const PolyhedronSurface& surface)
{
  Bulge bulge;
  const FaceList<int> faces = surface.Faces();
  std::vector<char> own(static_cast<std::size_t>(surface.NumberOfVertices()));
  for (const int* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    const MeanPlane plane = MeanPlaneOf(surface, face);
    std::fill(own.begin(), own.end(), 0);
    for (int k = 1; k <= *face; ++k)
    {
      own[static_cast<std::size_t>(face[k])] = 1;
    }
    for (int v = 0; v < surface.NumberOfVertices(); ++v)
    {
      const double height = plane.Height(surface.Position(v));
      double& largest = own[static_cast<std::size_t>(v)] ? bulge.Warp : bulge.Outside;
      largest = std::max(largest, own[static_cast<std::size_t>(v)] ? std::abs(height) : height);
    }
  }
  return bulge;
}

/**
 * Question 1. `warpTolerance`: the largest warp, as a part of the cell's size, that is still called
 * a warp and not a fold.
 */
inline bool IsConvexButForWarp(const PolyhedronSurface& surface, double slack, double warpTolerance)
{
  const Bulge bulge = MeasureBulge(surface);
  return bulge.Warp <= warpTolerance * surface.Size() + slack &&
    bulge.Outside <= bulge.Warp + slack;
}

} // namespace nephoscope

#endif
