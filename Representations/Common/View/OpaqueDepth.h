// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A copy of the depth buffer as the opaque geometry left it, for shaders that end their rays there.
 */
#ifndef nephoscope_OpaqueDepth_h
#define nephoscope_OpaqueDepth_h

#include "MeanDepth.h"

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkNew.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT OpaqueDepth
{
public:
  OpaqueDepth();
  ~OpaqueDepth();
  OpaqueDepth(const OpaqueDepth&) = delete;
  OpaqueDepth& operator=(const OpaqueDepth&) = delete;

  /**
   * Copies the depth of the bound draw framebuffer inside `viewport` (x, y, width, height in
   * pixels) into a texture of that size, or only a region of it (x, y, width, height in the
   * viewport). Framebuffer bindings are restored. In multisampled buffers it is the depth at the
   * centres of the pixels (MeanDepth.h).
   */
  void Copy(vtkOpenGLRenderWindow* window, const int viewport[4], const int* region = nullptr);
  /**
   * Picks the copy's depths at the centres of `width` times `height` larger pixels; GetTexture()
   * gives them until the next copy.
   */
  void Coarsen(vtkOpenGLRenderWindow* window, int width, int height);

  /**
   * A second copy of GetTexture(), so that one can be the depth buffer while shaders read the
   * other.
   */
  vtkTextureObject* Duplicate(vtkOpenGLRenderWindow* window);

  /** Depth in [0, 1], one texel per pixel of the viewport. */
  vtkTextureObject* GetTexture() const
  {
    return this->IsCoarse ? this->Coarse.Texture : this->Whole.Texture;
  }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Format
  {
    int Bits = 0;
    int Type = 0;
    int StencilBits = 0;
    bool operator==(const Format& other) const
    {
      return this->Bits == other.Bits && this->Type == other.Type &&
        this->StencilBits == other.StencilBits;
    }
  };
  static Format DrawFramebufferFormat();
  void Allocate(vtkOpenGLRenderWindow* window, const Format& format, int width, int height);
  struct Image
  {
    vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
    vtkNew<vtkTextureObject> Texture;
  };
  void Fill(vtkOpenGLRenderWindow* window, Image& image, Image& source, int width, int height);
  static void AllocateTexture(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
    const Format& format, const int size[2]);

  Image Whole, Coarse, Second;
  MeanDepth Mean;
  bool IsCoarse = false;
  Format AllocatedFormat;
  int Size[2] = { 0, 0 };
};

} // namespace nephoscope

#endif
