// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceGradients.h"

#include "CellGeometry.h"
#include "CoincidentPoints.h"
#include "ScalarSelection.h"

#include "vtkDataSet.h"
#include "vtkFloatArray.h"

namespace nephoscope
{
namespace
{
CellGeometry PointsAround(const double center[3], vtkDataSet* piece)
{
  CellGeometry geometry;
  geometry.Points.reserve(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    double x[3];
    piece->GetPoint(i, x);
    geometry.Points.push_back({ static_cast<float>(x[0] - center[0]),
      static_cast<float>(x[1] - center[1]), static_cast<float>(x[2] - center[2]), 0.0f });
  }
  return geometry;
}
}

PieceGradients::PieceGradients(
  vtkDataSet* piece, vtkDataArray* scalars, const double range[2], const double center[3])
{
  const CellGeometry geometry = PointsAround(center, piece);
  this->Places = FindPlaces(geometry);
  const std::vector<float> values = scalars && range[0] < range[1]
    ? NormalizedScalars({ scalars }, range)
    : std::vector<float>(geometry.Points.size(), 0.0f);
  this->Sums = SumGradients(piece, geometry, values, this->Places);
}

vtkSmartPointer<vtkFloatArray> PieceGradients::Solve() const
{
  auto gradients = vtkSmartPointer<vtkFloatArray>::New();
  gradients->SetName(storedGradientsName);
  gradients->SetNumberOfComponents(3);
  gradients->SetNumberOfTuples(static_cast<vtkIdType>(this->Places.size()));
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    const Vector3 g = this->Sums[static_cast<std::size_t>(this->Places[i])].Solve();
    gradients->SetTuple(static_cast<vtkIdType>(i), g.data());
  }
  return gradients;
}

} // namespace nephoscope
