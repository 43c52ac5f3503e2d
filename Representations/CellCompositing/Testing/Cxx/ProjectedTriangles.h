// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The projection of a tetrahedron to a fan of triangles around its thick vertex
 * (ShirleyTuchman1990), and the table of 1 - exp(-u) that the opacity may be looked up in
 * (SteinBeckerMax1994).
 *
 * With the coordinates q of the eye (TetrahedronRay.h), sum q_i P_i = 0 in eye space. The vertices
 * with q > 0 and those with q < 0 span two simplices that cross on one ray: there the tetrahedron
 * is thickest. Where the ray enters, and where it leaves,
 *   X+ = sum_{q > 0} q_i P_i / M+   and   X- = sum_{q < 0} |q_i| P_i / M-,
 *   M+- = sum of the |q_i|;
 * X+ is in front because q is so normalised that X+ = X- + (eye - eye.w X-) / M+ in either
 * projection. One formula for all of Shirley and Tuchman's classes, without a tolerance: X+ and X-
 * are continuous where a tetrahedron changes class.
 *
 * Inside each triangle of the fan the ray meets one front and one back face. What is linear on the
 * screen there:
 *   perspective: 1 / z at the front and at the back face, and attributes times these;
 *   parallel: z and attributes.
 *
 * shaders/ProjectedTriangles.glsl is the same algorithm; TestProjectedTrianglesShader compares the
 * two.
 */
#ifndef nephoscope_ProjectedTriangles_h
#define nephoscope_ProjectedTriangles_h

#include "OpacityTable.h"
#include "TetrahedronRay.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephoscope
{

struct TetrahedronProjection
{
  Vector4 Front = { 0, 0, 0, 0 }; ///< barycentric coordinates of X+
  Vector4 Back = { 0, 0, 0, 0 };  ///< barycentric coordinates of X-
  double Parameter =
    0; ///< 1 / M+: (X+ - X-) in units of the way to the eye, as TetrahedronRay counts
  unsigned Positive = 0; ///< bit i: q_i > 0
  unsigned Negative = 0; ///< bit i: q_i < 0
};

inline TetrahedronProjection ProjectTetrahedron(const Vector4& q)
{
  TetrahedronProjection p;
  double positive = 0, negative = 0;
  for (unsigned i = 0; i < 4; ++i)
  {
    p.Front[i] = std::max(q[i], 0.0);
    p.Back[i] = std::max(-q[i], 0.0);
    positive += p.Front[i];
    negative += p.Back[i];
    p.Positive |= (q[i] > 0 ? 1u : 0u) << i;
    p.Negative |= (q[i] < 0 ? 1u : 0u) << i;
  }
  if (p.Positive != 0 &&
    p.Negative != 0) // else the eye is inside, or the tetrahedron is seen edge-on
  {
    for (int i = 0; i < 4; ++i)
    {
      p.Front[i] /= positive;
      p.Back[i] /= negative;
    }
    p.Parameter = 1 / positive;
  }
  return p;
}

/** The six edges of a tetrahedron. */
constexpr int tetrahedronEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 },
  { 2, 3 } };

/**
 * Whether the edge (a, b) and the thick vertex make a triangle of the fan. They do not where the
 * edge's line passes through the thick vertex, which it does when the edge holds all positive, or
 * all negative vertices.
 */
inline bool IsFanEdge(const TetrahedronProjection& p, int a, int b)
{
  const unsigned edge = (1u << a) | (1u << b);
  return (p.Positive & ~edge) != 0 && (p.Negative & ~edge) != 0;
}

/**
 * ShirleyTuchman1990's classes: 1 (3 triangles), 2 (4 triangles), 3 (2), 4 (1); 0: nothing to draw.
 */
inline int ProjectionClass(const TetrahedronProjection& p)
{
  constexpr int classOfTriangles[5] = { 0, 4, 3, 1, 2 };
  int triangles = 0;
  for (const auto& edge : tetrahedronEdges)
  {
    triangles += IsFanEdge(p, edge[0], edge[1]);
  }
  return classOfTriangles[triangles];
}

/**
 * The table read with linear interpolation, as a texture unit does; the last entry beyond its end.
 */
template <typename Real>
Real LookUpOpacity(const std::vector<float>& table, Real end, Real u)
{
  const Real last = static_cast<Real>(table.size() - 1);
  const Real place = std::min(std::max(u / end, Real(0)), Real(1)) * last;
  const std::size_t i = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const Real fraction = place - static_cast<Real>(i);
  return static_cast<Real>(table[i]) * (1 - fraction) + static_cast<Real>(table[i + 1]) * fraction;
}

} // namespace nephoscope

#endif
