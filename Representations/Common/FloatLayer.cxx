// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "FloatLayer.h"

#include "SavedState.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <sstream>

namespace nephoscope
{
namespace
{
const char* const noFloatImages = "this OpenGL cannot draw into 32-bit float images";
}

void FloatLayer::SetBlending(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

std::string FloatLayer::CheckOpenGL(const char* where)
{
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR)
  {
    return std::string();
  }
  std::ostringstream text;
  text << "OpenGL error 0x" << std::hex << error << " " << where;
  return text.str();
}

std::string FloatLayer::Draw(
  vtkOpenGLRenderWindow* window, const Painter& paint, const PixelRegion* region)
{
  int viewport[4];
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const auto cutOff = [&](int x, int y) {
    if (region)
    {
      state->vtkglEnable(GL_SCISSOR_TEST);
      state->vtkglScissor(x + (*region)[0], y + (*region)[1], (*region)[2], (*region)[3]);
    }
  };
  const SavedState saved(window->GetState());
  this->Depth.Copy(window, viewport, region ? region->data() : nullptr);
  std::string error = noFloatImages;
  if (this->Accumulation.Begin(window, viewport))
  {
    SetBlending(state);
    cutOff(0, 0);
    error = paint(viewport, this->Depth);
  }
  this->Accumulation.End(window);
  if (error.empty())
  {
    cutOff(viewport[0], viewport[1]);
    this->Accumulation.Overlay(window, viewport);
    error = CheckOpenGL("while drawing translucent layers");
  }
  return error;
}

std::string FloatLayer::DrawPeel(vtkOpenGLRenderWindow* window, VolumePeel& peel,
  const VolumePeel::Request& request,
  const std::function<std::string(const int viewport[4])>& paint)
{
  int viewport[4];
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const SavedState saved(state);
  if (!peel.FindRanges(window, request, viewport))
  {
    return CheckOpenGL("while asking for a peel");
  }
  std::string error = noFloatImages;
  if (this->Accumulation.Begin(window, viewport, 2, peel.GetNearestDepth()))
  {
    SetBlending(state);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_GREATER);
    error = paint(viewport);
  }
  this->Accumulation.End(window);
  if (!error.empty())
  {
    return error;
  }
  state->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  peel.Deliver(
    window, request, viewport, this->Accumulation.GetTexture(0), this->Accumulation.GetTexture(1));
  return CheckOpenGL("while peeling");
}

void FloatLayer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depth.ReleaseGraphicsResources(window);
  this->Accumulation.ReleaseGraphicsResources(window);
}

} // namespace nephoscope
