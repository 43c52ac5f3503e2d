// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "BufferTexture.h"

#include "ShaderArrays.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <vector>

namespace nephoscope
{
namespace
{
std::size_t TupleSize(int components, int type)
{
  return static_cast<std::size_t>(components) * (type == VTK_UNSIGNED_CHAR ? 1 : 4);
}
}

BufferTexture::BufferTexture() = default;
BufferTexture::~BufferTexture() = default;

std::string BufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const void* data, std::size_t tuples, int components, int type)
{
  const ArrayLayout layout = CurrentArrayLayout();
  if (tuples > layout.Capacity)
  {
    std::ostringstream text;
    text << tuples << " elements do not fit in a texture of this OpenGL, which holds "
         << layout.Capacity << "; distribute the data over more ranks, or draw fewer cells";
    return text.str();
  }
  this->Release(window);
  static const float zero[4] = { 0, 0, 0, 0 };
  const void* values = tuples > 0 ? data : zero;
  const std::size_t size = std::max<std::size_t>(tuples, 1);
  this->Texture->SetContext(window);
  if (type == VTK_INT) // which vtkTextureObject would not choose an integer format for
  {
    this->Texture->SetInternalFormat(components == 4 ? GL_RGBA32I
        : components == 2                            ? GL_RG32I
                                                     : GL_R32I);
    this->Texture->SetFormat(components == 4 ? GL_RGBA_INTEGER
        : components == 2                    ? GL_RG_INTEGER
                                             : GL_RED_INTEGER);
  }
  if (layout.RowBits > 0)
  {
    this->UploadRows(values, size, components, type, layout.RowBits);
  }
  else
  {
    this->UploadBuffer(values, size, components, type);
  }
  return std::string();
}

void BufferTexture::UploadBuffer(const void* data, std::size_t tuples, int components, int type)
{
  this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
  this->Buffer->Upload(static_cast<const char*>(data), tuples * TupleSize(components, type),
    vtkOpenGLBufferObject::TextureBuffer);
  this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(tuples), components, type, this->Buffer);
}

// The last row is filled up.
void BufferTexture::UploadRows(
  const void* data, std::size_t tuples, int components, int type, int rowBits)
{
  const std::size_t width = std::size_t(1) << rowBits;
  const std::size_t height = (tuples + width - 1) >> rowBits;
  std::vector<char> rows(width * height * TupleSize(components, type), 0);
  std::memcpy(rows.data(), data, tuples * TupleSize(components, type));
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), components, type, rows.data());
}

int BufferTexture::Activate()
{
  this->Texture->Activate();
  return this->Texture->GetTextureUnit();
}

void BufferTexture::Deactivate()
{
  this->Texture->Deactivate();
}

void BufferTexture::Release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
}

} // namespace nephoscope
