// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An array on the GPU, which shaders read as ShaderArrays.h says: a buffer texture, or where these
 * are small a 2-D texture.
 */
#ifndef nephoscope_BufferTexture_h
#define nephoscope_BufferTexture_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkNew.h"

#include <cstddef>
#include <string>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT BufferTexture
{
public:
  BufferTexture();
  ~BufferTexture();
  BufferTexture(const BufferTexture&) = delete;
  BufferTexture& operator=(const BufferTexture&) = delete;

  /**
   * Replaces the content by `tuples` of 1, 2 or 4 components of `type` VTK_FLOAT, VTK_INT or (one
   * component, read as a fraction of
   * 255) VTK_UNSIGNED_CHAR. Without any tuple, the texture holds a zero. Returns an empty string,
   *      or what went wrong.
   */
  std::string Upload(
    vtkOpenGLRenderWindow* window, const void* data, std::size_t tuples, int components, int type);

  /** Binds the texture; returns its unit. */
  int Activate();
  void Deactivate();
  void Release(vtkWindow* window);

private:
  void UploadBuffer(const void* data, std::size_t tuples, int components, int type);
  void UploadRows(const void* data, std::size_t tuples, int components, int type, int rowBits);

  vtkNew<vtkOpenGLBufferObject> Buffer; // not used with rows
  vtkNew<vtkTextureObject> Texture;
};

} // namespace nephoscope

#endif
