// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A 32-bit float image in which translucent layers are blended, and which is then laid over the
 * scene.
 * Hundreds of faint layers are lost or tinted in the 8-bit framebuffer of a window.
 */
#ifndef nephoscope_FloatAccumulation_h
#define nephoscope_FloatAccumulation_h

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
   * Makes a transparent RGBA32F image of the viewport's size the draw target. To be paired with
   * End().
   * With more layers there are as many such images, gl_FragData[0], [1] ..., from a first one on.
   * `depth`, of the same size, becomes the depth buffer.
   * Keep: the images keep what they hold. Returns false when the framebuffer is not complete.
   */
  static constexpr int MostLayers = 8; ///< every OpenGL has as many draw buffers
  enum Content
  {
    Clear,
    Keep
  };
  bool Begin(vtkOpenGLRenderWindow* window, const int viewport[4], int layers = 1,
    vtkTextureObject* depth = nullptr, Content content = Clear, int first = 0);
  /** Between Begin() and End(): a texture of the images' size becomes the depth buffer. */
  void SetDepth(vtkTextureObject* depth);
  /** Restores the draw target and the viewport. */
  void End(vtkOpenGLRenderWindow* window);
  /** The image of a layer. */
  vtkTextureObject* GetTexture(int layer) const { return this->Colors[layer]; }
  /**
   * Lays the first image (premultiplied colours) over the viewport of the bound framebuffer,
   * interpolated if it has fewer pixels.
   */
  void Overlay(vtkOpenGLRenderWindow* window, const int viewport[4]);

  /**
   * Copies the first image into `image` as the float point array "RGBA"; false if there is none.
   */
  bool CopyTo(vtkOpenGLRenderWindow* window, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height, int layers); // at least
  void Attach(int first, int layers);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Colors[MostLayers];
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  int Size[2] = { 0, 0 };
};

} // namespace nephoscope

#endif
