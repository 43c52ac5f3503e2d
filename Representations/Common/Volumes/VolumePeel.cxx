// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "VolumePeel.h"

#include "DrawnQuery.h"
#include "PeelLightFragment.h"
#include "PeelRangesFragment.h"
#include "PeelingPass.h"
#include "VolumeSlices.h"
#include "WholeViewport.h"

#include "vtkAbstractMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

namespace nephoscope
{
namespace
{
// The pass ends with the first peel that puts nothing into the back. In front of opaque geometry
// only the frontmost surface has been peeled by then: two ranges that end at the opaque depth say
// that there are more. The least alpha keeps it going.
const char* const keepPeeling =
  "  if (calls == 2 && lastFar >= texelFetch(opaqueDepthTex, pixel, 0).x)\n"
  "  {\n"
  "    gl_FragData[0].a = max(gl_FragData[0].a, smallestAlpha);\n"
  "  }\n";

void AllocateColor(
  vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height, int type)
{
  texture->SetContext(window);
  texture->Allocate2D(width, height, 4, type);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}
}

VolumePeel::VolumePeel() = default;
VolumePeel::~VolumePeel() = default;

bool VolumePeel::IsRequested(vtkProp* volume)
{
  return VolumeSlices::GetCurrent() || PeelingPass(volume) != nullptr;
}

void VolumePeel::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (this->Ranges->GetHandle() && this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  this->ReleaseGraphicsResources(window);
  this->Framebuffer->SetContext(window);
  AllocateColor(this->Ranges, window, width, height, VTK_FLOAT);
  for (auto& target : this->Targets)
  {
    AllocateColor(target, window, width, height, VTK_UNSIGNED_CHAR);
  }
  this->Depth->SetContext(window);
  this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  this->Size[0] = width;
  this->Size[1] = height;
}

// The passes complete the shader anew at every stage; the window's cache keeps a program for each.
vtkShaderProgram* VolumePeel::ReadyProgram(
  vtkOpenGLRenderWindow* window, const Request& request, const int viewport[4], const char* shader)
{
  std::string vertex = wholeViewportVertex, geometry, fragment = shader;
  ForEachPass(request.Volume, [&](vtkOpenGLRenderPass* pass) {
    pass->PreReplaceShaderValues(vertex, geometry, fragment, request.Mapper, request.Volume);
  });
  ForEachPass(request.Volume, [&](vtkOpenGLRenderPass* pass) {
    pass->PostReplaceShaderValues(vertex, geometry, fragment, request.Mapper, request.Volume);
  });
  const bool peelsInFrontOfOpaque = fragment.find("opaqueDepthTex") != std::string::npos;
  vtkShaderProgram::Substitute(
    fragment, "//NEPHOSCOPE::KeepPeeling", peelsInFrontOfOpaque ? keepPeeling : "");
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), fragment.c_str(), geometry.c_str());
  if (program)
  {
    ForEachPass(request.Volume, [&](vtkOpenGLRenderPass* pass) {
      pass->SetShaderParameters(program, request.Mapper, request.Volume);
    });
    const float inverseSize[2] = { 1.0f / viewport[2], 1.0f / viewport[3] };
    program->SetUniform2f("in_inverseWindowSize", inverseSize);
  }
  return program;
}

bool VolumePeel::FindRanges(
  vtkOpenGLRenderWindow* window, const Request& request, const int viewport[4], DepthTest test)
{
  this->Allocate(window, viewport[2], viewport[3]);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Ranges);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  const bool any = this->DrawRanges(window, request, viewport, test);
  state->PopFramebufferBindings();
  return any;
}

bool VolumePeel::DrawRanges(
  vtkOpenGLRenderWindow* window, const Request& request, const int viewport[4], DepthTest test)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedCulling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable savedScissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglDepthMask savedMask(state);
  vtkOpenGLState::ScopedglDepthFunc savedFunction(state);
  state->vtkglViewport(0, 0, viewport[2], viewport[3]);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglEnable(GL_DEPTH_TEST); // without it no depth is written
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  const float empty[4] = { 1, 0, 1, 0 };
  const float nothingPasses = test == Farthest ? 0 : 1;
  glClearBufferfv(GL_COLOR, 0, empty);
  glClearBufferfv(GL_DEPTH, 0, &nothingPasses);
  VolumeSlices* slices = VolumeSlices::GetCurrent();
  if (!(slices ? slices->ReadyRanges(window, test == Farthest)
               : this->ReadyProgram(window, request, viewport, PeelRangesFragment)))
  {
    return false;
  }
  DrawnQuery query;
  DrawWholeViewport(this->VertexArray);
  return query.End();
}

// Light is mixed with what the targets hold in the shader: the pass leaves them with GL_MAX, and
// blending in 8 bits would round once more.
void VolumePeel::CopyTargets(vtkOpenGLRenderWindow* window, unsigned int count)
{
  vtkOpenGLState* state = window->GetState();
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  state->PushReadFramebufferBinding();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(target));
  for (unsigned int i = 0; i < count; ++i)
  {
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0 + i);
    this->Targets[i]->Activate();
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, this->Size[0], this->Size[1]);
    this->Targets[i]->Deactivate();
  }
  state->PopReadFramebufferBinding();
}

void VolumePeel::Deliver(vtkOpenGLRenderWindow* window, const Request& request,
  const int viewport[4], vtkTextureObject* firstLight, vtkTextureObject* secondLight)
{
  if (VolumeSlices* slices = VolumeSlices::GetCurrent())
  {
    slices->Take(window, { firstLight, secondLight });
    return;
  }
  this->CopyTargets(window, std::min(2u, PeelingPass(request.Volume)->GetActiveDrawBuffers()));
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedCulling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  vtkShaderProgram* program = this->ReadyProgram(window, request, viewport, PeelLightFragment);
  if (!program)
  {
    return;
  }
  vtkTextureObject* textures[4] = { firstLight, secondLight, this->Targets[0], this->Targets[1] };
  const char* names[4] = { "firstLight", "secondLight", "oldBack", "oldFront" };
  for (int i = 0; i < 4; ++i)
  {
    textures[i]->Activate();
    program->SetUniformi(names[i], textures[i]->GetTextureUnit());
  }
  DrawWholeViewport(this->VertexArray);
  for (vtkTextureObject* texture : textures)
  {
    texture->Deactivate();
  }
}

void VolumePeel::ReleaseGraphicsResources(vtkWindow* window)
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Ranges->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  for (auto& target : this->Targets)
  {
    target->ReleaseGraphicsResources(window);
  }
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
