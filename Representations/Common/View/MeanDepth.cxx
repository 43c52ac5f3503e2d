// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "MeanDepth.h"

#include "MeanDepthFragment.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

namespace nephoscope
{
namespace
{
GLint DepthAttachment(GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, name, &value);
  return value;
}
}

DepthSamples DepthSamples::OfDrawFramebuffer()
{
  DepthSamples samples;
  GLint binding = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &binding);
  glGetIntegerv(GL_SAMPLES, &samples.Count);
  if (binding != 0 && samples.Count > 1 &&
    DepthAttachment(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_TEXTURE)
  {
    samples.Texture =
      static_cast<unsigned int>(DepthAttachment(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  }
  return samples;
}

MeanDepth::MeanDepth() = default;
MeanDepth::~MeanDepth() = default;

bool MeanDepth::Draw(vtkOpenGLRenderWindow* window, const DepthSamples& samples,
  const int corner[2], const int region[4])
{
  if (!this->Quad)
  {
    this->Quad.reset(new vtkOpenGLQuadHelper(window, nullptr, MeanDepthFragment, nullptr));
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  if (!program || !program->GetCompiled())
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglDepthFunc function(state);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  state->vtkglViewport(region[0], region[1], region[2], region[3]);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  const int unit = state->GetTextureUnitManager()->Allocate();
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples.Texture);
  program->SetUniformi("depths", unit);
  program->SetUniformi("numberOfSamples", samples.Count);
  program->SetUniform2i("corner", corner);
  const float size[2] = { static_cast<float>(region[2]), static_cast<float>(region[3]) };
  program->SetUniform2f("size", size);
  this->Quad->Render();
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  state->GetTextureUnitManager()->Free(unit);
  return true;
}

void MeanDepth::ReleaseGraphicsResources()
{
  this->Quad.reset();
}

} // namespace nephoscope
