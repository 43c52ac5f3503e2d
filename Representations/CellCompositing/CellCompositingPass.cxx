// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CellCompositingPass.h"

#include "CellScene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <sstream>

namespace nephoscope
{
namespace
{
std::string checkOpenGL(const char* where)
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
}

std::string CellCompositingPass::UploadGeometry(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const CellPieces& pieces,
  const TetrahedronNeighbors* neighbors)
{
  this->UseRays = neighbors != nullptr;
  const std::string error = this->Buffers.UploadGeometry(window, geometry, pieces);
  if (!error.empty())
  {
    return error;
  }
  return this->UseRays ? this->Rays.UploadGeometry(window, geometry, *neighbors)
                       : this->Projected.UploadGeometry(window, geometry, pieces);
}

std::string CellCompositingPass::UploadDrawn(vtkOpenGLRenderWindow* window, const CellScene& scene)
{
  return this->UseRays ? this->Rays.UploadBoundary(window, scene.GetBoundaryFaces(), scene.GetVisibleBox(),
                           scene.GetOpacityFunction().LongestTransparentRange())
                       : this->Projected.UploadOrder(window, scene.GetDrawn());
}

std::string CellCompositingPass::Draw(
  vtkOpenGLRenderWindow* window, const CellView& view, const CellDrawingOptions& options)
{
  vtkOpenGLState* state = window->GetState();
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  vtkOpenGLState::ScopedglScissor savedScissorBox(state);
  vtkOpenGLState::ScopedglEnableDisable savedScissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedCulling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  vtkOpenGLState::ScopedglDepthFunc savedDepthFunction(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate savedBlendFunction(state);

  this->Depth.Copy(window, viewport);
  std::string error;
  if (this->Accumulation.Begin(window, viewport))
  {
    state->vtkglDisable(GL_DEPTH_TEST); // the shaders end each ray at the opaque depth
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_BLEND);
    const CellDrawing drawing = { window, viewport, view, options, this->Buffers, this->Depth };
    error = this->UseRays ? this->Rays.Draw(drawing) : this->Projected.Draw(drawing);
  }
  else
  {
    error = "this OpenGL cannot draw into 32-bit float images";
  }
  this->Accumulation.End(window);
  if (error.empty())
  {
    this->Accumulation.Overlay(window, viewport);
    error = checkOpenGL("while compositing cells");
  }
  return error;
}

bool CellCompositingPass::CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image)
{
  return this->Accumulation.CopyTo(window, image);
}

void CellCompositingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.Release(window);
  this->Projected.ReleaseGraphicsResources(window);
  this->Rays.ReleaseGraphicsResources(window);
  this->Depth.ReleaseGraphicsResources(window);
  this->Accumulation.ReleaseGraphicsResources(window);
}

} // namespace nephoscope
