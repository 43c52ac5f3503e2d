// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CellCompositingPass.h"

#include "CellScene.h"
#include "SavedState.h"

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

void setBlending(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_DEPTH_TEST); // the shaders end each ray at the opaque depth
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
}

const char* const noFloatImages = "this OpenGL cannot draw into 32-bit float images";
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
  return this->DrawLayer(window, [&](const int viewport[4], OpaqueDepth& opaqueDepth) {
    const CellDrawing drawing = { window, viewport, view, options, this->Buffers, this->Contours, opaqueDepth };
    return this->UseRays ? this->Rays.Draw(drawing) : this->Projected.Draw(drawing);
  });
}

std::string CellCompositingPass::DrawLayer(vtkOpenGLRenderWindow* window, const Layer& layer)
{
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const SavedState saved(window->GetState());
  this->Peeled = false;
  this->Depth.Copy(window, viewport);
  std::string error;
  if (this->Accumulation.Begin(window, viewport))
  {
    setBlending(window->GetState());
    error = layer(viewport, this->Depth);
  }
  else
  {
    error = noFloatImages;
  }
  this->Accumulation.End(window);
  if (error.empty())
  {
    this->Accumulation.Overlay(window, viewport);
    error = checkOpenGL("while compositing cells");
  }
  return error;
}

std::string CellCompositingPass::DrawPeel(vtkOpenGLRenderWindow* window, const CellView& view,
  const CellDrawingOptions& options, const VolumePeel::Request& request)
{
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const SavedState saved(window->GetState());
  this->Peeled = true;
  if (!this->Peel.FindRanges(window, request, viewport))
  {
    return checkOpenGL("while asking for a peel");
  }
  setBlending(window->GetState());
  CellDrawing drawing = { window, viewport, view, options, this->Buffers, this->Contours, this->Depth, &this->Peel };
  const std::string error = this->UseRays ? this->CastRanges(drawing) : this->ProjectRanges(drawing);
  if (!error.empty())
  {
    return error;
  }
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  this->Peel.Deliver(window, request, viewport, this->Accumulation.GetTexture(0),
    this->UseRays ? this->SecondAccumulation.GetTexture(0) : this->Accumulation.GetTexture(1));
  return checkOpenGL("while peeling cells");
}

// Both ranges at once. A depth test spares the shader pixels without a range, and cells in front of the ranges.
std::string CellCompositingPass::ProjectRanges(CellDrawing& drawing)
{
  std::string error = noFloatImages;
  if (this->Accumulation.Begin(drawing.Window, drawing.Viewport, 2, this->Peel.GetNearestDepth()))
  {
    drawing.Window->GetState()->vtkglEnable(GL_DEPTH_TEST);
    drawing.Window->GetState()->vtkglDepthFunc(GL_GREATER);
    error = this->Projected.Draw(drawing);
  }
  this->Accumulation.End(drawing.Window);
  return error;
}

std::string CellCompositingPass::CastRanges(CellDrawing& drawing)
{
  std::string error;
  for (drawing.Range = 0; drawing.Range < 2 && error.empty(); ++drawing.Range)
  {
    FloatAccumulation& image = drawing.Range == 0 ? this->Accumulation : this->SecondAccumulation;
    error = image.Begin(drawing.Window, drawing.Viewport) ? this->Rays.Draw(drawing) : noFloatImages;
    image.End(drawing.Window);
  }
  return error;
}

bool CellCompositingPass::CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image)
{
  return !this->Peeled && this->Accumulation.CopyTo(window, image);
}

void CellCompositingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.Release(window);
  this->Contours.Release(window);
  this->Projected.ReleaseGraphicsResources(window);
  this->Rays.ReleaseGraphicsResources(window);
  this->Depth.ReleaseGraphicsResources(window);
  this->Accumulation.ReleaseGraphicsResources(window);
  this->SecondAccumulation.ReleaseGraphicsResources(window);
  this->Peel.ReleaseGraphicsResources(window);
}

} // namespace nephoscope
