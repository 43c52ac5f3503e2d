// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Polyhedra with volumes known in closed form. */
#ifndef nephoscope_PolyhedronExamples_h
#define nephoscope_PolyhedronExamples_h

#include "PolyhedronSurface.h"

#include <array>
#include <vector>

namespace nephoscope_test
{

using nephoscope::Vector3;

struct Polyhedron
{
  std::vector<Vector3> Points;
  std::vector<int> Faces; ///< size, vertices, size, vertices, ...

  nephoscope::FaceList<int> FaceStream() const
  {
    return { Faces.data(), Faces.data() + Faces.size() };
  }
  nephoscope::PolyhedronSurface::State Build(nephoscope::PolyhedronSurface& surface) const
  {
    return surface.Build(
      this->FaceStream(), [this](int v) { return this->Points[static_cast<std::size_t>(v)]; });
  }
};

using Polygon = std::vector<std::array<double, 2>>;

inline const Polygon squarePolygon = { { { 0, 0 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } };
inline const Polygon lPolygon = { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 1 } },
  { { 1, 2 } }, { { 0, 2 } } };
inline const Polygon uPolygon = { { { 0, 0 } }, { { 3, 0 } }, { { 3, 2 } }, { { 2, 2 } },
  { { 2, 1 } }, { { 1, 1 } }, { { 1, 2 } }, { { 0, 2 } } };

/** A right prism of height 1. */
inline Polyhedron MakePrism(const Polygon& polygon)
{
  Polyhedron result;
  const int n = static_cast<int>(polygon.size());
  for (const double z : { 0.0, 1.0 })
  {
    for (const auto& p : polygon)
    {
      result.Points.push_back({ { p[0], p[1], z } });
    }
  }
  for (const int level : { 0, 1 })
  {
    result.Faces.push_back(n);
    for (int k = 0; k < n; ++k)
    {
      result.Faces.push_back(level == 0 ? n - 1 - k : n + k);
    }
  }
  for (int k = 0; k < n; ++k)
  {
    const int next = (k + 1) % n;
    result.Faces.insert(result.Faces.end(), { 4, k, next, n + next, n + k });
  }
  return result;
}

/** Two polyhedra in one. */
inline Polyhedron Joined(const Polyhedron& a, const Polyhedron& b)
{
  Polyhedron result = a;
  const int shift = static_cast<int>(a.Points.size());
  result.Points.insert(result.Points.end(), b.Points.begin(), b.Points.end());
  for (std::size_t i = 0; i < b.Faces.size();)
  {
    const int size = b.Faces[i];
    result.Faces.push_back(size);
    for (int k = 1; k <= size; ++k)
    {
      result.Faces.push_back(b.Faces[i + static_cast<std::size_t>(k)] + shift);
    }
    i += static_cast<std::size_t>(size) + 1;
  }
  return result;
}

inline Polyhedron Moved(Polyhedron p, double scale, const Vector3& by)
{
  for (Vector3& x : p.Points)
  {
    x = { { scale * x[0] + by[0], scale * x[1] + by[1], scale * x[2] + by[2] } };
  }
  return p;
}

/** Volume inside the surface as it is wound: cones from its first vertex, faces as fans. */
inline double VolumeOf(const nephoscope::PolyhedronSurface& surface)
{
  double six = 0;
  const nephoscope::FaceList<int> faces = surface.Faces();
  for (const int* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    for (int k = 2; k < *face; ++k)
    {
      six += nephoscope::SixVolumes(surface.Position(0), surface.Position(face[1]),
        surface.Position(face[k]), surface.Position(face[k + 1]));
    }
  }
  return six / 6;
}

} // namespace nephoscope_test

#endif
