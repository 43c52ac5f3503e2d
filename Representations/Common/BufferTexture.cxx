// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "BufferTexture.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <sstream>

namespace nephoscope
{

BufferTexture::BufferTexture() = default;
BufferTexture::~BufferTexture() = default;

std::string BufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const void* data, std::size_t tuples, int components, int type)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (tuples > static_cast<std::size_t>(limit))
  {
    std::ostringstream text;
    text << tuples << " elements do not fit in a buffer texture of this OpenGL, which holds " << limit
         << "; distribute the data over more ranks, or draw fewer cells";
    return text.str();
  }
  this->Release(window);
  static const float zero[4] = { 0, 0, 0, 0 };
  const std::size_t size = std::max<std::size_t>(tuples, 1);
  const std::size_t bytes = size * components * (type == VTK_UNSIGNED_CHAR ? 1 : 4);
  this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
  this->Buffer->Upload(static_cast<const char*>(tuples > 0 ? data : zero), bytes, vtkOpenGLBufferObject::TextureBuffer);
  this->Texture->SetContext(window);
  if (type == VTK_INT) // which vtkTextureObject would not choose an integer format for
  {
    this->Texture->SetInternalFormat(components == 4 ? GL_RGBA32I : GL_R32I);
    this->Texture->SetFormat(components == 4 ? GL_RGBA_INTEGER : GL_RED_INTEGER);
  }
  this->Texture->CreateTextureBuffer(static_cast<unsigned int>(size), components, type, this->Buffer);
  return std::string();
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
