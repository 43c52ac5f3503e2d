// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "FloatLayer.h"

#include "SavedState.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nephoscope
{
namespace
{
const char* const noFloatImages = "this OpenGL cannot draw into 32-bit float images";

/** A viewport at the origin with fewer pixels. */
std::array<int, 4> CoarseViewport(const int viewport[4], double sampleDistance)
{
  const auto fewer = [&](int pixels) {
    return std::max(static_cast<int>(std::ceil(pixels / sampleDistance)), 1);
  };
  return { { 0, 0, fewer(viewport[2]), fewer(viewport[3]) } };
}

/** The pixels that a region of the viewport covers, and those next to them. */
PixelRegion CoarseRegion(
  const PixelRegion& region, const int viewport[4], const std::array<int, 4>& coarse)
{
  PixelRegion covered;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const int size = coarse[2 + axis];
    const double scale = double(size) / viewport[2 + axis];
    const int first = static_cast<int>(std::floor(scale * region[axis])) - 1;
    const int end = static_cast<int>(std::ceil(scale * (region[axis] + region[2 + axis]))) + 1;
    covered[axis] = std::max(first, 0);
    covered[2 + axis] = region[2 + axis] > 0 ? std::min(end, size) - covered[axis] : 0;
  }
  return covered;
}
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

void FloatLayer::ForgetErrors()
{
  constexpr int most = 16; // without a context there is no end to them
  for (int i = 0; i < most && glGetError() != GL_NO_ERROR; ++i)
  {
  }
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

std::string FloatLayer::Draw(vtkOpenGLRenderWindow* window, const Painter& paint,
  const PixelRegion* region, double sampleDistance)
{
  int viewport[4];
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const auto cutOff = [&](const PixelRegion& part, int x, int y) {
    if (region)
    {
      state->vtkglEnable(GL_SCISSOR_TEST);
      state->vtkglScissor(x + part[0], y + part[1], part[2], part[3]);
    }
  };
  const PixelRegion part = region ? *region : PixelRegion{ { 0, 0, viewport[2], viewport[3] } };
  std::array<int, 4> painted = { { viewport[0], viewport[1], viewport[2], viewport[3] } };
  PixelRegion paintedPart = part;
  ForgetErrors();
  const SavedState saved(window->GetState());
  this->Depth.Copy(window, viewport, region ? region->data() : nullptr);
  if (sampleDistance > 1)
  {
    painted = CoarseViewport(viewport, sampleDistance);
    paintedPart = CoarseRegion(part, viewport, painted);
    this->Depth.Coarsen(window, painted[2], painted[3]);
  }
  std::string error = noFloatImages;
  if (this->Accumulation.Begin(window, painted.data()))
  {
    SetBlending(state);
    cutOff(paintedPart, 0, 0);
    error = paint(painted.data(), this->Depth);
  }
  this->Accumulation.End(window);
  if (error.empty())
  {
    cutOff(part, viewport[0], viewport[1]);
    this->Accumulation.Overlay(window, viewport);
    error = CheckOpenGL("while drawing translucent layers");
  }
  return error;
}

std::string FloatLayer::DrawPeel(vtkOpenGLRenderWindow* window, VolumePeel& peel,
  const VolumePeel::Request& request,
  const std::function<std::string(const int viewport[4])>& paint, VolumePeel::DepthTest test)
{
  int viewport[4];
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  ForgetErrors();
  const SavedState saved(state);
  if (!peel.FindRanges(window, request, viewport, test))
  {
    return CheckOpenGL("while asking for a peel");
  }
  std::string error = noFloatImages;
  if (this->Accumulation.Begin(window, viewport, 2, peel.GetDepth()))
  {
    SetBlending(state);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(test == VolumePeel::Farthest ? GL_LESS : GL_GREATER);
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

void FloatLayer::HideBehindOpaque(vtkOpenGLRenderWindow* window)
{
  this->Accumulation.SetDepth(this->Depth.Duplicate(window));
  window->GetState()->vtkglEnable(GL_DEPTH_TEST);
  window->GetState()->vtkglDepthFunc(GL_LEQUAL);
}

void FloatLayer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depth.ReleaseGraphicsResources(window);
  this->Accumulation.ReleaseGraphicsResources(window);
}

} // namespace nephoscope
