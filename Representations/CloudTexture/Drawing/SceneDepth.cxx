// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "SceneDepth.h"

#include "PeelingPass.h"
#include "SavedState.h"

#include "vtkAbstractMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace nephoscope
{
namespace
{
// The name is the one that the peeling pass sets: minus one and depth; minus one twice where there
// is nothing opaque.
const char* const depthShader =
  "//VTK::System::Dec\n"
  "in vec2 texCoord;\n"
  "uniform sampler2D opaqueDepth;\n"
  "void main()\n"
  "{\n"
  "  float depth = texelFetch(opaqueDepth, ivec2(texCoord * vec2(textureSize(opaqueDepth, 0))), 0).y;\n"
  "  gl_FragDepth = depth < 0.0 ? 1.0 : depth;\n"
  "}\n";

// The first stage has two draw buffers, those that follow have three or one.
constexpr unsigned int buffersOfFirstStage = 2;
}

SceneDepth::SceneDepth() = default;
SceneDepth::~SceneDepth() = default;

bool SceneDepth::IsTold(vtkProp* prop)
{
  vtkDualDepthPeelingPass* pass = PeelingPass(prop);
  return !pass || pass->GetActiveDrawBuffers() == buffersOfFirstStage;
}

vtkTextureObject* SceneDepth::Find(const Request& request)
{
  if (!PeelingPass(request.Prop))
  {
    this->Buffer.Copy(request.Window, request.Viewport);
    return this->Buffer.GetTexture();
  }
  this->Allocate(request);
  return this->AskPass(request) ? this->Asked.Get() : nullptr;
}

void SceneDepth::Allocate(const Request& request)
{
  const int* size = request.Viewport + 2;
  if (this->Asked->GetHandle() && this->Size[0] == size[0] && this->Size[1] == size[1])
  {
    return;
  }
  this->ReleaseGraphicsResources(request.Window);
  this->Framebuffer->SetContext(request.Window);
  this->Asked->SetContext(request.Window);
  this->Asked->AllocateDepth(size[0], size[1], vtkTextureObject::Float32);
  this->Asked->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Asked->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Size[0] = size[0];
  this->Size[1] = size[1];
}

bool SceneDepth::AskPass(const Request& request)
{
  vtkOpenGLState* state = request.Window->GetState();
  const SavedState saved(state);
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddDepthAttachment(this->Asked);
  this->Framebuffer->DeactivateDrawBuffers();
  state->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  if (!this->Quad)
  {
    this->Quad.reset(new vtkOpenGLQuadHelper(request.Window, nullptr, depthShader, nullptr));
  }
  else
  {
    request.Window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  if (program)
  {
    PeelingPass(request.Prop)->SetShaderParameters(program, request.Mapper, request.Prop);
    this->Quad->Render();
  }
  state->PopFramebufferBindings();
  return program != nullptr;
}

void SceneDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffer.ReleaseGraphicsResources(window);
  this->Quad.reset();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Asked->ReleaseGraphicsResources(window);
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
