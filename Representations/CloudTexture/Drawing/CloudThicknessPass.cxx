// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CloudThicknessPass.h"

#include "CloudShaderCode.h"
#include "DensityVolume.h"
#include "SurfaceLayersFragment.h"
#include "SurfaceLayersVertex.h"
#include "SurfaceListsFragment.h"
#include "ViewState.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <limits>

namespace nephoscope
{

CloudThicknessPass::CloudThicknessPass() = default;
CloudThicknessPass::~CloudThicknessPass() = default;

namespace
{
// The superclass and the passes need some: colours, environment, thresholds, peels, density volume.
constexpr int reservedUnits = 10;
// For a sampler that is not read: samplers of two types may not share a unit, and 0 is somebody's.
constexpr int unusedUnit = 15;
constexpr int mostParts = 8; // of ways through the density volume: each walks whole bins
}

int CloudThicknessPass::LimitDrawings(int clouds, bool withDensities)
{
  if (SurfaceLists::IsSupported())
  {
    return 0;
  }
  GLint units = 16;
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  return std::max(1, std::min((clouds + 1) / 2, (units - reservedUnits) / (withDensities ? 2 : 1)));
}

void CloudThicknessPass::FindView(const Request& request)
{
  const ViewState view(request.Renderer, request.Actor, request.Center);
  this->IsParallel = IsParallelProjection(view.ViewToDevice);
  // OpenGL counts matrices by columns.
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      this->PlaceToView[4 * j + i] = static_cast<float>(view.ModelToView->GetElement(i, j));
    }
  }
  vtkMatrix4x4::Invert(view.ModelToView, this->ViewToData);
  vtkMatrix4x4::Invert(view.ViewToDevice, this->DeviceToView);
  for (int i = 0; i < 3; ++i) // places are relative to the center
  {
    this->ViewToData->SetElement(i, 3, this->ViewToData->GetElement(i, 3) + request.Center[i]);
  }
  const auto toView = DepthToViewOf(view.ViewToDevice);
  std::copy(toView.begin(), toView.end(), this->DepthToView);
  this->Near = static_cast<float>(request.Renderer->GetActiveCamera()->GetClippingRange()[0]);
  // Device coordinates are left-handed: a view that is not mirrored turns the sense around.
  const double handedness = view.ModelToView->Determinant() * view.ViewToDevice->Determinant();
  this->FrontIsFront = (handedness < 0) != request.IsInsideOut;
  double nearest = std::numeric_limits<double>::max();
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[4] = { request.Bounds[corner & 1], request.Bounds[2 + (corner >> 1 & 1)],
      request.Bounds[4 + (corner >> 2)], 1 };
    view.ModelToView->MultiplyPoint(p, p);
    nearest = std::min(nearest, -p[2]);
  }
  this->EyeMayBeInside = nearest <= this->Near;
  this->IsClosed = request.IsClosed;
  for (int i = 0; i < 2; ++i)
  {
    this->Origin[i] = static_cast<float>(request.Scene.Viewport[i]);
  }
}

std::string CloudThicknessPass::Draw(const Request& request)
{
  if (!SceneDepth::IsTold(request.Scene.Prop))
  {
    // The layers were found in an earlier stage, but for a mapper that several actors share: the
    // last one's.
    this->IsKnown = this->IsKnown && this->KnownProp == request.Scene.Prop;
    return std::string();
  }
  this->IsKnown = false;
  this->WaysAreWhole = true;
  this->KnownProp = request.Scene.Prop;
  this->FindView(request);
  this->Opaque = this->Scene.Find(request.Scene);
  if (!this->Opaque)
  {
    return "the shader that asks for the depth of opaque things does not compile";
  }
  SurfaceLayers::Request layers;
  layers.Window = request.Scene.Window;
  std::copy_n(request.Scene.Viewport + 2, 2, layers.Size);
  layers.Limit = LimitDrawings(request.Clouds, request.WithDensities);
  layers.WithDensities = this->WithDensities = request.WithDensities;
  layers.OpaqueDepth = this->Opaque;
  layers.OnlyFaces = this->EyeMayBeInside || !this->IsClosed ? 0
    : this->FrontIsFront                                     ? GL_BACK
                                                             : GL_FRONT;
  this->HasLists = layers.Limit == 0;
  if (this->HasLists)
  {
    // In a volume densities of faces do not count, but the front faces' own ways do.
    if (request.Volume)
    {
      layers.WithDensities = false;
      layers.OnlyFaces = 0;
    }
    this->IsKnown = this->Lists.Draw(layers, [&]() {
      this->Paint(request, SurfaceListsFragment,
        [&](vtkShaderProgram* program) { this->Lists.SetUniforms(program); });
    });
    if (this->IsKnown && request.Volume)
    {
      this->FindDepths(request, layers);
    }
    return this->IsKnown
      ? std::string()
      : "there are more than 16 million faces in the picture, or this OpenGL has no images for them";
  }
  this->IsKnown = this->Layers.Draw(
    layers, [&](const SurfaceLayers::Drawing& drawing) { this->PaintLayer(request, drawing); });
  return this->IsKnown ? std::string() : "this OpenGL cannot draw depths into 32-bit float images";
}

void CloudThicknessPass::Paint(
  const Request& request, const char* shader, const std::function<void(vtkShaderProgram*)>& prepare)
{
  std::string vertex = SurfaceLayersVertex, fragment = shader;
  for (std::string* source : { &vertex, &fragment })
  {
    vtkShaderProgram::Substitute(*source, "//NEPHOSCOPE::Constants", request.Constants);
  }
  vtkShaderProgram* program = request.Scene.Window->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    return;
  }
  program->SetUniformi("frontIsFront", this->FrontIsFront);
  program->SetUniformMatrix4x4("placeToView", this->PlaceToView);
  prepare(program);
  if (program != this->Helper.Program)
  {
    this->Helper.Program = program;
    this->Helper.VAO->ShaderProgramChanged();
  }
  request.DrawTriangles(this->Helper);
}

void CloudThicknessPass::FindDepths(const Request& request, const SurfaceLayers::Request& layers)
{
  const std::string code = CloudDepthsCode(request.Volume->GetShaderCode());
  if (!this->Depths || code != this->DepthsCode)
  {
    this->Depths.reset(
      new vtkOpenGLQuadHelper(request.Scene.Window, nullptr, code.c_str(), nullptr));
    this->DepthsCode = code;
  }
  else
  {
    request.Scene.Window->GetShaderCache()->ReadyShaderProgram(this->Depths->Program);
  }
  vtkShaderProgram* program = this->Depths->Program;
  this->IsKnown = program != nullptr;
  if (!program)
  {
    return;
  }
  this->Opaque->Activate();
  request.Volume->Activate();
  this->SetUniforms(program, request.Extinction, request.EnoughOpticalDepth, 0);
  request.Volume->SetUniforms(program, this->ViewToData);
  const float origin[2] = { 0, 0 }; // of the lists
  program->SetUniform2f("cloudOrigin", origin);
  vtkNew<vtkMatrix4x4> toView;
  vtkMatrix4x4::Transpose(this->DeviceToView, toView); // as OpenGL wants it
  program->SetUniformMatrix("deviceToView", toView);
  this->Lists.SetUniforms(program);
  const auto walk = [&]() {
    program->SetUniformi("parts", this->Parts);
    return this->Lists.Rewrite(layers, this->Parts, [&](int face, int part) {
      program->SetUniformi("face", face);
      program->SetUniformi("part", part);
      this->Depths->Render();
    });
  };
  this->WaysAreWhole = walk();
  while (!this->WaysAreWhole && this->Parts < mostParts)
  {
    this->Parts *= 2; // the next pictures begin with as many
    this->WaysAreWhole = walk();
  }
  request.Volume->Deactivate();
  this->Opaque->Deactivate();
}

void CloudThicknessPass::PaintLayer(const Request& request, const SurfaceLayers::Drawing& drawing)
{
  // Without densities the depth is tested by OpenGL, not sampled: it is the depth buffer now.
  vtkTextureObject* textures[2] = { request.WithDensities ? this->Opaque : nullptr,
    drawing.Found ? drawing.Found : drawing.Previous };
  const char* names[2] = { "opaqueDepth", "foundBefore" };
  this->Paint(request, SurfaceLayersFragment, [&](vtkShaderProgram* program) {
    for (int i = 0; i < 2; ++i)
    {
      if (textures[i])
      {
        textures[i]->Activate();
        program->SetUniformi(names[i], textures[i]->GetTextureUnit());
      }
    }
    program->SetUniformi("stage", drawing.Found ? 2 : drawing.Previous ? 1 : 0);
    program->SetUniform4f("depthToView", this->DepthToView);
  });
  for (vtkTextureObject* texture : textures)
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}

std::vector<vtkTextureObject*> CloudThicknessPass::Textures()
{
  std::vector<vtkTextureObject*> result;
  if (this->IsKnown)
  {
    result.push_back(this->Opaque);
    if (this->HasLists)
    {
      result.push_back(this->Lists.GetHeads());
      result.push_back(this->Lists.GetNodes());
      return result;
    }
    for (int i = 0; i < this->Layers.GetNumberOfDrawings(); ++i)
    {
      result.push_back(this->Layers.GetDepths(i));
      if (this->WithDensities)
      {
        result.push_back(this->Layers.GetDensities(i));
      }
    }
  }
  return result;
}

void CloudThicknessPass::Activate()
{
  for (vtkTextureObject* texture : this->Textures())
  {
    texture->Activate();
  }
}

void CloudThicknessPass::Forget(const Request& request)
{
  this->FindView(request);
  this->IsKnown = false;
}

void CloudThicknessPass::Deactivate()
{
  for (vtkTextureObject* texture : this->Textures())
  {
    texture->Deactivate();
  }
}

void CloudThicknessPass::SetUniforms(
  vtkShaderProgram* program, double extinction, double enough, int drawings)
{
  program->SetUniformi("cloudDrawings",
    !this->IsKnown     ? -1
      : this->HasLists ? 1
                       : this->Layers.GetNumberOfDrawings());
  program->SetUniformMatrix4x4("placeToView", this->PlaceToView);
  program->SetUniform4f("cloudDepthToView", this->DepthToView);
  program->SetUniform2f("cloudOrigin", this->Origin);
  program->SetUniformf("cloudExtinction", static_cast<float>(extinction));
  program->SetUniformf("cloudEnough", static_cast<float>(enough));
  program->SetUniformf("cloudNear", this->Near);
  program->SetUniformi("cloudEyeMayBeInside", this->EyeMayBeInside);
  program->SetUniformi("cloudIsParallel", this->IsParallel);
  program->SetUniformi("cloudFrontIsFront", this->FrontIsFront);
  if (!this->IsKnown)
  {
    program->SetUniformi("cloudHeads", unusedUnit);
    return;
  }
  program->SetUniformi("cloudOpaqueDepth", this->Opaque->GetTextureUnit());
  if (this->HasLists)
  {
    program->SetUniformi("cloudHeads", this->Lists.GetHeads()->GetTextureUnit());
    program->SetUniformi("cloudNodes", this->Lists.GetNodes()->GetTextureUnit());
    return;
  }
  if (this->Layers.GetNumberOfDrawings() == 0)
  {
    return; // there is nothing to draw
  }
  for (int i = 0; i < drawings; ++i)
  {
    const int found = std::min(
      i, this->Layers.GetNumberOfDrawings() - 1); // what is not read needs some texture, too
    program->SetUniformi(DepthsUniform(i).c_str(), this->Layers.GetDepths(found)->GetTextureUnit());
    if (this->WithDensities)
    {
      program->SetUniformi(
        DensitiesUniform(i).c_str(), this->Layers.GetDensities(found)->GetTextureUnit());
    }
  }
}

void CloudThicknessPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Scene.ReleaseGraphicsResources(window);
  this->Layers.ReleaseGraphicsResources(window);
  this->Lists.ReleaseGraphicsResources(window);
  this->Depths.reset();
  this->Parts = 1;
  this->Helper.Program = nullptr; // the window's
  this->Helper.ReleaseGraphicsResources(window);
  this->Opaque = nullptr;
  this->IsKnown = false;
}

} // namespace nephoscope
