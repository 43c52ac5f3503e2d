// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "FacePass.h"

#include "CellScene.h"
#include "FaceSweep.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace nephoscope
{
namespace
{
const char* const copyShader = "//VTK::System::Dec\n"
                               "//VTK::Output::Dec\n"
                               "in vec2 texCoord;\n"
                               "uniform sampler2D picture;\n"
                               "void main() { gl_FragData[0] = texture(picture, texCoord); }\n";

std::vector<float> ReadDepth(
  vtkOpenGLState* state, vtkTextureObject* texture, int width, int height)
{
  std::vector<float> depth(static_cast<std::size_t>(width) * height);
  texture->Activate();
  state->vtkglPixelStorei(
    GL_PACK_ALIGNMENT, 4); // through VTK, which keeps the value and reads pictures with another
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  texture->Deactivate();
  return depth;
}
}

FacePass::FacePass() = default;
FacePass::~FacePass() = default;

std::string FacePass::Draw(vtkOpenGLRenderWindow* window, const CellScene& scene,
  const CellView& view, const CellDrawingOptions& options, bool sorted,
  vtkTextureObject* opaqueDepth)
{
  const CellGeometry& geometry = scene.GetGeometry();
  if (this->MeshVersion != scene.GetVersions().Geometry)
  {
    this->Mesh.Build(geometry);
    this->MeshVersion = scene.GetVersions().Geometry;
  }
  std::vector<std::uint8_t> visible(geometry.Tetrahedra.size(), 0);
  for (const std::int32_t i : scene.GetDrawn())
  {
    visible[static_cast<std::size_t>(i)] = 1;
  }
  const int width = static_cast<int>(opaqueDepth->GetWidth()),
            height = static_cast<int>(opaqueDepth->GetHeight());
  const FaceView faceView(view.ModelToView, view.ViewToDevice, view.EyeView, width, height);
  this->Projection.Build(geometry, this->Mesh, visible, faceView, sorted);

  const std::vector<float> depth = ReadDepth(window->GetState(), opaqueDepth, width, height);
  FaceSweep::Scene sweep;
  sweep.Geometry = &geometry;
  sweep.Color = scene.GetTransferFunctions().data();
  sweep.Opacity = scene.GetOpacityFunctions().data();
  sweep.TablesOfTetrahedra = &scene.GetTablesOfTetrahedra();
  sweep.ExtinctionScale = options.ExtinctionScale;
  sweep.AverageIntegration = options.AverageIntegration;
  sweep.OpaqueDepth = depth.data();
  std::vector<float> rgba = FaceSweep::Draw(sweep, this->Projection, faceView);
  this->Copy(window, rgba, width, height);
  return this->Quad->Program ? std::string() : "the shaders did not compile";
}

void FacePass::Copy(vtkOpenGLRenderWindow* window, std::vector<float>& rgba, int width, int height)
{
  this->Picture->SetContext(window);
  this->Picture->Create2DFromRaw(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, VTK_FLOAT, rgba.data());
  this->Picture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Picture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (!this->Quad)
  {
    this->Quad.reset(new vtkOpenGLQuadHelper(window, nullptr, copyShader, nullptr));
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  if (!this->Quad->Program)
  {
    return;
  }
  window->GetState()->vtkglDisable(GL_BLEND);
  window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  this->Picture->Activate();
  this->Quad->Program->SetUniformi("picture", this->Picture->GetTextureUnit());
  this->Quad->Render();
  this->Picture->Deactivate();
}

void FacePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Picture->ReleaseGraphicsResources(window);
}

} // namespace nephoscope
