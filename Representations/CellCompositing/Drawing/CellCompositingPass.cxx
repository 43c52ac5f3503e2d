// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CellCompositingPass.h"

#include "CellScene.h"
#include "SavedState.h"
#include "VolumeSlices.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <deque>

namespace nephoscope
{
namespace
{
const char* const noFloatImages = "this OpenGL cannot draw into 32-bit float images";
}

std::string CellCompositingPass::UploadGeometry(vtkOpenGLRenderWindow* window,
  const CellGeometry& geometry, const TetrahedronNeighbors* neighbors)
{
  this->UseRays = neighbors != nullptr;
  const std::string error = this->Buffers.UploadGeometry(window, geometry);
  if (!error.empty())
  {
    return error;
  }
  return this->UseRays ? this->Rays.UploadGeometry(window, geometry, *neighbors)
                       : this->Projected.UploadGeometry(window, geometry);
}

std::string CellCompositingPass::UploadContours(
  vtkOpenGLRenderWindow* window, const CellScene& scene)
{
  const std::string error = this->Contours.Upload(window, scene.GetContours());
  return error.empty() && this->UseRays
    ? this->Rays.UploadContoured(window, scene.GetGeometry(), scene.GetContours().Scalars)
    : error;
}

std::string CellCompositingPass::UploadDrawn(vtkOpenGLRenderWindow* window, const CellScene& scene)
{
  if (!this->UseRays)
  {
    this->Projected.UploadOrder(scene.GetDrawn());
    return std::string();
  }
  const std::string error =
    this->Rays.UploadBoundary(window, scene.GetBoundaryFaces(), scene.GetGeometry(),
      scene.GetVisibleBox(), scene.GetOpacityFunction().LongestTransparentRange());
  return error.empty() ? this->Rays.UploadVoxels(window, scene.GetGeometry(), scene.GetVisibleBox(),
                           scene.GetClearDistances())
                       : error;
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
  return this->Layer.Draw(window, paint, this->UseRays ? &region : nullptr,
    this->UseRays ? options.ImageSampleDistance : 1);
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
  return this->CastPeel(window, request, [&](const int viewport[4], VolumePeel* peel, int range) {
    return this->Rays.Draw({ window, viewport, view, options, this->Buffers, this->Contours,
      this->Layer.GetDepth(), peel, range });
  });
}

std::string CellCompositingPass::CastPeel(
  vtkOpenGLRenderWindow* window, const VolumePeel::Request& request, const Caster& cast)
{
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  FloatLayer::ForgetErrors();
  const SavedState saved(window->GetState());
  if (!this->Peel.FindRanges(window, request, viewport))
  {
    return FloatLayer::CheckOpenGL("while asking for a peel");
  }
  FloatLayer::SetBlending(window->GetState());
  VolumeSlices* slices = VolumeSlices::GetCurrent();
  const std::string error = slices
    ? slices->DrawAtOnce(window, [&]() { return cast(viewport, &this->Peel, 0); })
    : this->CastRanges(window, viewport, cast);
  if (slices || !error.empty())
  {
    return error;
  }
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  this->Peel.Deliver(window, request, viewport, this->Layer.GetAccumulation().GetTexture(0),
    this->SecondAccumulation.GetTexture(0));
  return FloatLayer::CheckOpenGL("while peeling cells");
}

std::string CellCompositingPass::CastRanges(
  vtkOpenGLRenderWindow* window, const int viewport[4], const Caster& cast)
{
  std::string error;
  for (int range = 0; range < 2 && error.empty(); ++range)
  {
    FloatAccumulation& image =
      range == 0 ? this->Layer.GetAccumulation() : this->SecondAccumulation;
    error = image.Begin(window, viewport) ? cast(viewport, &this->Peel, range) : noFloatImages;
    image.End(window);
  }
  return error;
}

std::string CellCompositingPass::CastMedia(vtkOpenGLRenderWindow* window,
  const std::vector<Medium>& media, const int viewport[4], VolumePeel* peel, int range)
{
  std::deque<CellDrawing> drawings; // nothing moves that is in it
  std::vector<RayMedia::Medium> rays;
  for (const Medium& medium : media)
  {
    drawings.push_back({ window, viewport, *medium.View, *medium.Options, medium.Pass->Buffers,
      medium.Pass->Contours, this->Layer.GetDepth(), peel, range });
    rays.push_back({ &medium.Pass->Rays, &drawings.back() });
  }
  return this->Media.Draw(rays);
}

bool CellCompositingPass::CanDrawMedia(const std::vector<Medium>& media)
{
  std::vector<RayMedia::Medium> rays;
  for (const Medium& medium : media)
  {
    rays.push_back({ &medium.Pass->Rays, nullptr, medium.Pass->Buffers.CountTextures() });
  }
  return RayMedia::HasEnoughTextures(rays);
}

std::string CellCompositingPass::DrawMedia(
  vtkOpenGLRenderWindow* window, const std::vector<Medium>& media)
{
  int whole[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, whole);
  PixelRegion region = { { 0, 0, 0, 0 } };
  for (const Medium& medium : media)
  {
    medium.Pass->Peeled = true; // it has no image of its own
    region =
      UnionOf(region, medium.Pass->Rays.FindRegion(*medium.View, *medium.Options->Eye, whole));
  }
  this->Peeled = false;
  const auto paint = [&](const int viewport[4], OpaqueDepth&) {
    return this->CastMedia(window, media, viewport, nullptr, 0);
  };
  return this->Layer.Draw(window, paint, &region, media.front().Options->ImageSampleDistance);
}

std::string CellCompositingPass::DrawMediaPeel(vtkOpenGLRenderWindow* window,
  const std::vector<Medium>& media, const VolumePeel::Request& request)
{
  for (const Medium& medium : media)
  {
    medium.Pass->Peeled = true;
  }
  return this->CastPeel(window, request, [&](const int viewport[4], VolumePeel* peel, int range) {
    return this->CastMedia(window, media, viewport, peel, range);
  });
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
  this->Media.ReleaseGraphicsResources(window);
  this->Layer.ReleaseGraphicsResources(window);
  this->SecondAccumulation.ReleaseGraphicsResources(window);
  this->Peel.ReleaseGraphicsResources(window);
}

} // namespace nephoscope
