// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeLink.h"

#include "RendererSun.h"

#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace nephoscope
{

vtkStandardNewMacro(HazeLink);
vtkInformationKeyMacro(HazeLink, KEY, ObjectBase);

void HazeLink::Tie(vtkRenderer* renderer, vtkHaze* haze)
{
  this->Renderer = renderer;
  this->Haze = haze;
  constexpr float afterTheSun = -1; // which a host sets at the same event
  this->Observers[0] =
    renderer->AddObserver(vtkCommand::StartEvent, this, &HazeLink::OnStart, afterTheSun);
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
void HazeLink::Tell(const std::string& problem, std::string& told)
{
  if (!problem.empty() && problem != told)
  {
    vtkWarningWithObjectMacro(this->Haze, << problem);
  }
  told = problem;
}

void HazeLink::Place()
{
  HazeScene scene(this->Renderer);
  scene.Join(this->Haze->GetMaximumOfRanks());
  this->Placement = HazePlacement(this->Haze, scene);
  this->Tell(this->Placement.Problem, this->Told);
}

void HazeLink::FindSun()
{
  std::copy_n(this->Haze->GetSunDirection(), 3, this->Sun);
  this->IsLit = vtkMath::Normalize(this->Sun) > 0;
  if (!this->IsLit)
  {
    this->IsLit = FindSunOf(this->Renderer, this->Sun) && vtkMath::Normalize(this->Sun) > 0;
  }
}

void HazeLink::FindShadows()
{
  const bool wanted = this->IsLit && this->Placement.Exists && this->Haze->GetCloudShadows();
  const bool hadShadows = this->Shadows.Exist();
  this->Shadows.Find(this->Renderer, wanted ? this->Sun : nullptr, this->Haze->GetMaximumOfRanks());
  // While scripts change one sun after the other, a frame between has two.
  const bool isNew = hadShadows && !this->Shadows.GetProblem().empty();
  this->Tell(isNew ? std::string() : this->Shadows.GetProblem(), this->ToldOfShadows);
  this->Shadows.Bind(vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow()));
}

void HazeLink::OnStart()
{
  this->OnEnd(); // of a drawing that was given up
  if (this->Haze->IsSeen())
  {
    this->Place();
    this->FindSun();
    this->FindShadows();
  }
  const bool hasSky = this->Renderer->HasViewProp(this->Sky) != 0;
  const vtkHaze::SkyOfRank skyOfRank = this->Haze->GetSkyOfRank();
  const bool wantsSky =
    this->Haze->IsSeen() && this->Haze->GetBackground() && skyOfRank != vtkHaze::SkyOfRank::NONE;
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
    this->Sky->Enter(skyOfRank, this->Renderer->GetActiveCamera());
    this->Shaders->Enter(this->Renderer);
    this->Entered = true;
  }
}

void HazeLink::OnEnd()
{
  if (this->Entered)
  {
    this->Shaders->Leave(this->Renderer);
    this->Sky->Leave();
    this->Entered = false;
  }
  this->Shadows.Unbind();
}

} // namespace nephoscope
