// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointPlaces.h"

#include "DataSets.h"
#include "NeighborSpacing.h"
#include "RobustBounds.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <cmath>
#include <numeric>

namespace nephoscope
{
double RoundingOfPlaces(vtkDataSet* data)
{
  constexpr double samePlace = 2e-7;
  const MediumBounds b = BulkOfPoints(data);
  return samePlace * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

std::vector<vtkIdType> FindPlaces(vtkDataSet* data)
{
  if (HasOnlyVertices(data)) // particles in one place stay apart: each is a sample of its own
  {
    return {};
  }
  std::vector<vtkIdType> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    double x[3];
    data->GetPoint(id, x);
    if (std::isfinite(x[0] + x[1] + x[2]))
    {
      points->InsertNextPoint(x);
      ids.push_back(id);
    }
  }
  if (ids.empty())
  {
    return {};
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  std::vector<vtkIdType> merged(ids.size());
  locator->MergePoints(RoundingOfPlaces(data), merged.data());
  std::vector<vtkIdType> places(static_cast<std::size_t>(data->GetNumberOfPoints()));
  std::iota(places.begin(), places.end(), 0);
  bool apart = true;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const vtkIdType first = merged[i] >= 0 ? ids[static_cast<std::size_t>(merged[i])] : ids[i];
    places[static_cast<std::size_t>(ids[i])] = first;
    apart = apart && first == ids[i];
  }
  return apart ? std::vector<vtkIdType>() : places;
}

} // namespace nephoscope
