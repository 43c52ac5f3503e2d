// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMeasures.h"

#include "TetrahedronSource.h"

#include "vtkDataArray.h"
#include "vtkTetra.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
using PointIds = std::array<vtkIdType, 4>;

constexpr vtkIdType enoughCells = 100000; // for integrals
constexpr double noExtent[3] = { 0.0, 0.0, 0.0 };

struct TetrahedronCorners
{
  double X[4][3];

  TetrahedronCorners(vtkDataSet* data, const PointIds& tetrahedron)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      data->GetPoint(tetrahedron[i], this->X[i]);
    }
  }
  double Volume()
  {
    const double volume =
      std::abs(vtkTetra::ComputeVolume(this->X[0], this->X[1], this->X[2], this->X[3]));
    return std::isfinite(volume) ? volume : 0.0;
  }
  bool LieIn(const MediumBounds& box) const
  {
    return std::all_of(this->X, this->X + 4, [&](const double* x) { return HoldsPlace(box, x); });
  }
};

/** Its middle. */
WeightedPlace WeightedPlaceOf(TetrahedronCorners corners)
{
  WeightedPlace place = {};
  double length = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double x[4] = { corners.X[0][axis], corners.X[1][axis], corners.X[2][axis],
      corners.X[3][axis] };
    place.Place[axis] = 0.25 * (x[0] + x[1] + x[2] + x[3]);
    length = std::max(length, *std::max_element(x, x + 4) - *std::min_element(x, x + 4));
  }
  place.Weight = WeightOfCell(corners.Volume(), length);
  return place;
}

/** One tetrahedron, with mean values of its corners. */
MediumMeasures::Part PartOf(
  TetrahedronCorners corners, const CellMedium& medium, vtkIdType cell, const PointIds& tetrahedron)
{
  MediumMeasures::Part part = { NoMediumBounds, corners.Volume(), 0.0, 0.0 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double value =
      medium.Scalars ? ScalarOf(medium.Scalars, medium.OnCells ? cell : tetrahedron[i]) : 0.0;
    part.Scalar += 0.25 * value;
    part.Opacity += medium.Opacity && std::isfinite(value) ? 0.25 * medium.Opacity(value) : 0.0;
    ExtendBounds(part.Box, corners.X[i]);
  }
  return part;
}

/**
 * Calls visit(point) for the points of the cells that are shown; of data without hidden ones for
 * all points, which takes less time.
 */
template <typename Visit>
void ForEachPlace(vtkDataSet* data, const Visit& visit)
{
  double x[3];
  if (!data->GetCellGhostArray() && !data->GetPointGhostArray())
  {
    for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
    {
      data->GetPoint(point, x);
      visit(x);
    }
    return;
  }
  TetrahedronSource source(data);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const vtkIdType corners = source.IsHidden(cell) ? 0 : source.GetPoints()->GetNumberOfIds();
    for (vtkIdType i = 0; i < corners; ++i)
    {
      data->GetPoint(source.GetPoints()->GetId(i), x);
      visit(x);
    }
  }
}
/**
 * Calls visit(cell, tetrahedron) for about `most` of the cells that are shown. Returns for how many
 * each of them stands.
 */
template <typename Visit>
double ForChosenTetrahedra(vtkDataSet* data, vtkIdType most, const Visit& visit)
{
  const SampleChoice choice(data->GetNumberOfCells(), most);
  TetrahedronSource source(data);
  vtkIdType shown = 0, chosen = 0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!source.IsHidden(cell) && choice.Takes(shown++))
    {
      ++chosen;
      source.EmitTetrahedra(cell, [&](const PointIds& t) { visit(cell, t); });
    }
  }
  return chosen > 0 ? static_cast<double>(shown) / static_cast<double>(chosen) : 0.0;
}
} // namespace

MediumBounds BoundsOfCells(vtkDataSet* data, const MediumBounds& box)
{
  MediumBounds bounds = NoMediumBounds;
  if (data && data->GetNumberOfCells() > 0)
  {
    ForEachPlace(data, [&](const double* place) {
      if (HoldsPlace(box, place))
      {
        ExtendBounds(bounds, place);
      }
    });
  }
  return bounds;
}

MediumBounds RobustBoundsOfCells(vtkDataSet* data, const MediumReduction& over)
{
  std::vector<WeightedPlace> places;
  if (data)
  {
    const auto standing = static_cast<double>(
      SampleChoice(data->GetNumberOfCells(), enoughPlaces).Standing()); // differs between processes
    ForChosenTetrahedra(data, enoughPlaces, [&](vtkIdType, const PointIds& tetrahedron) {
      places.push_back(WeightedPlaceOf({ data, tetrahedron }));
      places.back().Weight *= standing;
      places.back().Number = standing;
    });
  }
  return RobustBounds(
    places, [&](const MediumBounds& box) { return BoundsOfCells(data, box); }, over);
}

MediumMeasures MeasureCells(vtkDataSet* data, const CellMedium& medium, const MediumBounds& common)
{
  MediumMeasures measures;
  if (!data || data->GetNumberOfCells() == 0)
  {
    return measures;
  }
  ForEachPlace(data, [&](const double* place) {
    ExtendBounds(measures.Bounds, place);
    if (HoldsPlace(common, place))
    {
      measures.AddPlace(common, place, noExtent);
    }
  });
  const double scale =
    ForChosenTetrahedra(data, enoughCells, [&](vtkIdType cell, const PointIds& tetrahedron) {
      TetrahedronCorners corners(data, tetrahedron);
      if (corners.LieIn(common))
      {
        measures.AddPart(common, PartOf(corners, medium, cell, tetrahedron));
      }
    });
  measures.Scale(scale);
  if (medium.Scalars && scale > 0.0)
  {
    FindFiniteRange(medium.Scalars, measures.ScalarRange);
  }
  return measures;
}

bool HoldsVolume(vtkDataSet* data)
{
  if (!data)
  {
    return false;
  }
  bool found = false;
  TetrahedronSource source(data);
  for (vtkIdType cell = 0; !found && cell < data->GetNumberOfCells(); ++cell)
  {
    if (!source.IsHidden(cell))
    {
      source.EmitTetrahedra(cell, [&](const PointIds& tetrahedron) {
        found = found || TetrahedronCorners(data, tetrahedron).Volume() > 0.0;
      });
    }
  }
  return found;
}

} // namespace nephoscope
