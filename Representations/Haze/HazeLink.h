// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What ties a haze to one renderer: it lives in the renderer's information and acts whenever the renderer starts and ends to draw. */
#ifndef HazeLink_h
#define HazeLink_h

#include "HazePlacement.h"
#include "HazeShaderPass.h"
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

  vtkRenderer* Renderer = nullptr;
  unsigned long Observers[2] = { 0, 0 };
  bool Entered = false;
  HazePlacement Placement;
  std::string Told;
  vtkSmartPointer<vtkHaze> Haze;
  vtkNew<HazeShaderPass> Shaders;
  vtkNew<HazeSky> Sky;
};

} // namespace nephoscope

#endif
