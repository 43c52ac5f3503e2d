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

std::string CellCompositingPass::UploadGeometry(vtkOpenGLRenderWindow* window,
  const CellGeometry& geometry, const CellPieces& pieces, const TetrahedronNeighbors* neighbors)
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
  if (!this->UseRays)
  {
    this->Projected.UploadOrder(scene.GetDrawn());
    return std::string();
  }
  return this->Rays.UploadBoundary(window, scene.GetBoundaryFaces(), scene.GetGeometry(),
    scene.GetVisibleBox(), scene.GetOpacityFunction().LongestTransparentRange());
}

std::string CellCompositingPass::Draw(
  vtkOpenGLRenderWindow* window, const CellView& view, const CellDrawingOptions& options)
{
  int whole[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, whole);
  const PixelRegion region = this->Rays.FindRegion(view, *options.Eye, whole);
  const auto paint = [&](const int viewport[4], OpaqueDepth& opaqueDepth) {
    const CellDrawing drawing = { window, viewport, view, options, this->Buffers, this->Contours,
      opaqueDepth };
    return this->UseRays ? this->Rays.Draw(drawing) : this->Projected.Draw(drawing);
  };
  this->Peeled = false;
  return this->Layer.Draw(window, paint, this->UseRays ? &region : nullptr);
}

std::string CellCompositingPass::DrawLayer(
  vtkOpenGLRenderWindow* window, const FloatLayer::Painter& paint)
{
  this->Peeled = false;
  return this->Layer.Draw(window, paint);
}

std::string CellCompositingPass::DrawPeel(vtkOpenGLRenderWindow* window, const CellView& view,
  const CellDrawingOptions& options, const VolumePeel::Request& request)
{
  this->Peeled = true;
  if (!this->UseRays) // both ranges at once
  {
    return this->Layer.DrawPeel(window, this->Peel, request, [&](const int viewport[4]) {
      return this->Projected.Draw({ window, viewport, view, options, this->Buffers, this->Contours,
        this->Layer.GetDepth(), &this->Peel });
    });
  }
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const SavedState saved(window->GetState());
  if (!this->Peel.FindRanges(window, request, viewport))
  {
    return FloatLayer::CheckOpenGL("while asking for a peel");
  }
  FloatLayer::SetBlending(window->GetState());
  CellDrawing drawing = { window, viewport, view, options, this->Buffers, this->Contours,
    this->Layer.GetDepth(), &this->Peel };
  const std::string error = this->CastRanges(drawing);
  if (!error.empty())
  {
    return error;
  }
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  this->Peel.Deliver(window, request, viewport, this->Layer.GetAccumulation().GetTexture(0),
    this->SecondAccumulation.GetTexture(0));
  return FloatLayer::CheckOpenGL("while peeling cells");
}

std::string CellCompositingPass::CastRanges(CellDrawing& drawing)
{
  std::string error;
  for (drawing.Range = 0; drawing.Range < 2 && error.empty(); ++drawing.Range)
  {
    FloatAccumulation& image =
      drawing.Range == 0 ? this->Layer.GetAccumulation() : this->SecondAccumulation;
    error =
      image.Begin(drawing.Window, drawing.Viewport) ? this->Rays.Draw(drawing) : noFloatImages;
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
