// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeLink.h"

#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

namespace nephoscope
{

vtkStandardNewMacro(HazeLink);
vtkInformationKeyMacro(HazeLink, KEY, ObjectBase);

void HazeLink::Tie(vtkRenderer* renderer, vtkHaze* haze)
{
  this->Renderer = renderer;
  this->Haze = haze;
  this->Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, this, &HazeLink::OnStart);
  this->Observers[1] = renderer->AddObserver(vtkCommand::EndEvent, this, &HazeLink::OnEnd);
}

void HazeLink::Untie()
{
  this->OnEnd();
  for (const unsigned long observer : this->Observers)
  {
    this->Renderer->RemoveObserver(observer);
  }
  this->Renderer->RemoveViewProp(this->Sky);
}

HazeLink* HazeLink::Of(vtkRenderer* renderer)
{
  vtkInformation* information = renderer ? renderer->GetInformation() : nullptr;
  return information ? HazeLink::SafeDownCast(information->Get(HazeLink::KEY())) : nullptr;
}

// Told once, not once per frame.
void HazeLink::Place()
{
  HazeScene scene(this->Renderer);
  this->Haze->CompleteScene(scene);
  this->Placement = HazePlacement(this->Haze, scene);
  if (!this->Placement.Problem.empty() && this->Placement.Problem != this->Told)
  {
    vtkGenericWarningMacro(<< this->Placement.Problem);
  }
  this->Told = this->Placement.Problem;
}

void HazeLink::OnStart()
{
  this->OnEnd(); // of a drawing that was given up
  if (this->Haze->IsSeen())
  {
    this->Place();
  }
  const bool hasSky = this->Renderer->HasViewProp(this->Sky) != 0;
  const bool wantsSky = this->Haze->IsSeen() && this->Haze->GetBackground();
  if (wantsSky && !hasSky)
  {
    this->Renderer->AddViewProp(this->Sky);
  }
  else if (hasSky && !wantsSky)
  {
    this->Renderer->RemoveViewProp(this->Sky);
  }
  if (this->Haze->IsSeen())
  {
    this->Shaders->Enter(this->Renderer);
    this->Entered = true;
  }
}

void HazeLink::OnEnd()
{
  if (this->Entered)
  {
    this->Shaders->Leave(this->Renderer);
    this->Entered = false;
  }
}

} // namespace nephoscope
