// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVFlowVolume.h"

#include "vtkFlowVolumePlacement.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <vector>

vtkStandardNewMacro(vtkPVFlowVolume);

namespace
{
double DiagonalOfAllRanks(vtkDataObject* data)
{
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  if (auto dataSet = vtkDataSet::SafeDownCast(data))
  {
    dataSet->GetBounds(bounds);
  }
  else if (auto composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    composite->GetBounds(bounds);
  }
  vtkBoundingBox all(bounds);
  if (auto controller = vtkMultiProcessController::GetGlobalController())
  {
    const vtkBoundingBox mine(bounds);
    controller->AllReduce(mine, all);
  }
  return all.IsValid() ? all.GetDiagonalLength() : 0.0;
}

// Nine numbers of the rank with the largest polygon, then the fastest flow. Collective.
void TakeBestOfAllRanks(std::vector<double>& place)
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  const auto length = static_cast<vtkIdType>(place.size());
  std::vector<double> all(
    place.size() * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(place.data(), all.data(), length);
  for (std::size_t i = 0; i < all.size(); i += place.size())
  {
    if (std::lexicographical_compare(place.begin(), place.begin() + 2,
          all.begin() + static_cast<std::ptrdiff_t>(i),
          all.begin() + static_cast<std::ptrdiff_t>(i) + 2))
    {
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(i), place.size(), place.begin());
    }
  }
}

// Normal of the plane of some points: the direction in which they spread least.
bool PlaneNormal(const std::vector<std::array<double, 3>>& points, double normal[3])
{
  if (points.size() < 3)
  {
    return false;
  }
  double middle[3] = { 0.0, 0.0, 0.0 };
  for (const auto& x : points)
  {
    for (int i = 0; i < 3; ++i)
    {
      middle[i] += x[static_cast<std::size_t>(i)] / static_cast<double>(points.size());
    }
  }
  double rows[3][3] = {}, columns[3][3], values[3];
  for (const auto& x : points)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        rows[i][j] += (x[i] - middle[i]) * (x[j] - middle[j]);
      }
    }
  }
  double* a[3] = { rows[0], rows[1], rows[2] };
  double* v[3] = { columns[0], columns[1], columns[2] };
  vtkMath::Jacobi(a, values, v); // descending
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = columns[i][2];
  }
  return values[1] > 0.0;
}

// From the smoke itself, so that it is right for every kind of polygon: it spans the points of age 0, and points to
// where the smoke goes.
void NormalOfSmoke(vtkUnstructuredGrid* smoke, double normal[3])
{
  std::fill_n(normal, 3, 0.0);
  vtkDataArray* ages = smoke->GetPointData()->GetArray("Age");
  if (!ages)
  {
    return;
  }
  std::vector<std::array<double, 3>> polygon;
  double start[3] = { 0.0, 0.0, 0.0 }, next[3] = { 0.0, 0.0, 0.0 }, nextAge = VTK_DOUBLE_MAX;
  vtkIdType nextCount = 0;
  for (vtkIdType i = 0; i < smoke->GetNumberOfPoints(); ++i)
  {
    const double age = ages->GetComponent(i, 0);
    std::array<double, 3> x;
    smoke->GetPoint(i, x.data());
    if (age <= 0.0)
    {
      polygon.push_back(x);
      vtkMath::Add(start, x.data(), start);
    }
    else if (age <= nextAge)
    {
      const bool isNew = age < nextAge;
      nextCount = isNew ? 1 : nextCount + 1;
      for (std::size_t k = 0; k < 3; ++k)
      {
        next[k] = isNew ? x[k] : next[k] + x[k];
      }
      nextAge = age;
    }
  }
  if (nextCount == 0 || !PlaneNormal(polygon, normal))
  {
    std::fill_n(normal, 3, 0.0);
    return;
  }
  double along = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    along += normal[i] *
      (next[i] / static_cast<double>(nextCount) - start[i] / static_cast<double>(polygon.size()));
  }
  for (int i = 0; along < 0.0 && i < 3; ++i)
  {
    normal[i] = -normal[i];
  }
}
}

void vtkPVFlowVolume::FindPlace()
{
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  const char* name = wanted->Get(vtkDataObject::FIELD_NAME());
  const bool onCells = wanted->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    wanted->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkNew<vtkFlowVolumePlacement> finder;
  finder->SetDiagonal(DiagonalOfAllRanks(input));
  std::vector<double> place(8, 0.0); // radius, speed, centre, normal
  if (input && finder->Find(input, name && *name ? name : "DisplayVelocity", onCells))
  {
    place[0] = finder->GetRadius();
    place[1] = finder->GetSpeed();
    std::copy_n(finder->GetCenter(), 3, place.begin() + 2);
    std::copy_n(finder->GetNormal(), 3, place.begin() + 5);
  }
  TakeBestOfAllRanks(place);
  this->PlaceRadius = place[0];
  std::copy_n(place.begin() + 2, 3, this->PlaceCenter);
  std::copy_n(place.begin() + 5, 3, this->PlaceNormal);
}

int vtkPVFlowVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int done = this->Superclass::RequestData(request, inputs, outputs);
  NormalOfSmoke(vtkUnstructuredGrid::GetData(outputs, 0), this->PolygonNormal);
  return done;
}

void vtkPVFlowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PolygonNormal: " << this->PolygonNormal[0] << " " << this->PolygonNormal[1]
     << " " << this->PolygonNormal[2] << "\n";
}
