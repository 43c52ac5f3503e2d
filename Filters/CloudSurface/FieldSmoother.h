// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Smooths one field, in double precision, row by row in parallel.
//
//   PASS 1 along axis 0, as often as the plan asks for near a pole
//   PASS 2 along axis 1      PASS 3 along axis 2      after each: a row at a pole takes its mean
//
// The new value of a point depends on old values only, so the result does not depend on the number
// of threads.
#ifndef nephoscope_FieldSmoother_h
#define nephoscope_FieldSmoother_h

#include "SmoothingPlan.h"

#include <functional>
#include <vector>

namespace nephoscope
{
// Not a finite number, or a fill value that a reader has left in place (netCDF's own is 9.97e36).
bool IsMissingValue(double value);

class FieldSmoother
{
public:
  explicit FieldSmoother(const SmoothingPlan& plan)
    : Plan(plan)
  {
  }

  // 1 where the point is hidden or the field has no value.
  std::vector<unsigned char> MissingPoints(const std::vector<double>& field) const;

  // Makes the field single-valued at coincident points (poles, repeated columns), also without
  // iterations, and smooths it.
  // Points that are missing keep their values. Returns false if `keepGoing(share done)` said no.
  bool Smooth(
    std::vector<double>& field, int iterations, const std::function<bool(double)>& keepGoing) const;

private:
  using Field = std::vector<double>;

  void PassAlongRows(const Field& masses, const Field& in, Field& out) const;
  void PassAcrossRows(int axis, const Field& masses, const Field& in, Field& out) const;
  void AverageAtPoles(const Field& masses, Field& field) const;
  void CopyToRepeated(Field& field) const;

  const SmoothingPlan& Plan;
};
}

#endif
