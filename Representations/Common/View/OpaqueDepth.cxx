// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "OpaqueDepth.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

namespace nephoscope
{
namespace
{
GLint AttachmentParameter(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

// From the lower left pixel of a framebuffer's region to a region of the bound one, of the same
// size.
void BlitDepth(GLuint source, const int corner[2], const int region[4])
{
  GLint destination = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &destination);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  glBlitFramebuffer(corner[0], corner[1], corner[0] + region[2], corner[1] + region[3], region[0],
    region[1], region[0] + region[2], region[1] + region[3], GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(destination));
}

int DepthTextureFormat(int bits, int type)
{
  if (type == GL_FLOAT)
  {
    return vtkTextureObject::Float32;
  }
  return bits == 32 ? vtkTextureObject::Fixed32
    : bits == 16    ? vtkTextureObject::Fixed16
                    : vtkTextureObject::Fixed24;
}
}

OpaqueDepth::OpaqueDepth() = default;
OpaqueDepth::~OpaqueDepth() = default;

// glBlitFramebuffer copies depth between equal formats only: ask for that of the source.
// Attachments of the window system's framebuffer (binding 0) have other names than those of
// framebuffer objects.
OpaqueDepth::Format OpaqueDepth::DrawFramebufferFormat()
{
  GLint binding = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &binding);
  const GLenum depth = binding ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
  const GLenum stencil = binding ? GL_STENCIL_ATTACHMENT : GL_STENCIL;
  Format format;
  format.Bits = AttachmentParameter(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  format.Type = AttachmentParameter(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
  if (AttachmentParameter(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE)
  {
    format.StencilBits = AttachmentParameter(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
  }
  return format;
}

void OpaqueDepth::Allocate(
  vtkOpenGLRenderWindow* window, const Format& format, int width, int height)
{
  if (this->Whole.Texture->GetHandle() && this->AllocatedFormat == format &&
    this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  this->ReleaseGraphicsResources(window);
  this->Whole.Framebuffer->SetContext(window);
  this->AllocatedFormat = format;
  this->Size[0] = width;
  this->Size[1] = height;
  AllocateTexture(window, this->Whole.Texture, format, this->Size);
}

void OpaqueDepth::AllocateTexture(
  vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const Format& format, const int size[2])
{
  const unsigned int width = static_cast<unsigned int>(size[0]);
  const unsigned int height = static_cast<unsigned int>(size[1]);
  texture->SetContext(window);
  if (format.StencilBits > 0)
  {
    texture->AllocateDepthStencil(width, height);
  }
  else
  {
    texture->AllocateDepth(width, height, DepthTextureFormat(format.Bits, format.Type));
  }
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

void OpaqueDepth::Copy(vtkOpenGLRenderWindow* window, const int viewport[4], const int* region)
{
  const int width = viewport[2];
  const int height = viewport[3];
  this->IsCoarse = false;
  this->Allocate(window, DrawFramebufferFormat(), width, height);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST); // blits are scissored too
  state->vtkglDisable(GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDepthMask(GL_TRUE);

  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  const DepthSamples samples = DepthSamples::OfDrawFramebuffer();
  state->PushFramebufferBindings();
  this->Whole.Framebuffer->Bind();
  this->Whole.Framebuffer->AddDepthAttachment(this->Whole.Texture);
  const int whole[4] = { 0, 0, width, height };
  const int* part = region ? region : whole;
  const int corner[2] = { viewport[0] + part[0], viewport[1] + part[1] };
  if (samples.Texture)
  {
    this->Whole.Framebuffer->DeactivateDrawBuffers();
  }
  if (!samples.Texture || !this->Mean.Draw(window, samples, corner, part))
  {
    BlitDepth(static_cast<GLuint>(source), corner, part);
  }
  state->PopFramebufferBindings();
}

void OpaqueDepth::Fill(
  vtkOpenGLRenderWindow* window, Image& image, Image& source, int width, int height)
{
  const int size[2] = { width, height };
  vtkTextureObject* texture = image.Texture;
  if (!texture->GetHandle() || static_cast<int>(texture->GetWidth()) != width ||
    static_cast<int>(texture->GetHeight()) != height)
  {
    texture->ReleaseGraphicsResources(window);
    image.Framebuffer->ReleaseGraphicsResources(window); // keeps what is attached
    AllocateTexture(window, texture, this->AllocatedFormat, size);
    image.Framebuffer->SetContext(window);
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDepthMask(GL_TRUE);
  state->PushFramebufferBindings();
  source.Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  image.Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  image.Framebuffer->AddDepthAttachment(texture);
  glBlitFramebuffer(0, 0, static_cast<GLint>(source.Texture->GetWidth()),
    static_cast<GLint>(source.Texture->GetHeight()), 0, 0, width, height, GL_DEPTH_BUFFER_BIT,
    GL_NEAREST);
  state->PopFramebufferBindings();
}

void OpaqueDepth::Coarsen(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Fill(window, this->Coarse, this->Whole, width, height);
  this->IsCoarse = true;
}

vtkTextureObject* OpaqueDepth::Duplicate(vtkOpenGLRenderWindow* window)
{
  Image& source = this->IsCoarse ? this->Coarse : this->Whole;
  this->Fill(window, this->Second, source, static_cast<int>(source.Texture->GetWidth()),
    static_cast<int>(source.Texture->GetHeight()));
  return this->Second.Texture;
}

void OpaqueDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Image* image : { &this->Whole, &this->Coarse, &this->Second })
  {
    image->Framebuffer->ReleaseGraphicsResources(window);
    image->Texture->ReleaseGraphicsResources(window);
  }
  this->Mean.ReleaseGraphicsResources();
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
