// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMeasures.h"

#include "TetrahedronSource.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkTetra.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace nephoscope
{
namespace
{
double volumeOf(vtkDataSet* data, const std::array<vtkIdType, 4>& tetrahedron)
{
  double x[4][3];
  for (std::size_t i = 0; i < 4; ++i)
  {
    data->GetPoint(tetrahedron[i], x[i]);
  }
  const double volume = std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]));
  return std::isfinite(volume) ? volume : 0.0;
}

/** Over one tetrahedron; 0 where a value is not finite, as such cells are not drawn. */
double meanScalar(
  vtkDataArray* scalars, bool onCells, vtkIdType cell, const std::array<vtkIdType, 4>& tetrahedron)
{
  if (!scalars)
  {
    return 0.0;
  }
  double mean = 0.0;
  for (vtkIdType point : tetrahedron)
  {
    mean += 0.25 * scalarOf(scalars, onCells ? cell : point);
  }
  return std::isfinite(mean) ? mean : 0.0;
}
} // namespace

double scalarOf(vtkDataArray* scalars, vtkIdType tuple)
{
  double sum = 0.0;
  const int components = scalars->GetNumberOfComponents();
  if (components == 1)
  {
    return scalars->GetComponent(tuple, 0);
  }
  for (int c = 0; c < components; ++c)
  {
    sum += scalars->GetComponent(tuple, c) * scalars->GetComponent(tuple, c);
  }
  return std::sqrt(sum);
}

CellMeasures measureCells(vtkDataSet* data, vtkDataArray* scalars, bool onCells)
{
  CellMeasures measures;
  const vtkIdType numberOfCells = data ? data->GetNumberOfCells() : 0;
  const vtkIdType stride = 1 + numberOfCells / 100000;
  vtkIdType shown = 0, sampled = 0;
  vtkBoundingBox box;
  double bounds[6];
  std::unique_ptr<TetrahedronSource> source(numberOfCells > 0 ? new TetrahedronSource(data) : nullptr);
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    if (source->IsHidden(cell))
    {
      continue;
    }
    data->GetCellBounds(cell, bounds);
    box.AddBounds(bounds);
    if (shown++ % stride == 0)
    {
      ++sampled;
      source->EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& t) {
        const double volume = volumeOf(data, t);
        measures.Volume += volume;
        measures.ScalarIntegral += volume * meanScalar(scalars, onCells, cell, t);
      });
    }
  }
  const double scale = sampled > 0 ? static_cast<double>(shown) / static_cast<double>(sampled) : 0.0;
  measures.Volume *= scale;
  measures.ScalarIntegral *= scale;
  if (box.IsValid())
  {
    box.GetBounds(measures.Bounds);
  }
  if (scalars && shown > 0)
  {
    scalars->GetFiniteRange(measures.ScalarRange, scalars->GetNumberOfComponents() > 1 ? -1 : 0);
  }
  return measures;
}

CellMeasures reduceOverRanks(const CellMeasures& mine)
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return mine;
  }
  CellMeasures all;
  const double sums[2] = { mine.Volume, mine.ScalarIntegral };
  double allSums[2];
  controller->AllReduce(sums, allSums, 2, vtkCommunicator::SUM_OP);
  all.Volume = allSums[0];
  all.ScalarIntegral = allSums[1];

  // Four intervals: three axes and the scalar. An empty one must not count.
  double low[4], high[4], lowest[4], highest[4];
  for (int i = 0; i < 4; ++i)
  {
    const double* interval = i < 3 ? mine.Bounds + 2 * i : mine.ScalarRange;
    const bool empty = interval[0] > interval[1];
    low[i] = empty ? VTK_DOUBLE_MAX : interval[0];
    high[i] = empty ? -VTK_DOUBLE_MAX : interval[1];
  }
  controller->AllReduce(low, lowest, 4, vtkCommunicator::MIN_OP);
  controller->AllReduce(high, highest, 4, vtkCommunicator::MAX_OP);
  for (int i = 0; i < 4; ++i)
  {
    double* interval = i < 3 ? all.Bounds + 2 * i : all.ScalarRange;
    interval[0] = lowest[i];
    interval[1] = highest[i];
  }
  return all;
}

double meanChord(const CellMeasures& measures)
{
  const double* b = measures.Bounds;
  const double size[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  const double surface = 2.0 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  return measures.Volume > 0.0 && surface > 0.0 ? measures.Volume / (0.25 * surface) : 0.0;
}

double meanRamp(const CellMeasures& measures)
{
  const double low = measures.ScalarRange[0];
  const double high = measures.ScalarRange[1];
  if (!(high > low) || measures.Volume <= 0.0)
  {
    return 0.5;
  }
  return std::min(std::max((measures.ScalarIntegral / measures.Volume - low) / (high - low), 0.0), 1.0);
}

} // namespace nephoscope
