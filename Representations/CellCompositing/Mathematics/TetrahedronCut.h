// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cuts a tetrahedron by a plane into tetrahedra on either side, those of each side in order from back to front.
 *
 * A side is a tetrahedron, a pyramid (two tetrahedra) or a wedge (three, each sharing a face with the next): where a convex body
 * is divided into such a row, the faces between neighbours settle the order.
 */
#ifndef TetrahedronCut_h
#define TetrahedronCut_h

#include "TetrahedronRay.h"

#include <utility>
#include <vector>

namespace nephoscope
{

/** Points x with Normal . x = Offset; the near side is where Normal points to. */
struct Plane
{
  Vector3 Normal;
  double Offset;
  double Distance(const Vector3& x) const { return dot(this->Normal, x) - this->Offset; }
};

/** A corner of a part of a tetrahedron: where it is, and its barycentric coordinates in the whole. */
struct CutCorner
{
  Vector3 Position;
  Vector4 Weights;
};

using CutTetrahedron = std::array<CutCorner, 4>;

class TetrahedronCut
{
public:
  TetrahedronCut(const Plane& plane, const Vector4& eye)
    : CuttingPlane(plane)
    , Eye(eye)
  {
  }

  /** Appends to `far` and `near`. Corners nearer to the plane than `tolerance` count as lying on it. */
  void Apply(const CutTetrahedron& t, double tolerance, std::vector<CutTetrahedron>& far,
    std::vector<CutTetrahedron>& near) const
  {
    std::vector<const CutCorner*> behind, on, before;
    for (const CutCorner& corner : t)
    {
      const double d = this->CuttingPlane.Distance(corner.Position);
      (d > tolerance ? before : d < -tolerance ? behind : on).push_back(&corner);
    }
    if (behind.empty() || before.empty())
    {
      (before.empty() && !behind.empty() ? far : near).push_back(t);
      return;
    }
    this->AddSide(behind, on, before, far);
    this->AddSide(before, on, behind, near);
  }

private:
  using Corners = std::vector<const CutCorner*>;

  // The part of the tetrahedron on the side of the corners `own`.
  void AddSide(const Corners& own, const Corners& on, const Corners& other,
    std::vector<CutTetrahedron>& side) const
  {
    const auto cut = [&](
                       std::size_t i, std::size_t j) { return this->Crossing(*own[i], *other[j]); };
    switch (4 * own.size() + on.size())
    {
      case 4 * 1 + 0:
        side.push_back({ { *own[0], cut(0, 0), cut(0, 1), cut(0, 2) } });
        break;
      case 4 * 1 + 1:
        side.push_back({ { *own[0], *on[0], cut(0, 0), cut(0, 1) } });
        break;
      case 4 * 1 + 2:
        side.push_back({ { *own[0], *on[0], *on[1], cut(0, 0) } });
        break;
      case 4 * 2 + 0:
        this->AddWedge(
          { { *own[0], cut(0, 0), cut(0, 1) } }, { { *own[1], cut(1, 0), cut(1, 1) } }, side);
        break;
      case 4 * 2 + 1:
        this->AddPyramid(*on[0], { { *own[0], *own[1], cut(1, 0), cut(0, 0) } }, side);
        break;
      case 4 * 3 + 0:
        this->AddWedge(
          { { cut(0, 0), cut(1, 0), cut(2, 0) } }, { { *own[0], *own[1], *own[2] } }, side);
        break;
      default:
        break;
    }
  }

  /** Where the plane crosses an edge: the same from either end, whoever owns the edge. */
  CutCorner Crossing(const CutCorner& a, const CutCorner& b) const
  {
    if (b.Position < a.Position)
    {
      return this->Crossing(b, a);
    }
    const double da = this->CuttingPlane.Distance(a.Position),
                 db = this->CuttingPlane.Distance(b.Position);
    const double u = da / (da - db);
    CutCorner c;
    for (std::size_t k = 0; k < 3; ++k)
    {
      c.Position[k] = a.Position[k] + u * (b.Position[k] - a.Position[k]);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      c.Weights[k] = a.Weights[k] + u * (b.Weights[k] - a.Weights[k]);
    }
    return c;
  }

  /** Whether the eye and the corner lie on the same side of a face. */
  bool IsTowardsEye(
    const CutCorner& corner, const CutCorner& a, const CutCorner& b, const CutCorner& c) const
  {
    const Vector3& x = corner.Position;
    const auto side = [&](const Vector4& e) {
      return planeSide(a.Position, b.Position, c.Position, e);
    };
    return (side(this->Eye) > 0) == (side({ { x[0], x[1], x[2], 1.0 } }) > 0);
  }

  // Lateral edges a[i] b[i].
  void AddWedge(const std::array<CutCorner, 3>& a, const std::array<CutCorner, 3>& b,
    std::vector<CutTetrahedron>& side) const
  {
    const CutTetrahedron first = { { a[0], a[1], a[2], b[2] } };
    const CutTetrahedron middle = { { a[0], a[1], b[1], b[2] } };
    const CutTetrahedron last = { { a[0], b[0], b[1], b[2] } };
    const bool firstInFront = this->IsTowardsEye(a[2], a[0], a[1], b[2]);
    const bool lastInFront = this->IsTowardsEye(b[0], a[0], b[1], b[2]);
    if (!firstInFront)
    {
      side.push_back(first);
    }
    if (!lastInFront)
    {
      side.push_back(last);
    }
    side.push_back(middle);
    if (firstInFront)
    {
      side.push_back(first);
    }
    if (lastInFront)
    {
      side.push_back(last);
    }
  }

  void AddPyramid(const CutCorner& apex, const std::array<CutCorner, 4>& base,
    std::vector<CutTetrahedron>& side) const
  {
    CutTetrahedron back = { { apex, base[0], base[1], base[2] } };
    CutTetrahedron front = { { apex, base[0], base[2], base[3] } };
    if (this->IsTowardsEye(base[1], apex, base[0], base[2]))
    {
      std::swap(back, front);
    }
    side.push_back(back);
    side.push_back(front);
  }

  const Plane CuttingPlane;
  const Vector4 Eye;
};

} // namespace nephoscope

#endif
