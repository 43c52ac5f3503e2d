// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random tetrahedra, and rays through them by clipping with the planes of the faces: the reference
 * for projections.
 */
#ifndef nephoscope_ClippedTetrahedron_h
#define nephoscope_ClippedTetrahedron_h

#include "TestRandom.h"
#include "TetrahedronRay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope_test
{

using nephoscope::Cross;
using nephoscope::Difference;
using nephoscope::Dot;
using nephoscope::Vector3;
using nephoscope::Vector4;

using TetrahedronPoints = std::array<Vector3, 4>;

inline Vector3 Along(const Vector3& a, double s, const Vector3& d)
{
  return { { a[0] + s * d[0], a[1] + s * d[1], a[2] + s * d[2] } };
}
inline double Length(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}
inline double Volume(const TetrahedronPoints& p)
{
  return Dot(Cross(Difference(p[1], p[0]), Difference(p[2], p[0])), Difference(p[3], p[0])) / 6;
}

// The reference works in the world with unit rays, Cramer's rule and no homogeneous eye.
inline Vector4 Barycentric(const TetrahedronPoints& p, const Vector3& x)
{
  Vector4 result;
  for (int i = 0; i < 4; ++i)
  {
    TetrahedronPoints replaced = p;
    replaced[i] = x;
    result[i] = Volume(replaced) / Volume(p);
  }
  return result;
}

struct ClippedRay
{
  double Near, Far; ///< distances from the origin
  int FarFace;      ///< opposite this vertex
};

/** The part of origin + t direction inside, by clipping with the four face planes. */
inline ClippedRay Clip(const TetrahedronPoints& p, const Vector3& origin, const Vector3& direction)
{
  ClippedRay ray = { -1e300, 1e300, -1 };
  for (int i = 0; i < 4; ++i)
  {
    const Vector3& a = p[(i + 1) % 4];
    Vector3 normal = Cross(Difference(p[(i + 2) % 4], a), Difference(p[(i + 3) % 4], a));
    if (Dot(normal, Difference(p[i], a)) > 0)
    {
      normal = { { -normal[0], -normal[1], -normal[2] } };
    }
    const double speed = Dot(normal, direction); // outwards
    const double t = Dot(normal, Difference(a, origin)) / speed;
    if (speed < 0)
    {
      ray.Near = std::max(ray.Near, t);
    }
    else if (t < ray.Far)
    {
      ray.Far = t;
      ray.FarFace = i;
    }
  }
  return ray;
}

inline double Interpolate(const Vector4& weights, const Vector4& values)
{
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2] +
    weights[3] * values[3];
}

inline TetrahedronPoints RandomTetrahedron(Random& random)
{
  TetrahedronPoints p;
  do
  {
    for (Vector3& x : p)
    {
      x = random.NormalVector();
    }
  } while (std::fabs(Volume(p)) < 1e-2); // slivers lose digits in the reference itself
  return p;
}

inline Vector3 RandomInside(Random& random, const TetrahedronPoints& p)
{
  Vector4 w;
  double sum = 0;
  for (double& x : w)
  {
    x = -std::log(random.Uniform(1e-12, 1));
    sum += x;
  }
  Vector3 x = { { 0, 0, 0 } };
  for (int i = 0; i < 4; ++i)
  {
    x = Along(x, w[i] / sum, p[i]);
  }
  return x;
}

} // namespace nephoscope_test

#endif
