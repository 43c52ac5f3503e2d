// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a dataset has no velocity field, or has no velocity at a position.
#ifndef nephoscope_VelocityProblem_h
#define nephoscope_VelocityProblem_h

#include "Vector3.h"
#include "VelocityFields.h"
#include "vtkNephoscopeFiltersVelocityFieldModule.h" // for export macro

#include <limits>
#include <string>
#include <vector>

class vtkBoundingBox;
class vtkDataSet;

namespace nephoscope
{
// A sentence that names what is wrong and its remedy; empty if nothing is.
std::string VelocityProblem(vtkDataSet* data, const VelocityArray& array);

// Why there is no velocity at a position in a cell: a sentence. Empty if it is in no cell.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::string WhyNoVelocityInside(
  const std::vector<vtkDataSet*>& sets, const Vector3& position);

// The same for a position in no cell of data with these bounds. `nearest`: the middle of the
// nearest cell.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT std::string WhyOutside(
  const vtkBoundingBox& box, const Vector3& nearest, const Vector3& position);

// The middle of a visible cell, among the nearest to the position, and its distance, which is
// infinite if there are no cells.
struct NearestCell
{
  double Distance = std::numeric_limits<double>::infinity();
  Vector3 Middle{};
};
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT NearestCell FindNearestCell(
  const std::vector<vtkDataSet*>& sets, const Vector3& position);
}

#endif
