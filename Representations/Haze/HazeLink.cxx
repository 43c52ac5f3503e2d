// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeLink.h"

#include "vtkCommand.h"
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

void HazeLink::OnStart()
{
  this->OnEnd(); // of a drawing that was given up
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
