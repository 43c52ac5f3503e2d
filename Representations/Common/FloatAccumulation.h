// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A 32-bit float image in which translucent layers are blended, and which is then laid over the scene.
 * Hundreds of faint layers are lost or tinted in the 8-bit framebuffer of a window.
 */
#ifndef FloatAccumulation_h
#define FloatAccumulation_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkNew.h"

#include <memory> // for std::unique_ptr

class vtkImageData;
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT FloatAccumulation
{
public:
  FloatAccumulation();
  ~FloatAccumulation();
  FloatAccumulation(const FloatAccumulation&) = delete;
  FloatAccumulation& operator=(const FloatAccumulation&) = delete;

  /**
   * Makes a transparent RGBA32F image of the viewport's size the draw target. To be paired with End().
   * Returns false when the framebuffer is not complete.
   */
  bool Begin(vtkOpenGLRenderWindow* window, const int viewport[4]);
  /** Restores the draw target and the viewport. */
  void End(vtkOpenGLRenderWindow* window);
  /** Lays the image (premultiplied colours) over the viewport of the bound framebuffer. */
  void Overlay(vtkOpenGLRenderWindow* window, const int viewport[4]);

  /** Copies the image into `image` as the float point array "RGBA"; false if there is none. */
  bool CopyTo(vtkOpenGLRenderWindow* window, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Color;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  int Size[2] = { 0, 0 };
};

} // namespace nephoscope

#endif
