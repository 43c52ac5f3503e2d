// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Gradients of a field on a structured grid, and from them the normals of its surfaces.
#ifndef nephoscope_SurfaceNormals_h
#define nephoscope_SurfaceNormals_h

#include "SmoothingPlan.h"

#include <vector>

namespace nephoscope
{
class FieldGradient
{
public:
  // Points that are `missing` are not looked at.
  FieldGradient(const SmoothingPlan& plan, const std::vector<double>& field,
    const std::vector<unsigned char>& missing)
    : Plan(plan)
    , Field(field)
    , Missing(missing)
  {
  }

  // In the space of the grid's coordinates. Derivatives of position and field by the length of path
  // along each axis, with three points each (second order on uneven steps), so a linear field has
  // its gradient exactly. At a pole, where the axes are none, the plane of least squares through
  // the next row.
  Vector3 At(const GridIndex& at) const;

  // Unit vector opposite to the gradient, pointing out of the region above the value, at the
  // fraction `share` of the segment from a to b, the next point along one axis or the same. Not
  // against the slope from a to b where the field is rough. Where the gradient vanishes at a, the
  // direction of the steepest step down.
  Vector3 Outward(const GridIndex& a, const GridIndex& b, double share) const;

private:
  struct Slope // along one axis; HasValue is false where there is no neighbour
  {
    bool HasValue = false;
    double Rise = 0.0; // of the field for a length of 1
    Vector3 Tangent = { { 0.0, 0.0, 0.0 } };
  };
  struct Neighbor
  {
    bool IsThere = false;
    GridIndex At = { { 0, 0, 0 } };
    Vector3 Away = { { 0.0, 0.0, 0.0 } };
    double Distance = 0.0;
    double Rise = 0.0; // of the field, over the whole distance
  };

  Neighbor Look(int axis, const GridIndex& from, int step) const;
  Slope SlopeAlong(int axis, const GridIndex& at) const;
  Vector3 AtPole(const GridIndex& at, const PoleRow& pole) const;
  Vector3 TurnedToEdge(const Vector3& gradient, const GridIndex& a, const GridIndex& b) const;
  Vector3 SteepestStep(const GridIndex& at) const;

  const SmoothingPlan& Plan;
  const std::vector<double>& Field;
  const std::vector<unsigned char>& Missing;
};
}

#endif
