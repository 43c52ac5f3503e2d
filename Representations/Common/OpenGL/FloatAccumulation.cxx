// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "FloatAccumulation.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace nephoscope
{
namespace
{
const char* overlayShader = "//VTK::System::Dec\n"
                            "//VTK::Output::Dec\n"
                            "in vec2 texCoord;\n"
                            "uniform sampler2D accumulated;\n"
                            "void main() { gl_FragData[0] = texture(accumulated, texCoord); }\n";
}

FloatAccumulation::FloatAccumulation() = default;
FloatAccumulation::~FloatAccumulation() = default;

void FloatAccumulation::Allocate(vtkOpenGLRenderWindow* window, int width, int height, int layers)
{
  if (this->Size[0] != width || this->Size[1] != height)
  {
    this->ReleaseGraphicsResources(window);
    this->Framebuffer->SetContext(window);
    this->Size[0] = width;
    this->Size[1] = height;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    vtkTextureObject* color = this->Colors[layer];
    if (!color->GetHandle())
    {
      color->SetContext(window);
      color->Allocate2D(width, height, 4, VTK_FLOAT);
      color->SetMinificationFilter(vtkTextureObject::Nearest);
      color->SetMagnificationFilter(vtkTextureObject::Nearest);
    }
  }
}

bool FloatAccumulation::Begin(vtkOpenGLRenderWindow* window, const int viewport[4], int layers,
  vtkTextureObject* depth, Content content, int first)
{
  this->Allocate(window, viewport[2], viewport[3], first + layers);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->RemoveDepthAttachment();
  this->Attach(first, layers);
  if (depth)
  {
    this->SetDepth(depth);
  }
  state->vtkglViewport(0, 0, viewport[2], viewport[3]);
  state->vtkglDisable(GL_SCISSOR_TEST);
  const float transparent[4] = { 0, 0, 0, 0 };
  for (int layer = 0; layer < layers && content == Clear; ++layer)
  {
    glClearBufferfv(GL_COLOR, layer, transparent);
  }
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void FloatAccumulation::Attach(int first, int layers)
{
  GLenum buffers[MostLayers];
  for (int layer = 0; layer < MostLayers; ++layer)
  {
    const auto number = static_cast<unsigned int>(layer);
    buffers[layer] = GL_COLOR_ATTACHMENT0 + number;
    layer < layers ? this->Framebuffer->AddColorAttachment(number, this->Colors[first + layer])
                   : this->Framebuffer->RemoveColorAttachment(number);
  }
  this->Framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(layers));
  // vtkOpenGLState skips this call when the framebuffer that was bound before had as many draw
  // buffers.
  glDrawBuffers(layers, buffers);
}

void FloatAccumulation::SetDepth(vtkTextureObject* depth)
{
  this->Framebuffer->AddDepthAttachment(depth);
}

void FloatAccumulation::End(vtkOpenGLRenderWindow* window)
{
  window->GetState()->PopFramebufferBindings();
}

void FloatAccumulation::Overlay(vtkOpenGLRenderWindow* window, const int viewport[4])
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (!this->Quad)
  {
    this->Quad.reset(new vtkOpenGLQuadHelper(window, nullptr, overlayShader, nullptr));
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  const bool coarse = this->Size[0] != viewport[2] || this->Size[1] != viewport[3];
  this->Colors[0]->SetMagnificationFilter(
    coarse ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
  this->Colors[0]->Activate();
  this->Quad->Program->SetUniformi("accumulated", this->Colors[0]->GetTextureUnit());
  this->Quad->Render();
  this->Colors[0]->Deactivate();
}

bool FloatAccumulation::CopyTo(vtkOpenGLRenderWindow* window, vtkImageData* image)
{
  if (!this->Colors[0]->GetHandle())
  {
    return false;
  }
  window->MakeCurrent();
  image->SetDimensions(this->Size[0], this->Size[1], 1);
  image->SetSpacing(1, 1, 1);
  image->SetOrigin(0, 0, 0);
  vtkNew<vtkFloatArray> rgba;
  rgba->SetName("RGBA");
  rgba->SetNumberOfComponents(4);
  rgba->SetNumberOfTuples(vtkIdType(this->Size[0]) * this->Size[1]);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, this->Size[0], this->Size[1], GL_RGBA, GL_FLOAT, rgba->GetPointer(0));
  state->PopFramebufferBindings();
  image->GetPointData()->SetScalars(rgba);
  return true;
}

void FloatAccumulation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Framebuffer->ReleaseGraphicsResources(window);
  for (auto& color : this->Colors)
  {
    color->ReleaseGraphicsResources(window);
  }
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
