// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatVectorBounds.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
// Calls work(id, vector) for all samples that have one.
template <typename Work>
void ForVectors(const SplatShapes& shapes, vtkDataArray* vectors, Work work)
{
  if (!vectors || vectors->GetNumberOfComponents() != 3 ||
    vectors->GetNumberOfTuples() != shapes.GetNumberOfIds())
  {
    return;
  }
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    Vector3 v;
    vectors->GetTuple(id, v.data());
    const double speed = Norm(v);
    if (speed > 0 && std::isfinite(speed) && shapes.IsVisible(id))
    {
      work(id, v);
    }
  }
}

// As SplatVectors has it.
float RoundedSpeedOf(const Vector3& v)
{
  return SpeedOf({ { float(v[0]), float(v[1]), float(v[2]) } });
}

// From the centre of a sample along an axis.
double ReachOf(const SplatMatrix& jacobian, const Vector3& v, const VectorLook& look,
  double kernelRadius, std::size_t axis)
{
  if (look.Segments)
  {
    const double cell =
      std::abs(jacobian[0][axis]) + std::abs(jacobian[1][axis]) + std::abs(jacobian[2][axis]);
    return 0.5 * cell + segmentReach * look.SegmentLength * look.Unit * std::abs(v[axis]) / Norm(v);
  }
  const SplatMatrix j = LengthenedCell(jacobian, v, look);
  return kernelRadius * Norm({ { j[0][axis], j[1][axis], j[2][axis] } });
}
}

SpeedCounts CountSpeeds(vtkDataSet* data, const SplatSampling& sampling, vtkDataArray* vectors)
{
  SpeedCounts speeds;
  if (data && data->GetNumberOfPoints() > 0)
  {
    SplatSampling simple; // shapes take time, and are not used
    simple.OnCells = sampling.OnCells;
    simple.CellSize = 1.0;
    simple.Frame = sampling.Frame;
    simple.SizeArrayName = sampling.SizeArrayName;
    simple.ShapeArrayName = sampling.ShapeArrayName;
    ForVectors(SplatShapes(data, simple), vectors,
      [&](vtkIdType, const Vector3& v) { speeds.Add(RoundedSpeedOf(v)); });
  }
  return speeds;
}

VectorSums SumVectors(const SplatShapes& shapes, vtkDataArray* vectors)
{
  VectorSums sums;
  ForVectors(shapes, vectors, [&](vtkIdType id, const Vector3& v) {
    sums.Speeds.Add(RoundedSpeedOf(v));
    sums.Cells += ReachAlong(shapes.Jacobian(id), v);
    ++sums.Count;
  });
  return sums;
}

void AddVectorBounds(const SplatShapes& shapes, vtkDataArray* vectors, const VectorLook& look,
  double kernelRadius, double bounds[6])
{
  ForVectors(shapes, vectors, [&](vtkIdType id, const Vector3& v) {
    const Vector3 place = shapes.Place(id);
    const SplatMatrix jacobian = shapes.Jacobian(id);
    for (std::size_t axis = 0; axis < 3 && std::isfinite(place[0] + place[1] + place[2]); ++axis)
    {
      const double reach = ReachOf(jacobian, v, look, kernelRadius, axis);
      bounds[2 * axis] = std::min(bounds[2 * axis], place[axis] - reach);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], place[axis] + reach);
    }
  });
}

} // namespace nephoscope
