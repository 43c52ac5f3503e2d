// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The tetrahedra that one polyhedral cell is divided into, and how they are judged. */
#ifndef nephoscope_CellDivision_h
#define nephoscope_CellDivision_h

#include "FaceTriangulation.h"
#include "PolyhedronSurface.h"

#include <array>
#include <set>
#include <vector>

namespace nephoscope
{

struct CellDivision
{
  /**
   * Vertices; those from the number of the surface's vertices on are new points.
   * (p1-p0)x(p2-p0).(p3-p0) > 0.
   */
  std::vector<std::array<int, 4>> Tetrahedra;
  std::vector<Vector3> NewPoints;
  std::vector<std::vector<double>> Weights; ///< of each new point, over the surface's vertices
  std::vector<long long> PointIds;          ///< of the surface's vertices
};

/** A cell's surface with its faces cut into triangles. */
struct TriangulatedSurface
{
  const PolyhedronSurface* Surface = nullptr;
  std::vector<Triangle> Triangles; ///< outward
  std::vector<int> FaceOf;         ///< of each triangle
};

/** Six times the volume that outward triangles enclose. */
inline double SixVolumesInside(const TriangulatedSurface& surface)
{
  double sum = 0;
  const Vector3& origin = surface.Surface->Position(0);
  for (const Triangle& t : surface.Triangles)
  {
    sum += SixVolumes(origin, surface.Surface->Position(t[0]), surface.Surface->Position(t[1]),
      surface.Surface->Position(t[2]));
  }
  return sum;
}

/**
 * Whether tetrahedra fill exactly the volume enclosed by the surface: none is inverted, their
 * unshared faces are the triangles of the surface, and the volumes add up. For what comes from a
 * program that is not ours.
 */
inline bool FillsSurface(const CellDivision& division, const TriangulatedSurface& surface)
{
  const double unit = surface.Surface->Size() * surface.Surface->Size() * surface.Surface->Size();
  const int old = surface.Surface->NumberOfVertices();
  auto position = [&](int v) -> const Vector3& {
    return v < old ? surface.Surface->Position(v)
                   : division.NewPoints[static_cast<std::size_t>(v - old)];
  };
  std::set<Triangle> open; // wound as the surface's, with the least vertex first
  auto turned = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  double sum = 0;
  for (const std::array<int, 4>& t : division.Tetrahedra)
  {
    const double six = SixVolumes(position(t[0]), position(t[1]), position(t[2]), position(t[3]));
    if (!(six > -1e-14 * unit))
    {
      return false;
    }
    sum += six;
    for (const Triangle& face :
      { Triangle{ { t[1], t[2], t[3] } }, Triangle{ { t[0], t[3], t[2] } },
        Triangle{ { t[0], t[1], t[3] } }, Triangle{ { t[0], t[2], t[1] } } })
    {
      if (open.erase(turned({ { face[0], face[2], face[1] } })) == 0 &&
        !open.insert(turned(face)).second)
      {
        return false;
      }
    }
  }
  for (const Triangle& t : surface.Triangles)
  {
    if (open.erase(turned(t)) == 0)
    {
      return false;
    }
  }
  return open.empty() && std::abs(sum - SixVolumesInside(surface)) <= 1e-11 * unit;
}

} // namespace nephoscope

#endif
