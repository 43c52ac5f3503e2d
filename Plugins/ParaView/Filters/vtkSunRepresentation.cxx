// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSunRepresentation.h"

#include "Ranks.h"
#include "RendererSun.h"
#include "SharedSun.h"

#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkSunRepresentation);

namespace
{
constexpr double globe = 0.0; // what GlobeGridProjection says of one
}

vtkSunRepresentation::vtkSunRepresentation()
{
  this->Sun->SetLightTypeToSceneLight();
  this->Sun->PositionalOff();
  this->Sun->SetFocalPoint(0, 0, 0);
  this->Fill->SetLightTypeToHeadlight();
  this->Fill->SetIntensity(0.25);
}

vtkSunRepresentation::~vtkSunRepresentation()
{
  this->Switch(false);
}

int vtkSunRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkSunRepresentation::SetIntensity(double intensity)
{
  this->Sun->SetIntensity(intensity);
}

void vtkSunRepresentation::SetFillLight(double intensity)
{
  this->Fill->SetIntensity(intensity);
}

int vtkSunRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // One rank is enough, and it is the first: what all have is put together.
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  nephoscope::SharedSun sun;
  vtkNew<vtkPoints> directions;
  directions->SetDataTypeToDouble();
  if ((!ranks || ranks->GetLocalProcessId() == 0) &&
    inputs[0]->GetNumberOfInformationObjects() == 1 &&
    nephoscope::ReadSun(vtkDataObject::GetData(inputs[0]), sun))
  {
    directions->InsertNextPoint(sun.Direction.data());
    directions->InsertNextPoint(sun.DirectionOnGlobe.data());
  }
  this->Piece->SetPoints(directions);
  return this->Superclass::RequestData(request, inputs, outputs);
}

int vtkSunRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Piece);
    vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->Shown = vtkPolyData::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this));
  }
  return 1;
}

void vtkSunRepresentation::Switch(bool on)
{
  if (on && this->OfView && !this->Renderer)
  {
    this->Renderer = this->OfView;
    this->Observers[0] =
      this->Renderer->AddObserver(vtkCommand::StartEvent, this, &vtkSunRepresentation::OnStart);
    this->Observers[1] =
      this->Renderer->AddObserver(vtkCommand::EndEvent, this, &vtkSunRepresentation::OnEnd);
    this->Renderer->AddLight(this->Sun);
    this->Renderer->AddLight(this->Fill);
  }
  else if (!on && this->Renderer)
  {
    this->OnEnd(); // of a render that was given up
    for (const unsigned long observer : this->Observers)
    {
      this->Renderer->RemoveObserver(observer);
    }
    this->Renderer->RemoveLight(this->Sun);
    this->Renderer->RemoveLight(this->Fill);
    this->Renderer = nullptr;
  }
}

bool vtkSunRepresentation::FindDirection(double direction[3])
{
  double onGlobe[3];
  const bool found = this->Shown && this->Shown->GetNumberOfPoints() >= 2;
  if (!found)
  {
    return false;
  }
  this->Shown->GetPoint(0, direction);
  this->Shown->GetPoint(1, onGlobe);
  if (!std::equal(onGlobe, onGlobe + 3, direction) &&
    nephoscope::MaximumOverRanks(
      nephoscope::GreatestFieldValue(this->Renderer, "GlobeGridProjection", -1)) == globe)
  {
    std::copy_n(onGlobe, 3, direction);
  }
  return true;
}

// Volumes shine by an array, not by the light of the view.
void vtkSunRepresentation::WarnOfVolumes()
{
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  const bool isAlone = !ranks || ranks->GetNumberOfProcesses() == 1; // each rank has other data
  const bool isUnlit = isAlone && nephoscope::HasVolumesWithout(this->Renderer, "Sunlight");
  if (isUnlit && !this->HasToldOfVolumes)
  {
    vtkWarningMacro(
      "The sun lights surfaces, but no volume in this view: their data have no light yet. For clouds apply Cloud Optics, if they have no Extinction, "
      "and Sunlight; for the smoke of a Flow Volume apply Sunlight alone. Show its output. Data that are not a medium, such as a temperature, need no light: "
      "hide the Sun, or leave it as it is.");
  }
  this->HasToldOfVolumes = isUnlit;
}

void vtkSunRepresentation::OnStart()
{
  this->OnEnd();
  double direction[3];
  const bool shines = this->FindDirection(direction);
  this->Sun->SetSwitch(shines);
  this->Fill->SetSwitch(shines);
  if (!shines)
  {
    return;
  }
  this->WarnOfVolumes();
  this->Sun->SetPosition(direction);
  nephoscope::SetSunOf(this->Renderer, direction);
  vtkCollectionSimpleIterator iterator;
  this->Renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = this->Renderer->GetLights()->GetNextLight(iterator))
  {
    if (light != this->Fill && light->GetSwitch() && !light->LightTypeIsSceneLight())
    {
      light->SwitchOff();
      this->Hidden.emplace_back(light);
    }
  }
}

void vtkSunRepresentation::OnEnd()
{
  for (vtkLight* light : this->Hidden)
  {
    light->SwitchOn();
  }
  this->Hidden.clear();
  if (this->Renderer)
  {
    nephoscope::SetSunOf(this->Renderer, nullptr);
  }
}

bool vtkSunRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  this->OfView = renderView->GetRenderer();
  this->Switch(this->GetVisibility());
  return this->Superclass::AddToView(view);
}

bool vtkSunRepresentation::RemoveFromView(vtkView* view)
{
  this->Switch(false);
  this->OfView = nullptr;
  return this->Superclass::RemoveFromView(view);
}

void vtkSunRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Switch(visible);
}

void vtkSunRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Intensity: " << this->Sun->GetIntensity() << "\n"
     << indent << "FillLight: " << this->Fill->GetIntensity() << "\n";
}
