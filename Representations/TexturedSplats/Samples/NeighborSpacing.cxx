// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborSpacing.h"

#include "SplatSamples.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
// On a cubic lattice a ball of as many neighbours is 0.99 cells for each.
constexpr vtkIdType neighbors = 12;
constexpr double pi = 3.14159265358979323846;
constexpr double unitBall[3] = { 2.0, pi, 4.0 * pi / 3.0 };
}

MediumBounds BulkOfPoints(vtkDataSet* data)
{
  return RobustBoundsOfPlaces(data->GetNumberOfPoints(), [&](vtkIdType id, double* x) {
    data->GetPoint(id, x);
    return std::isfinite(x[0] + x[1] + x[2]);
  });
}

std::vector<float> FindNeighborSpacing(vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  std::vector<float> spacing(static_cast<std::size_t>(count), 0.0f);
  std::vector<vtkIdType> ids;
  const MediumBounds bulk = BulkOfPoints(data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType id = 0; id < count; ++id)
  {
    double x[3];
    data->GetPoint(id, x);
    if (HoldsPlace(
          bulk, x)) // the locator could not tell those apart that lie together far from others
    {
      points->InsertNextPoint(x);
      ids.push_back(id);
    }
  }
  if (ids.empty())
  {
    return spacing;
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  const double mean = MeanSpacing(bulk.data(), ids.size());
  const int axes = std::max(1, NumberOfAxes(bulk.data()));
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  const auto others = std::min<vtkIdType>(neighbors, static_cast<vtkIdType>(ids.size()) - 1);
  vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()), [&](vtkIdType begin, vtkIdType end) {
    vtkNew<vtkIdList> nearest;
    for (vtkIdType i = begin; i < end; ++i)
    {
      double place[3];
      points->GetPoint(i, place);
      double farthest = 0;
      locator->FindClosestNPoints(static_cast<int>(others) + 1, place, nearest);
      for (vtkIdType n = 0; n < nearest->GetNumberOfIds(); ++n)
      {
        double other[3];
        points->GetPoint(nearest->GetId(n), other);
        farthest = std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(place, other)));
      }
      const double ball = unitBall[axes - 1] * std::pow(farthest, axes);
      spacing[static_cast<std::size_t>(ids[static_cast<std::size_t>(i)])] = static_cast<float>(
        farthest > 0 ? std::pow(ball / static_cast<double>(others), 1.0 / axes) : mean);
    }
  });
  for (vtkIdType id = 0; id < count; ++id)
  {
    double x[3];
    data->GetPoint(id, x);
    const bool far = std::isfinite(x[0] + x[1] + x[2]) && !HoldsPlace(bulk, x);
    spacing[static_cast<std::size_t>(id)] =
      far ? static_cast<float>(mean) : spacing[static_cast<std::size_t>(id)];
  }
  return spacing;
}

} // namespace nephoscope
