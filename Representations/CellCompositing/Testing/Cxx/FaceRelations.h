// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which tetrahedron lies in front of which, found without FaceNeighbors: pairs with three places in
 * common, and determinants in long double.
 */
#ifndef nephoscope_FaceRelations_h
#define nephoscope_FaceRelations_h

#include "CellGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace nephoscope_test
{

using namespace nephoscope;

struct Relation
{
  std::int32_t Behind, Front;
};

struct InteriorFace
{
  Vector3 Points[3];
  std::int32_t Owners[2];
  Vector3 Apexes[2]; ///< of the owners
};

inline std::vector<InteriorFace> FindInteriorFaces(const CellGeometry& geometry)
{
  std::map<std::array<Vector3, 3>, std::pair<std::int32_t, Vector3>> open;
  std::vector<InteriorFace> faces;
  for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
  {
    const std::array<Vector3, 4> p = geometry.Vertices(i);
    for (std::size_t k = 0; k < 4; ++k)
    {
      std::array<Vector3, 3> face = { { p[(k + 1) % 4], p[(k + 2) % 4], p[(k + 3) % 4] } };
      std::sort(face.begin(), face.end());
      const auto partner = open.find(face);
      if (partner == open.end())
      {
        open[face] = { std::int32_t(i), p[k] };
        continue;
      }
      faces.push_back({ { face[0], face[1], face[2] }, { partner->second.first, std::int32_t(i) },
        { partner->second.second, p[k] } });
      open.erase(partner);
    }
  }
  return faces;
}

/** 6 x volume of the tetrahedron (a, b, c, x), long double; x may be a direction. */
inline long double Orient(const Vector3* f, const Vector4& x)
{
  long double m[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    m[0][axis] = (long double)(f[1][axis]) - f[0][axis];
    m[1][axis] = (long double)(f[2][axis]) - f[0][axis];
    m[2][axis] = (long double)(x[axis]) - x[3] * (long double)(f[0][axis]);
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/**
 * Below this, moving the points by the rounding of float coordinates (of size 1) can turn the sign
 * of orient: the face is seen edge-on, and its owners do not overlap in the picture.
 */
inline long double EdgeOnTolerance(const Vector3* f, const Vector4& eye)
{
  const auto length = [](const Vector3& v) { return std::sqrt(Dot(v, v)); };
  const double ab = length(Difference(f[1], f[0]));
  const double ac = length(Difference(f[2], f[0]));
  const double ae =
    length({ { eye[0] - eye[3] * f[0][0], eye[1] - eye[3] * f[0][1], eye[2] - eye[3] * f[0][2] } });
  return 1e-6 * ((ab + ac) * ae + eye[3] * ab * ac);
}

inline std::vector<Relation> FindRelations(
  const std::vector<InteriorFace>& faces, const Vector4& eye)
{
  std::vector<Relation> relations;
  for (const InteriorFace& f : faces)
  {
    const long double eyeSide = Orient(f.Points, eye);
    const auto apexSide = [&f](int owner) {
      const Vector3& apex = f.Apexes[owner];
      return Orient(f.Points, { { apex[0], apex[1], apex[2], 1 } });
    };
    // Where a non-planar cell folds back, both owners lie on one side of the face: neither is in
    // front.
    const bool folded = (apexSide(0) > 0) == (apexSide(1) > 0);
    if (std::abs(eyeSide) > EdgeOnTolerance(f.Points, eye) && !folded)
    {
      const bool firstInFront = (eyeSide > 0) == (apexSide(0) > 0);
      relations.push_back(
        firstInFront ? Relation{ f.Owners[1], f.Owners[0] } : Relation{ f.Owners[0], f.Owners[1] });
    }
  }
  return relations;
}

inline std::int64_t CountViolations(
  const std::vector<Relation>& relations, const std::vector<std::int32_t>& order)
{
  std::vector<std::size_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[std::size_t(order[i])] = i;
  }
  return std::count_if(relations.begin(), relations.end(),
    [&](const Relation& r) { return rank[std::size_t(r.Behind)] > rank[std::size_t(r.Front)]; });
}

/** Tetrahedra that no order can place, as Kahn's algorithm leaves them. */
inline std::size_t CountUnsortable(const std::vector<Relation>& relations, std::size_t n)
{
  std::vector<int> waiting(n, 0);
  std::vector<std::vector<std::int32_t>> inFront(n);
  for (const Relation& r : relations)
  {
    ++waiting[std::size_t(r.Front)];
    inFront[std::size_t(r.Behind)].push_back(r.Front);
  }
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (waiting[i] == 0)
    {
      free.push_back(i);
    }
  }
  std::size_t placed = 0;
  for (; placed < free.size(); ++placed)
  {
    for (const std::int32_t next : inFront[free[placed]])
    {
      if (--waiting[std::size_t(next)] == 0)
      {
        free.push_back(std::size_t(next));
      }
    }
  }
  return n - placed;
}

} // namespace nephoscope_test

#endif
