// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVFlowVolume.h"

#include "vtkFlowVolumePlacement.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
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

// What the rank found with the largest polygon, then the fastest flow. Collective.
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
  if (input && finder->Find(input, name ? name : "", onCells))
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

void vtkPVFlowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlaceRadius: " << this->PlaceRadius << "\n";
}
