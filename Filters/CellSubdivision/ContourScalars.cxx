// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourScalars.h"

#include "CellTetrahedra.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSet.h"
#include "vtkSMPTools.h"

#include <limits>

namespace nephoscope
{
namespace
{
constexpr double scalarTolerance = 1e-12; // of what the scalar spans in the cell
constexpr double placeTolerance = 64 * std::numeric_limits<double>::epsilon(); // of the coordinates
constexpr double largestTolerance = 1e-6;
constexpr vtkIdType cellsPerBatch = 4096;
}

ContourScalars::ContourScalars(vtkDataSet* data, vtkDataArray* scalars, const ContourLevels& levels)
  : Levels_(levels)
  , Values(static_cast<std::size_t>(data->GetNumberOfPoints()))
  , Codes(this->Values.size())
{
  const auto count = static_cast<vtkIdType>(this->Values.size());
  double range[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  const auto tuples = vtk::DataArrayValueRange<1>(scalars);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = static_cast<double>(tuples[i]);
    this->Values[i] = value;
    if (std::isfinite(value))
    {
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  }
  std::vector<unsigned char> near(this->Values.size());
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Codes[i] = this->Levels_.Code(this->Values[i]);
      near[i] = this->IsNear(this->Values[i], range[1] - range[0]);
    }
  });
  if (std::find(near.begin(), near.end(), 1) != near.end())
  {
    this->SnapPoints(data, near);
  }
}

bool ContourScalars::IsNear(double scalar, double range) const
{
  const int level = this->Levels_.Nearest(scalar);
  const double distance = level < 0 ? 0 : std::abs(scalar - this->Levels_.Value(level));
  return distance > 0 && distance <= largestTolerance * range; // false for what is not a number
}

double ContourScalars::Snap(double scalar, double range, const CellTetrahedra& cell) const
{
  if (!this->IsNear(scalar, range))
  {
    return scalar;
  }
  double largest = 0;
  for (int i = 0; i < cell.Size(); ++i)
  {
    for (double x : cell.PlaceOf(i))
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  const double shortest = cell.ShortestDistance();
  const double rounding = shortest > 0 ? placeTolerance * largest / shortest : 0;
  const double tolerance = std::min(std::max(scalarTolerance, rounding), largestTolerance);
  const double value = this->Levels_.Value(this->Levels_.Nearest(scalar));
  return std::abs(scalar - value) <= tolerance * range ? value : scalar;
}

void ContourScalars::SnapPoints(vtkDataSet* data, const std::vector<unsigned char>& near)
{
  const vtkIdType cells = data->GetNumberOfCells();
  const vtkIdType batches = (cells + cellsPerBatch - 1) / cellsPerBatch;
  std::vector<std::vector<vtkIdType>> found(static_cast<std::size_t>(batches));
  vtkSMPTools::For(0, batches, 1, [&](vtkIdType first, vtkIdType last) {
    CellTetrahedra cell(data);
    for (vtkIdType c = first * cellsPerBatch; c < std::min(cells, last * cellsPerBatch); ++c)
    {
      if (cell.Load(c) == CellTetrahedra::Kind::Solid)
      {
        this->FindPointsToSnap(cell, near, found[c / cellsPerBatch]);
      }
    }
  });
  for (const auto& points : found)
  {
    this->Snapped_.insert(this->Snapped_.end(), points.begin(), points.end());
  }
  std::sort(this->Snapped_.begin(), this->Snapped_.end());
  this->Snapped_.erase(
    std::unique(this->Snapped_.begin(), this->Snapped_.end()), this->Snapped_.end());
  for (vtkIdType point : this->Snapped_)
  {
    const int level = this->Levels_.Nearest(this->Values[point]);
    this->Values[point] = this->Levels_.Value(level);
    this->Codes[point] = 2 * level + 1;
  }
}

void ContourScalars::FindPointsToSnap(
  CellTetrahedra& cell, const std::vector<unsigned char>& near, std::vector<vtkIdType>& found) const
{
  bool candidate = false;
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (int i = 0; i < cell.Size(); ++i)
  {
    candidate = candidate || near[cell.Point(i)];
    low = std::min(low, this->Values[cell.Point(i)]);
    high = std::max(high, this->Values[cell.Point(i)]);
  }
  if (!candidate || !std::isfinite(high - low))
  {
    return;
  }
  cell.Locate();
  for (int i = 0; i < cell.Size(); ++i)
  {
    const vtkIdType point = cell.Point(i);
    const double value = this->Values[point];
    if (near[point] && this->Snap(value, high - low, cell) != value)
    {
      found.push_back(point);
    }
  }
}

} // namespace nephoscope
