// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVFlowVolume.h"

#include "ChangeOfInput.h"
#include "VelocityChoice.h"
#include "VelocityFields.h"
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
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkPVFlowVolume);

namespace
{
constexpr double otherData =
  0.01; // change of the diagonal; time steps of one series differ by less

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

// What the rank found that has the best place. Collective.
void TakeBestOverRanks(std::vector<double>& place)
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
  std::copy_n(all.begin(), place.size(), place.begin()); // of the first rank, if others are as good
  for (std::size_t i = place.size(); i < all.size(); i += place.size())
  {
    if (place[0] < all[i])
    {
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(i), place.size(), place.begin());
    }
  }
}
}

// The field of the data as they were last, kept while a polygon is dragged.
class nephoscope::FlowPreview
{
public:
  Vector3 At(vtkDataObject* data, vtkInformation* wanted, const Vector3& place)
  {
    if (data != this->Data || data->GetMTime() != this->MTime)
    {
      std::string problem;
      VelocityArray array;
      this->Field.reset();
      this->Data = data;
      this->MTime = data->GetMTime();
      if (ChooseVelocity(data, wanted, array, problem))
      {
        this->Field = MakeVelocityField(data, array, problem);
      }
    }
    Vector3 velocity{};
    unsigned char inside = 0;
    CellHint hint;
    if (this->Field)
    {
      this->Field->Sample({ 1, &place, 0.0, &velocity, &inside, &hint });
    }
    return inside ? velocity : Vector3{};
  }

private:
  vtkSmartPointer<vtkDataObject> Data; // must outlive the field
  vtkMTimeType MTime = 0;
  std::unique_ptr<DataSetField> Field;
};

vtkPVFlowVolume::vtkPVFlowVolume() = default;

vtkPVFlowVolume::~vtkPVFlowVolume() = default;

int vtkPVFlowVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  const double diagonal = DiagonalOfAllRanks(input);
  const bool isOther =
    this->IsOtherInput() && std::abs(diagonal - this->Diagonal) > otherData * this->Diagonal;
  this->Diagonal = this->Diagonal > 0.0 && !isOther ? diagonal : this->Diagonal;
  const bool isUnplaced = this->PlaceRadius == 0.0; // nothing has flowed so far
  if (this->FollowData && (isOther || isUnplaced) && this->GetNumberOfInputConnections(1) == 0 &&
    this->IsWhereItWasPlaced())
  {
    this->FindPlaceIn(input);
    if (this->PlaceRadius > 0.0) // not Set...: an update does not modify what is updated
    {
      std::copy_n(this->PlaceCenter, 3, this->Center);
      std::copy_n(this->PlaceNormal, 3, this->Normal);
      this->Radius = this->PlaceRadius;
    }
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}

// Other data, not another time step of the same series: the polygon of a film stays where it is.
// Collective.
bool vtkPVFlowVolume::IsOtherInput()
{
  const vtkMTimeType now = nephoscope::ChangeOfInput(this);
  int isOther = now != this->Change ? 1 : 0, isOtherAnywhere = isOther;
  this->Change = now;
  if (auto controller = vtkMultiProcessController::GetGlobalController())
  {
    controller->AllReduce(&isOther, &isOtherAnywhere, 1, vtkCommunicator::MAX_OP);
  }
  return isOtherAnywhere != 0;
}

bool vtkPVFlowVolume::IsWhereItWasPlaced()
{
  return std::equal(this->Center, this->Center + 3, this->PlaceCenter) &&
    this->Radius == this->PlaceRadius &&
    std::equal(this->Normal, this->Normal + 3, this->PlaceNormal);
}

void vtkPVFlowVolume::FindPlace()
{
  this->FindPlaceIn(
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr);
}

void vtkPVFlowVolume::FindPlaceIn(vtkDataObject* input)
{
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  const char* name = wanted->Get(vtkDataObject::FIELD_NAME());
  const bool onCells = wanted->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    wanted->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkNew<vtkFlowVolumePlacement> finder;
  this->Diagonal = DiagonalOfAllRanks(input);
  finder->SetController(this->GetController());
  finder->SetNumberOfSides(this->GetNumberOfSides());
  const bool found = finder->Find(input, name ? name : "", onCells);
  const double nowhere[] = { 0.0, 0.0, 0.0 }, up[] = { 0.0, 0.0, 1.0 };
  this->PlaceRadius = found ? finder->GetRadius() : 0.0;
  std::copy_n(found ? finder->GetCenter() : nowhere, 3, this->PlaceCenter);
  std::copy_n(found ? finder->GetNormal() : up, 3, this->PlaceNormal);
}

void vtkPVFlowVolume::SetPreviewCenter(double x, double y, double z)
{
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  nephoscope::Vector3 flow{};
  if (input && input->GetNumberOfElements(vtkDataObject::POINT) > 0)
  {
    this->Preview =
      this->Preview ? std::move(this->Preview) : std::make_unique<nephoscope::FlowPreview>();
    flow = this->Preview->At(input, this->GetInputArrayInformation(0), { { x, y, z } });
  }
  std::vector<double> best = { vtkMath::Norm(flow.data()), 0.0, flow[0], flow[1], flow[2] };
  if (!std::isfinite(best[0]))
  {
    best.assign(5, 0.0);
  }
  TakeBestOverRanks(best);
  std::copy_n(best.begin() + 2, 3, this->PreviewNormal);
  vtkMath::Normalize(this->PreviewNormal);
}

void vtkPVFlowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlaceRadius: " << this->PlaceRadius << "\n";
}
