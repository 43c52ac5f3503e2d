// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CellCompositingPass.h"

#include "CellScene.h"
#include "SavedState.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace nephoscope
{
namespace
{
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

std::string CellCompositingPass::DrawLayer(vtkOpenGLRenderWindow* window, const FloatLayer::Painter& paint)
{
  this->Peeled = false;
  return this->Layer.Draw(window, paint);
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
    return FloatLayer::CheckOpenGL("while asking for a peel");
  }
  FloatLayer::SetBlending(window->GetState());
  CellDrawing drawing = { window, viewport, view, options, this->Buffers, this->Contours, this->Layer.GetDepth(), &this->Peel };
  const std::string error = this->UseRays ? this->CastRanges(drawing) : this->ProjectRanges(drawing);
  if (!error.empty())
  {
    return error;
  }
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  this->Peel.Deliver(window, request, viewport, this->Layer.GetAccumulation().GetTexture(0),
    this->UseRays ? this->SecondAccumulation.GetTexture(0) : this->Layer.GetAccumulation().GetTexture(1));
  return FloatLayer::CheckOpenGL("while peeling cells");
}

// Both ranges at once. A depth test spares the shader pixels without a range, and cells in front of the ranges.
std::string CellCompositingPass::ProjectRanges(CellDrawing& drawing)
{
  std::string error = noFloatImages;
  if (this->Layer.GetAccumulation().Begin(drawing.Window, drawing.Viewport, 2, this->Peel.GetNearestDepth()))
  {
    drawing.Window->GetState()->vtkglEnable(GL_DEPTH_TEST);
    drawing.Window->GetState()->vtkglDepthFunc(GL_GREATER);
    error = this->Projected.Draw(drawing);
  }
  this->Layer.GetAccumulation().End(drawing.Window);
  return error;
}

std::string CellCompositingPass::CastRanges(CellDrawing& drawing)
{
  std::string error;
  for (drawing.Range = 0; drawing.Range < 2 && error.empty(); ++drawing.Range)
  {
    FloatAccumulation& image = drawing.Range == 0 ? this->Layer.GetAccumulation() : this->SecondAccumulation;
    error = image.Begin(drawing.Window, drawing.Viewport) ? this->Rays.Draw(drawing) : noFloatImages;
    image.End(drawing.Window);
  }
  return error;
}

bool CellCompositingPass::CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image)
{
  return !this->Peeled && this->Layer.CopyTo(window, image);
}

void CellCompositingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffers.Release(window);
  this->Contours.Release(window);
  this->Projected.ReleaseGraphicsResources(window);
  this->Rays.ReleaseGraphicsResources(window);
  this->Layer.ReleaseGraphicsResources(window);
  this->SecondAccumulation.ReleaseGraphicsResources(window);
  this->Peel.ReleaseGraphicsResources(window);
}

} // namespace nephoscope
