// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHazeRepresentation.h"

#include "ForwardedMessages.h"
#include "RankRegions.h"

#include "vtkCommunicator.h"
#include "vtkHaze.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

#include <vector>

vtkStandardNewMacro(vtkHazeRepresentation);

namespace
{
// All ranks draw at once, each what it has.
void TakeMaximumOfRanks(double* numbers, int count)
{
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (ranks && ranks->GetNumberOfProcesses() > 1)
  {
    const std::vector<double> mine(numbers, numbers + count);
    ranks->AllReduce(mine.data(), numbers, count, vtkCommunicator::MAX_OP);
  }
}

// If ranks have boxes, the view blends their pictures in the order of these. Otherwise it takes the
// nearest fragment of all ranks.
vtkHaze::SkyOfRank LookForSkyOfRank(vtkPVRenderView* view)
{
  using Sky = vtkHaze::SkyOfRank;
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  if (!view || !ranks || ranks->GetNumberOfProcesses() < 2)
  {
    return Sky::ALONE;
  }
  const int rank = ranks->GetLocalProcessId();
  const std::vector<vtkBoundingBox>* boxes = nephoscope::BoxesOfRanks(view);
  if (!boxes || boxes->empty())
  {
    return rank == 0 ? Sky::BY_DEPTH : Sky::NONE;
  }
  vtkNew<vtkOrderedCompositingHelper> order;
  order->SetBoundingBoxes(*boxes);
  return order->ComputeSortOrder(view->GetActiveCamera()).back() == rank ? Sky::LAST : Sky::NONE;
}
}

vtkHazeRepresentation::vtkHazeRepresentation()
{
  nephoscope::ForwardMessages(this->Haze, this);
  this->Haze->SetMaximumOfRanks(TakeMaximumOfRanks);
}

vtkHazeRepresentation::~vtkHazeRepresentation()
{
  this->Switch(false);
}

int vtkHazeRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkHazeRepresentation::Switch(bool on)
{
  vtkRenderer* renderer = this->View ? this->View->GetRenderer() : nullptr;
  if (!renderer)
  {
    return;
  }
  if (on)
  {
    vtkHaze::SetHaze(renderer, this->Haze);
  }
  else if (vtkHaze::GetHaze(renderer) == this->Haze)
  {
    vtkHaze::SetHaze(renderer, nullptr);
  }
}

bool vtkHazeRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  this->View = renderView;
  this->Haze->SetFindSkyOfRank([view = this->View] { return LookForSkyOfRank(view); });
  this->Switch(this->GetVisibility());
  return this->Superclass::AddToView(view);
}

bool vtkHazeRepresentation::RemoveFromView(vtkView* view)
{
  this->Switch(false);
  this->View = nullptr;
  return this->Superclass::RemoveFromView(view);
}

void vtkHazeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Switch(visible);
}

void vtkHazeRepresentation::SetVisualRange(double length)
{
  this->Haze->SetVisibility(length);
}

void vtkHazeRepresentation::SetScaleHeight(double height)
{
  this->Haze->SetScaleHeight(height);
}

void vtkHazeRepresentation::SetVerticalExaggeration(double factor)
{
  this->Haze->SetVerticalExaggeration(factor);
}

void vtkHazeRepresentation::SetHazeColor(double red, double green, double blue)
{
  this->Haze->SetColor(red, green, blue);
}

void vtkHazeRepresentation::SetSunDirection(double x, double y, double z)
{
  this->Haze->SetSunDirection(x, y, z);
}

void vtkHazeRepresentation::SetAsymmetry(double asymmetry)
{
  this->Haze->SetAsymmetry(asymmetry);
}

void vtkHazeRepresentation::SetCloudShadows(bool cast)
{
  this->Haze->SetCloudShadows(cast);
}

void vtkHazeRepresentation::SetProjection(int projection)
{
  this->Haze->SetProjection(projection);
}

void vtkHazeRepresentation::SetCenter(double x, double y, double z)
{
  this->Haze->SetCenter(x, y, z);
}

void vtkHazeRepresentation::SetPlanetRadius(double radius)
{
  this->Haze->SetPlanetRadius(radius);
}

void vtkHazeRepresentation::SetUpDirection(double x, double y, double z)
{
  this->Haze->SetUpDirection(x, y, z);
}

void vtkHazeRepresentation::SetBaseLevel(double level)
{
  this->Haze->SetBaseLevel(level);
}

void vtkHazeRepresentation::SetHazeBackground(bool hazed)
{
  this->Haze->SetBackground(hazed);
}

void vtkHazeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Haze:\n";
  this->Haze->PrintSelf(os, indent.GetNextIndent());
}
