// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceGradients.h"

#include "CellGeometry.h"
#include "CoincidentPoints.h"
#include "ScalarSelection.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
CellGeometry pointsAround(const double center[3], vtkDataSet* piece)
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

std::vector<float> normalizedScalars(vtkDataSet* piece, vtkDataArray* array, const double range[2])
{
  std::vector<float> scalars(
    static_cast<std::size_t>(piece->GetNumberOfPoints()), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; array && range[0] < range[1] && i < scalars.size(); ++i)
  {
    const float s = normalized({ array }, static_cast<vtkIdType>(i), range);
    scalars[i] = std::isfinite(s) ? s : scalars[i];
  }
  return scalars;
}
}

PieceGradients::PieceGradients(
  vtkDataSet* piece, vtkDataArray* scalars, const double range[2], const double center[3])
  : Piece(piece)
{
  const CellGeometry geometry = pointsAround(center, piece);
  this->Places = findPlaces(geometry);
  this->Sums =
    gradientSums(piece, geometry, normalizedScalars(piece, scalars, range), this->Places);
  this->Positions.reserve(geometry.Points.size());
  for (const CellGeometry::Point& p : geometry.Points)
  {
    this->Positions.push_back({ { p.X, p.Y, p.Z } });
  }
}

void PieceGradients::FindShared(
  const std::vector<vtkIdType>& points, std::vector<vtkBoundingBox> others)
{
  for (vtkBoundingBox& box : others)
  {
    if (box.IsValid())
    {
      box.Inflate(1e-5 * box.GetMaxLength()); // positions are rounded
    }
  }
  for (const vtkIdType point : points)
  {
    double x[3];
    this->Piece->GetPoint(point, x);
    if (std::any_of(others.begin(), others.end(),
          [&](const vtkBoundingBox& box) { return box.IsValid() && box.ContainsPoint(x); }))
    {
      const auto place = static_cast<std::size_t>(this->Places[static_cast<std::size_t>(point)]);
      this->Shared[this->Positions[place]] = place;
    }
  }
}

std::vector<PieceGradients::SumsAtPlace> PieceGradients::Send() const
{
  std::vector<SumsAtPlace> sent;
  for (const auto& place : this->Shared)
  {
    const GradientSums& own = this->Sums[place.second];
    if (own.XX + own.YY + own.ZZ > 0)
    {
      sent.push_back({ { { place.first[0], place.first[1], place.first[2] } }, own });
    }
  }
  return sent;
}

void PieceGradients::Add(const std::vector<SumsAtPlace>& others)
{
  for (const SumsAtPlace& other : others)
  {
    const auto found = this->Shared.find({ { static_cast<float>(other.Where[0]),
      static_cast<float>(other.Where[1]), static_cast<float>(other.Where[2]) } });
    if (found != this->Shared.end())
    {
      this->Sums[found->second].Add(other.Sums);
    }
  }
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
