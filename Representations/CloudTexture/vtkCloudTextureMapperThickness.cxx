// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Thickness of clouds: the faces behind every pixel, the density volume, the extinction.
#include "OpenGLFunctions.h"

#include "CloudShaderCode.h"
#include "DataSets.h"
#include "vtkCloudTextureMapperInternals.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace
{
const std::string cutWays =
  "Some rays cross more small cells of the density volume than this OpenGL allows: they miss a part of "
  "the cloud. Resample the volume to an image, as with vtkResampleToImage.";
const std::string moreClouds = "In some pixels more clouds lie behind one another than the ";

std::string BoundsText(const vtkBoundingBox& box)
{
  std::ostringstream text;
  text.precision(4);
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis > 0 ? ", " : "") << "xyz"[axis] << " = " << box.GetBound(2 * axis) << " to "
         << box.GetBound(2 * axis + 1);
  }
  return text.str();
}
}

void vtkCloudTextureMapper::SetDensityArrayName(const char* name)
{
  this->SetName(this->DensityArrayName, name);
}

void vtkCloudTextureMapper::SetDensityVolume(vtkDataObject* volume)
{
  if (this->DensityVolume != volume)
  {
    this->DensityVolume = volume;
    this->Modified();
  }
}

vtkDataObject* vtkCloudTextureMapper::GetDensityVolume() const
{
  return this->DensityVolume;
}

void vtkCloudTextureMapper::PrepareVolume()
{
  vtkInternals& own = *this->Internals;
  vtkDataObject* data = this->UseThickness ? this->DensityVolume.Get() : nullptr;
  const decltype(own.VolumeMadeFrom) key(
    data, nephoscope::NewestMTime(data), this->DensityArrayName);
  if (key == own.VolumeMadeFrom)
  {
    return;
  }
  own.VolumeMadeFrom = key;
  std::string error;
  own.Volume = nephoscope::MakeDensityVolume(data, this->DensityArrayName, error);
  own.VolumeBounds =
    own.Volume ? nephoscope::BoundsOf(nephoscope::DataSetsOf(data)) : vtkBoundingBox();
  this->Modified(); // the shader depends on it
  this->TellVolume(error, own.Volume ? own.Volume->Warning : "");
}

// A volume on a map and a surface on a globe, for example, or one in km and the other in m.
void vtkCloudTextureMapper::WarnOfPlace()
{
  vtkInternals& own = *this->Internals;
  vtkPolyData* surface = own.Surface.Surface;
  const vtkBoundingBox clouds = surface && surface->GetNumberOfPoints() > 0
    ? vtkBoundingBox(surface->GetBounds())
    : vtkBoundingBox();
  const bool isElsewhere = own.Volume && clouds.IsValid() && own.VolumeBounds.IsValid() &&
    !clouds.Intersects(own.VolumeBounds);
  if (isElsewhere && !own.IsElsewhere)
  {
    vtkWarningMacro(
      << "The density volume is not where the surface is, so the clouds have no density: the surface is at "
      << BoundsText(clouds) << ", the volume at " << BoundsText(own.VolumeBounds)
      << ". Give both the same coordinates and the same unit of length, or make the surface from the volume by Cloud Surface.");
  }
  own.IsElsewhere = isElsewhere;
}

void vtkCloudTextureMapper::UploadVolume(vtkRenderer* renderer)
{
  vtkInternals& own = *this->Internals;
  const std::string error = own.Volume
    ? own.Volume->Upload(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
    : std::string();
  if (!error.empty())
  {
    own.Volume = nullptr;
    this->TellVolume(error, "");
    this->Modified(); // the shader is one without it
  }
}

void vtkCloudTextureMapper::TellVolume(const std::string& error, const std::string& warning)
{
  std::string& last = this->Internals->LastVolume;
  if (!error.empty() && error != last)
  {
    vtkErrorMacro(<< "Clouds are drawn with the same density everywhere: the density volume "
                  << error << ".");
  }
  if (!warning.empty() && warning != last)
  {
    vtkWarningMacro(<< "The density volume " << warning << ".");
  }
  last = error + warning;
}

void vtkCloudTextureMapper::FindThickness(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& own = *this->Internals;
  own.Drawings = nephoscope::CloudThicknessPass::LimitDrawings(
    this->MaximumNumberOfLayers, own.Surface.HasDensity);
  nephoscope::CloudThicknessPass::Request request;
  request.Scene.Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  request.Scene.Mapper = this;
  request.Scene.Prop = actor;
  request.Scene.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, request.Scene.Viewport);
  request.Renderer = renderer;
  request.Actor = actor;
  std::copy_n(own.Surface.Center, 3, request.Center);
  own.Surface.Surface->GetBounds(request.Bounds);
  for (int i = 0; i < 6; ++i)
  {
    request.Bounds[i] -= request.Center[i / 2];
  }
  request.IsClosed = own.Surface.Chord.IsClosed();
  request.IsInsideOut = own.Surface.Chord.IsInsideOut();
  request.WithDensities = own.Surface.HasDensity;
  request.Clouds = this->MaximumNumberOfLayers;
  request.Volume = own.Volume.get();
  request.Extinction = this->GetExtinctionInUse(actor);
  request.EnoughOpticalDepth = this->GetEnoughOpticalDepth();
  request.Constants = nephoscope::LayerConstants(own.Surface);
  request.DrawTriangles = [&](vtkOpenGLHelper& helper) {
    this->DrawTriangles(helper, renderer, actor);
  };
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE || renderer->GetSelector())
  {
    own.Thickness.Forget(
      request); // lines and points have none, and who asks what is there needs none
    return;
  }
  const std::string error = own.Thickness.Draw(request);
  this->ReportThicknessErrors(error);
}

void vtkCloudTextureMapper::ReportThicknessErrors(const std::string& error)
{
  vtkInternals& own = *this->Internals;
  std::string message = error;
  if (error.empty() && own.Thickness.HasMore())
  {
    message = moreClouds + std::to_string(this->MaximumNumberOfLayers) +
      " that are measured: the thickness of those in between is wrong. Raise MaximumNumberOfLayers.";
  }
  if (error.empty() && own.Thickness.CutsWays())
  {
    message = cutWays;
  }
  if (!message.empty() && message != own.LastThickness)
  {
    if (error.empty())
    {
      vtkWarningMacro(<< message);
    }
    else
    {
      vtkErrorMacro(<< "Clouds are drawn without their thickness: " << message << ".");
    }
  }
  // Frames without such pixels come between others: the warning is not repeated then.
  if (!message.empty() || own.LastThickness.compare(0, moreClouds.size(), moreClouds) != 0)
  {
    own.LastThickness = message;
  }
}

void vtkCloudTextureMapper::DrawTriangles(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->SetCameraShaderParameters(helper, renderer, actor);
  helper.VAO->Bind();
  this->VBOs->AddAllAttributesToVAO(helper.Program, helper.VAO);
  for (const int type : { PrimitiveTris, PrimitiveTriStrips })
  {
    vtkOpenGLIndexBufferObject* indices = this->Primitives[type].IBO;
    if (indices->IndexCount > 0)
    {
      indices->Bind();
      glDrawElements(
        GL_TRIANGLES, static_cast<GLsizei>(indices->IndexCount), GL_UNSIGNED_INT, nullptr);
      indices->Release();
    }
  }
  helper.VAO->Release();
}

double vtkCloudTextureMapper::GetExtinctionInUse(vtkActor* actor) const
{
  if (this->Extinction > 0)
  {
    return this->Extinction;
  }
  const nephoscope::MeanChord& chord = this->Internals->Surface.Chord;
  vtkPolyData* surface = this->Internals->Surface.Surface;
  const double scale = std::cbrt(std::abs(actor->GetMatrix()->Determinant()));
  const double length = chord.Length() > 0 ? chord.Length()
    : surface                              ? surface->GetLength() / 100
                                           : 0;
  const auto& volume = this->Internals->Volume;
  const double optical = length * scale * (volume ? volume->MeanDensity : chord.MeanWeight());
  return optical > 0 ? this->OpticalDepth / optical : 0;
}

// No pixel changes by more than 1/2000 from here on: of opacity; or, where thickness is added, of
// the texture that exceeds its threshold and of its colour.
double vtkCloudTextureMapper::GetEnoughOpticalDepth() const
{
  if (this->ThicknessEffect == THICKNESS_MULTIPLIES_OPACITY)
  {
    return 8;
  }
  constexpr double leastTexture = 6; // of up to 16 waves, in their standard deviations
  const double edge = std::sqrt(1 + this->Softness * this->Softness);
  const double threshold = this->UseThreshold ? std::abs(this->Threshold) : 6 * edge;
  const double excess = leastTexture + threshold + this->ColorRange + 4 * edge;
  return excess / std::max(this->ThicknessWeight, 1e-30);
}
