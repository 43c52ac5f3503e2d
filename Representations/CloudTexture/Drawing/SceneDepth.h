// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The depth of opaque objects, for mappers of translucent surfaces. Depth peeling draws them into
 * images without a depth buffer; there the pass provides the depth, in its first stage only.
 */
#ifndef nephoscope_SceneDepth_h
#define nephoscope_SceneDepth_h

#include "OpaqueDepth.h"

#include "vtkNew.h"

#include <memory>

class vtkAbstractMapper;
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class SceneDepth
{
public:
  /** What is being drawn. */
  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr;
    vtkAbstractMapper* Mapper = nullptr;
    vtkProp* Prop = nullptr;
    int Viewport[4] = { 0, 0, 0, 0 };
  };

  SceneDepth();
  ~SceneDepth();
  SceneDepth(const SceneDepth&) = delete;
  SceneDepth& operator=(const SceneDepth&) = delete;

  /**
   * Whether the depth can be found now; in the later stages of peeling it cannot, and the one found
   * before holds.
   */
  static bool IsTold(vtkProp* prop);

  /**
   * A depth texture of the viewport's size; null where a shader does not compile. All state is
   * restored.
   */
  vtkTextureObject* Find(const Request& request);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool AskPass(const Request& request);
  void Allocate(const Request& request);

  OpaqueDepth Buffer;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Asked;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  int Size[2] = { 0, 0 };
};

} // namespace nephoscope

#endif
