// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What ties a haze to one renderer: it lives in the renderer's information and acts whenever the
 * renderer starts and ends to draw.
 */
#ifndef nephoscope_HazeLink_h
#define nephoscope_HazeLink_h

#include "HazePlacement.h"
#include "HazeShaderPass.h"
#include "HazeShadows.h"
#include "HazeSky.h"

#include "vtkHaze.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkInformationObjectBaseKey;
class vtkRenderer;

namespace nephoscope
{

class HazeLink : public vtkObject
{
public:
  static HazeLink* New();
  vtkTypeMacro(HazeLink, vtkObject);

  static vtkInformationObjectBaseKey* KEY();

  /** The renderer owns this object: it is not kept alive. */
  void Tie(vtkRenderer* renderer, vtkHaze* haze);
  void Untie();
  vtkHaze* GetHaze() const { return this->Haze; }
  /** As it was found when the renderer began to draw. */
  const HazePlacement& GetPlacement() const { return this->Placement; }
  const HazeShadows& GetShadows() const { return this->Shadows; }
  /** Towards the sun, with a length of 1; null: no sun lights the haze. */
  const double* GetSun() const { return this->IsLit ? this->Sun : nullptr; }

  /** The link of the renderer, or null. */
  static HazeLink* Of(vtkRenderer* renderer);

protected:
  HazeLink() = default;
  ~HazeLink() override = default;

private:
  HazeLink(const HazeLink&) = delete;
  void operator=(const HazeLink&) = delete;

  void OnStart();
  void OnEnd();
  void Place();
  void FindSun();
  void FindShadows();
  void Tell(const std::string& problem, std::string& told);

  vtkRenderer* Renderer = nullptr;
  unsigned long Observers[2] = { 0, 0 };
  bool Entered = false;
  HazePlacement Placement;
  std::string Told, ToldOfShadows;
  bool IsLit = false;
  double Sun[3] = { 0, 0, 0 };
  HazeShadows Shadows;
  vtkSmartPointer<vtkHaze> Haze;
  vtkNew<HazeShaderPass> Shaders;
  vtkNew<HazeSky> Sky;
};

} // namespace nephoscope

#endif
