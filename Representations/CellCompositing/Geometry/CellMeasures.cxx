// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMeasures.h"

#include "TetrahedronSource.h"

#include "vtkDataArray.h"
#include "vtkTetra.h"

#include <cmath>

namespace nephoscope
{
namespace
{
using PointIds = std::array<vtkIdType, 4>;

constexpr double noExtent[3] = { 0.0, 0.0, 0.0 };

double volumeOf(vtkDataSet* data, const PointIds& tetrahedron)
{
  double x[4][3];
  for (std::size_t i = 0; i < 4; ++i)
  {
    data->GetPoint(tetrahedron[i], x[i]);
  }
  const double volume = std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]));
  return std::isfinite(volume) ? volume : 0.0;
}

/** Adds one tetrahedron, with mean values of its corners; 0 where a value is not finite, as such cells are not drawn. */
void addTetrahedron(
  MediumMeasures& measures, vtkDataSet* data, const CellMedium& medium, vtkIdType cell, const PointIds& tetrahedron)
{
  const double volume = volumeOf(data, tetrahedron);
  measures.Volume += volume;
  double scalar = 0.0, opacity = 0.0;
  for (const vtkIdType point : tetrahedron)
  {
    const double value = medium.Scalars ? scalarOf(medium.Scalars, medium.OnCells ? cell : point) : 0.0;
    scalar += 0.25 * value;
    opacity += medium.Opacity && std::isfinite(value) ? 0.25 * medium.Opacity(value) : 0.0;
  }
  if (std::isfinite(scalar))
  {
    measures.ScalarIntegral += volume * scalar;
    measures.OpacityIntegral += volume * opacity;
  }
}

/** Calls visit(point) for the points of the cells that are shown; of data without hidden ones for all points, which takes less time. */
template <typename Visit>
void forEachPlace(vtkDataSet* data, const Visit& visit)
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
} // namespace

MediumBounds boundsOfCells(vtkDataSet* data)
{
  MediumBounds bounds = NoMediumBounds;
  if (data && data->GetNumberOfCells() > 0)
  {
    forEachPlace(data, [&](const double* place) { addPlace(bounds, place); });
  }
  return bounds;
}

MediumMeasures measureCells(vtkDataSet* data, const CellMedium& medium, const MediumBounds& common)
{
  MediumMeasures measures;
  if (!data || data->GetNumberOfCells() == 0)
  {
    return measures;
  }
  forEachPlace(data, [&](const double* place) {
    addPlace(measures.Bounds, place);
    if (std::isfinite(place[0] + place[1] + place[2]))
    {
      measures.AddPlace(common, place, noExtent);
    }
  });
  const SampleChoice choice(data->GetNumberOfCells());
  TetrahedronSource source(data);
  vtkIdType shown = 0, sampled = 0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!source.IsHidden(cell) && choice.Takes(shown++))
    {
      ++sampled;
      source.EmitTetrahedra(
        cell, [&](const PointIds& t) { addTetrahedron(measures, data, medium, cell, t); });
    }
  }
  const double scale = sampled > 0 ? static_cast<double>(shown) / static_cast<double>(sampled) : 0.0;
  measures.Volume *= scale;
  measures.ScalarIntegral *= scale;
  measures.OpacityIntegral *= scale;
  if (medium.Scalars && shown > 0)
  {
    medium.Scalars->GetFiniteRange(measures.ScalarRange, medium.Scalars->GetNumberOfComponents() > 1 ? -1 : 0);
  }
  return measures;
}

} // namespace nephoscope
