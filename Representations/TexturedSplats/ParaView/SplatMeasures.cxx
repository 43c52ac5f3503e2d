// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatMeasures.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <cmath>

namespace nephoscope
{

CellMeasures measureSplats(vtkDataSet* data, vtkDataArray* scalars, const SplatSampling& sampling)
{
  CellMeasures measures;
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return measures;
  }
  const SplatShapes shapes(data, sampling);
  const vtkIdType stride = 1 + shapes.GetNumberOfIds() / 100000;
  vtkIdType shown = 0, sampled = 0;
  vtkBoundingBox box;
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    const SplatVector place = shapes.Place(id);
    if (!shapes.IsVisible(id) || !std::isfinite(place[0] + place[1] + place[2]))
    {
      continue;
    }
    box.AddPoint(place[0], place[1], place[2]);
    if (shown++ % stride == 0)
    {
      ++sampled;
      const SplatMatrix jacobian = shapes.Jacobian(id);
      const double volume = std::abs(Dot(jacobian[0], Cross(jacobian[1], jacobian[2])));
      const double scalar = scalars ? scalarOf(scalars, id) : 0.0;
      measures.Volume += volume;
      measures.ScalarIntegral += std::isfinite(scalar) ? volume * scalar : 0.0;
    }
  }
  const double scale = sampled > 0 ? static_cast<double>(shown) / static_cast<double>(sampled) : 0.0;
  measures.Volume *= scale;
  measures.ScalarIntegral *= scale;
  if (box.IsValid())
  {
    // The samples stand for half a cell more on each side: without it a single sheet would have no thickness.
    box.Inflate(0.5 * std::cbrt(measures.Volume / static_cast<double>(shown)));
    box.GetBounds(measures.Bounds);
  }
  if (scalars && shown > 0)
  {
    scalars->GetFiniteRange(measures.ScalarRange, scalars->GetNumberOfComponents() > 1 ? -1 : 0);
  }
  return measures;
}

} // namespace nephoscope
