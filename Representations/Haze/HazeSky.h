// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Haze in front of the background, in the pixels that nothing opaque covers, whenever it is drawn
 * among the opaque objects.
 * On several ranks one of them draws it, as the farthest layer of its picture.
 */
#ifndef nephoscope_HazeSky_h
#define nephoscope_HazeSky_h

#include "ResourceWindow.h"

#include "vtkHaze.h"
#include "vtkNew.h"
#include "vtkProp.h"

class vtkCamera;
class vtkOpenGLVertexArrayObject;

namespace nephoscope
{

class HazeSky : public vtkProp
{
public:
  static HazeSky* New();
  vtkTypeMacro(HazeSky, vtkProp);

  /**
   * If several ranks draw, it has bounds on all sides of the camera until Leave. Compositing takes
   * from the picture of each rank only the part in which the bounds of that rank lie.
   */
  void Enter(vtkHaze::SkyOfRank rank, vtkCamera* camera);
  void Leave() { this->UseBoundsOff(); }
  double* GetBounds() override { return this->UseBounds ? this->Bounds : nullptr; }

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  HazeSky();
  ~HazeSky() override;

private:
  HazeSky(const HazeSky&) = delete;
  void operator=(const HazeSky&) = delete;

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; // without attributes
  ResourceWindow Window;
  bool HasDepth = false;
  double Bounds[6] = { 0, 0, 0, 0, 0, 0 };
};

} // namespace nephoscope

#endif
