// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a ray crosses a tetrahedron, in barycentric coordinates.
 *
 * Let lambda_i be the barycentric coordinates of a point of the ray on a back face, and
 *   q_i = n_i . (E.xyz - E.w A_i) / n_i . (P_i - A_i)
 * for the homogeneous eye E = (x, y, z, 1), or E = (direction towards the eye, 0) in a parallel
 * projection; n_i is the normal and A_i a point of the face opposite vertex i. Then along the ray,
 * from the back face towards the eye,
 *   lambda_i(u) = lambda_i + u (q_i - E.w lambda_i),
 * where u is the fraction of the way to the eye (perspective) or the length (parallel). q_i > 0
 * marks back faces, and up to scale q_i is the coefficient mu_i of the projection classes
 * (ShirleyTuchman1990): sum mu_i P_i = 0 in eye space.
 * The front of the tetrahedron is where the first lambda_i falls to zero. Barycentric coordinates
 * do not change under affine maps, so the coordinates may be those of the model although lengths
 * are measured in the world.
 *
 * shaders/CellCompositing.geom.glsl and .frag.glsl are the same algorithm.
 */
#ifndef nephoscope_TetrahedronRay_h
#define nephoscope_TetrahedronRay_h

#include "Tetrahedron.h"

#include <array>

namespace nephoscope
{

/** The q_i above. The tetrahedron must have a volume; its orientation does not matter. */
inline Vector4 EyeCoordinates(const std::array<Vector3, 4>& p, const Vector4& eye)
{
  Vector4 q;
  for (int i = 0; i < 4; ++i)
  {
    const auto& f = tetrahedronFaces[i];
    const Vector4 vertex = { p[i][0], p[i][1], p[i][2], 1.0 };
    q[i] = PlaneSide(p[f[0]], p[f[1]], p[f[2]], eye) / PlaneSide(p[f[0]], p[f[1]], p[f[2]], vertex);
  }
  return q;
}

} // namespace nephoscope

#endif
