// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GridSeams.h"

#include "DualCells.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

namespace nephoscope
{
namespace
{
// A fraction of the grid's diagonal: coordinates in single precision.
constexpr double samePlace = 1e-6;

Vector3 PositionOf(vtkDataSet* grid, const GridTopology& topology, const GridIndex& at)
{
  Vector3 x;
  grid->GetPoint(static_cast<vtkIdType>(topology.Id(at)), x.data());
  return x;
}

double DistanceOfPoints(
  vtkDataSet* grid, const GridTopology& topology, const GridIndex& a, const GridIndex& b)
{
  return Distance(PositionOf(grid, topology, a), PositionOf(grid, topology, b));
}

// Calls function(at) for the points with index `value` of the axis, until it returns false. True if
// it never did.
template <typename Function>
bool OnFace(const GridTopology& topology, int axis, int value, Function&& function)
{
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  GridIndex at;
  at[axis] = value;
  for (at[c] = 0; at[c] < topology.Size[c]; ++at[c])
  {
    for (at[b] = 0; at[b] < topology.Size[b]; ++at[b])
    {
      if (!function(at))
      {
        return false;
      }
    }
  }
  return true;
}

double Diagonal(vtkDataSet* grid)
{
  const double length = grid->GetLength();
  return std::isfinite(length) ? length : 0.0;
}

bool SameValue(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}
}

Circle JudgeCircle(const std::vector<double>& degrees)
{
  double widest = 0.0;
  double turned = 0.0;
  for (std::size_t i = 1; i < degrees.size(); ++i)
  {
    const double step = std::remainder(degrees[i] - degrees[i - 1], 360.0);
    widest = std::max(widest, std::abs(step));
    turned += step;
  }
  const double gap = 360.0 - std::abs(turned);
  if (degrees.size() < 3 || !std::isfinite(gap))
  {
    return Circle::Part;
  }
  if (std::abs(gap) <= 0.01 * widest) // rounded longitudes
  {
    return degrees.size() > 3 ? Circle::Repeated : Circle::Part;
  }
  return gap > 0.0 && gap <= 1.5 * widest ? Circle::Open : Circle::Part;
}

void FindRepeatedPlaces(vtkDataSet* grid, GridTopology& topology)
{
  const double tolerance = samePlace * Diagonal(grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = topology.Size[axis] - 1;
    if (last < 3)
    {
      continue;
    }
    double longest = 0.0; // a row that is one point (at a pole) tells nothing
    const bool same = OnFace(topology, axis, 0, [&](GridIndex at) {
      GridIndex end = at;
      end[axis] = last;
      GridIndex next = at;
      next[axis] = 1;
      longest = std::max(longest, DistanceOfPoints(grid, topology, at, next));
      return DistanceOfPoints(grid, topology, at, end) <= tolerance;
    });
    if (same && longest > 10.0 * tolerance)
    {
      topology.Ring[axis] = topology.Repeated[axis] = true;
    }
  }
}

bool RepeatsValues(vtkDataSet* grid, const GridTopology& topology, int axis)
{
  if (topology.Size[axis] < 4)
  {
    return false;
  }
  bool varies = false;
  for (int a = 0; a < grid->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = grid->GetPointData()->GetArray(a);
    if (!array || array->GetNumberOfTuples() != grid->GetNumberOfPoints())
    {
      continue;
    }
    const double reference = array->GetComponent(0, 0);
    const bool same = OnFace(topology, axis, 0, [&](GridIndex at) {
      const auto first = static_cast<vtkIdType>(topology.Id(at));
      at[axis] = topology.Size[axis] - 1;
      const auto last = static_cast<vtkIdType>(topology.Id(at));
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double value = array->GetComponent(first, c);
        varies = varies || (c == 0 && !SameValue(value, reference));
        if (!SameValue(value, array->GetComponent(last, c)))
        {
          return false;
        }
      }
      return true;
    });
    if (!same)
    {
      return false;
    }
  }
  return varies;
}

void FindPoles(vtkDataSet* grid, GridTopology& topology)
{
  const double tolerance = samePlace * Diagonal(grid);
  for (int along = 0; along < 3; ++along)
  {
    if (topology.Size[along] < 3)
    {
      continue;
    }
    for (int across = 0; across < 3; ++across)
    {
      for (bool atEnd : { false, true })
      {
        const int last = topology.Size[across] - 1;
        const bool onePlace = across != along && last > 0 &&
          OnFace(topology, across, atEnd ? last : 0, [&](GridIndex at) {
            GridIndex first = at;
            first[along] = 0;
            return DistanceOfPoints(grid, topology, first, at) <= tolerance;
          });
        if (onePlace)
        {
          topology.Poles.push_back({ along, across, atEnd });
        }
      }
    }
  }
}

bool ClosesInSpace(vtkDataSet* grid, const GridTopology& topology, int axis)
{
  const int last = topology.Size[axis] - 1;
  if (topology.Repeated[axis] || last < 2)
  {
    return false;
  }
  return OnFace(topology, axis, 0, [&](GridIndex at) {
    double longest = 0.0;
    GridIndex previous = at;
    GridIndex next = at;
    for (next[axis] = 1; next[axis] <= last; ++next[axis], ++previous[axis])
    {
      longest = std::max(longest, DistanceOfPoints(grid, topology, previous, next));
    }
    return DistanceOfPoints(grid, topology, at, previous) <= 2.0 * longest;
  });
}
}
