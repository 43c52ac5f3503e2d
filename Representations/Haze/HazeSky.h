// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Haze in front of the background, in the pixels that nothing opaque covers, whenever it is drawn among the opaque objects. */
#ifndef HazeSky_h
#define HazeSky_h

#include "ResourceWindow.h"

#include "vtkNew.h"
#include "vtkProp.h"

class vtkOpenGLVertexArrayObject;

namespace nephoscope
{

class HazeSky : public vtkProp
{
public:
  static HazeSky* New();
  vtkTypeMacro(HazeSky, vtkProp);

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
};

} // namespace nephoscope

#endif
