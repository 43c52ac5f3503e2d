// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A ray that traverses a mesh of tetrahedra from face to face.
 *
 * Every vertex is seen along the ray: (u, v) across it, z along it. The ray pierces the triangle
 * (a, b, c) where the three edge functions e(a,b) = a.u b.v - a.v b.u, e(b,c), e(c,a) are not
 * negative; their ratios are the barycentric coordinates of the point, e(b,c) that of a. Behind the
 * triangle waits one new vertex d, which divides it into (a,b,d), (b,c,d), (c,a,d): the signs of
 * e(a,d), e(b,d), e(c,d) tell through which of them the ray leaves. The edge functions of an edge
 * are computed once and handed on, so that no two tetrahedra disagree about the side on which a ray
 * passes an edge: rays do not slip through cracks, and flat tetrahedra do no harm. One vertex is
 * fetched per tetrahedron.
 *
 * After Garrity1990 (from cell to cell), with the tests in two dimensions of MariaHornaAveneau2017.
 * shaders/TetrahedronWalk.glsl is the same algorithm.
 */
#ifndef nephoscope_TetrahedronWalk_h
#define nephoscope_TetrahedronWalk_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{

/** A vertex as a ray sees it: across (u, v) and along (z) the ray, with its scalar s. */
template <typename Real>
struct WalkVertex
{
  Real U, V, Z, S;
};

template <typename Real>
Real EdgeFunction(const WalkVertex<Real>& p, const WalkVertex<Real>& q)
{
  return p.U * q.V - p.V * q.U;
}

/** The face that the ray is passing, and the three edge functions of its edges. */
template <typename Real>
struct TetrahedronWalk
{
  WalkVertex<Real> A, B, C;
  Real AB, BC, CA;
  /**
   * The ray missed the first face, or ran within a face or along an edge, to within rounding, so
   * that its sides cannot be distinguished.
   */
  bool IsLost = false;

  /**
   * Starts at a face; its vertices are exchanged where it is seen from the wrong side. Returns true
   * if so (B and C).
   */
  bool Start(const WalkVertex<Real>& a, const WalkVertex<Real>& b, const WalkVertex<Real>& c)
  {
    const bool turned = EdgeFunction(a, b) + EdgeFunction(b, c) + EdgeFunction(c, a) < 0;
    this->A = a;
    this->B = turned ? c : b;
    this->C = turned ? b : c;
    this->AB = EdgeFunction(this->A, this->B);
    this->BC = EdgeFunction(this->B, this->C);
    this->CA = EdgeFunction(this->C, this->A);
    this->IsLost = std::min({ this->AB, this->BC, this->CA }) <
      0; // a rasterizer may give the face a pixel whose ray passes it by
    this->AB = std::max(this->AB, Real(0));
    this->BC = std::max(this->BC, Real(0));
    this->CA = std::max(this->CA, Real(0));
    return turned;
  }

  /**
   * Goes on to the face through which the ray leaves the tetrahedron with the vertex d; returns
   * which vertex stays behind.
   */
  int Step(const WalkVertex<Real>& d)
  {
    const Real ad = EdgeFunction(this->A, d);
    const Real bd = EdgeFunction(this->B, d);
    const Real cd = EdgeFunction(this->C, d);
    const Real scale = Real(1e-5) * std::max({ std::abs(ad), std::abs(bd), std::abs(cd) });
    // How far inside each of the three faces the ray passes. In exact arithmetic one of them is >=
    // 0; where rounding leaves none, on an edge, the least wrong is right.
    const Real insideABD = std::min(bd, -ad);
    const Real insideADC = std::min(ad, -cd);
    const Real insideDBC = std::min(cd, -bd);
    this->IsLost = this->IsLost || this->AB + this->BC + this->CA <= scale ||
      std::max({ insideABD, insideADC, insideDBC }) < -scale;
    if (insideABD >= insideADC && insideABD >= insideDBC)
    {
      this->C = d;
      this->BC = std::max(bd, Real(0));
      this->CA = std::max(-ad, Real(0));
      return 2;
    }
    if (insideADC >= insideDBC)
    {
      this->B = d;
      this->AB = std::max(ad, Real(0));
      this->BC = std::max(-cd, Real(0));
      return 1;
    }
    this->A = d;
    this->AB = std::max(-bd, Real(0));
    this->CA = std::max(cd, Real(0));
    return 0;
  }

  /**
   * Where the ray passes the face: z and scalar. False when the face is seen edge-on: there is no
   * such point.
   */
  bool Pass(Real& z, Real& s) const
  {
    const Real sum = this->AB + this->BC + this->CA;
    if (!(sum > 0))
    {
      return false;
    }
    z = (this->BC * this->A.Z + this->CA * this->B.Z + this->AB * this->C.Z) / sum;
    s = (this->BC * this->A.S + this->CA * this->B.S + this->AB * this->C.S) / sum;
    return true;
  }
};

} // namespace nephoscope

#endif
