// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourBuffers.h"

#include "CellDrawing.h"
#include "ContourScene.h"
#include "PolygonScene.h"
#include "ShaderText.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <vector>

namespace nephoscope
{

std::string ContourBuffers::Upload(vtkOpenGLRenderWindow* window, const ContourScene& contours)
{
  this->NumberOfContours = static_cast<int>(contours.Contours.size());
  this->OfColor = contours.OfColor;
  this->Smooth = contours.Smooth;
  std::string error;
  const auto upload = [&](Name name, const auto& values, std::size_t tuples, int components) {
    error = error.empty()
      ? this->Buffers[name].Upload(window, values.data(), tuples, components, VTK_FLOAT)
      : error;
  };
  upload(Contours, contours.Contours, 2 * contours.Contours.size(), 4);
  upload(Scalars, contours.Scalars, contours.Scalars.size(), 1);
  upload(Gradients, contours.Gradients, contours.Gradients.size(), 4);
  return error;
}

std::string ContourBuffers::UploadPolygons(vtkOpenGLRenderWindow* window,
  const PolygonScene& polygons, const CellGeometry& geometry, const TetrahedronNeighbors* neighbors)
{
  std::vector<std::array<std::int32_t, 4>> ofTetrahedra;
  std::vector<PolygonScene::Surface> surfaces;
  if (neighbors && !polygons.Surfaces.empty())
  {
    polygons.ListForRays(geometry, *neighbors, ofTetrahedra, surfaces);
  }
  this->UsePolygons = !surfaces.empty();
  const std::string error = this->Buffers[OfTetrahedra].Upload(
    window, ofTetrahedra.data(), ofTetrahedra.size(), 4, VTK_INT);
  return error.empty()
    ? this->Buffers[Polygons].Upload(window, surfaces.data(), 4 * surfaces.size(), 4, VTK_FLOAT)
    : error;
}

std::string ContourBuffers::ShaderConstants() const
{
  return ShaderConstant("usePolygons", this->UsePolygons) +
    ShaderConstant("useContours", this->IsUsed()) +
    ShaderConstant("contourOfColor", this->OfColor) +
    ShaderConstant("smoothContourNormals", this->Smooth);
}

void ContourBuffers::Activate(const CellDrawing& drawing, vtkShaderProgram* program)
{
  static const char* const names[NumberOfBuffers] = { "contourScalars", "contours",
    "contourGradients", "tetrahedronSurfaces", "polygonSurfaces" };
  for (int i = 0; i < NumberOfBuffers; ++i)
  {
    program->SetUniformi(names[i], this->Buffers[i].Activate());
  }
  if (this->IsUsed() || this->UsePolygons)
  {
    program->SetUniformi("numberOfContours", this->NumberOfContours);
    this->SetLights(drawing, program);
  }
}

void ContourBuffers::SetLights(const CellDrawing& drawing, vtkShaderProgram* program) const
{
  program->SetUniform4f("contourShading", drawing.Options.ContourShading.data());
  // Gradients go by the inverse transpose; vtkMatrix3x3 is transposed on its way to OpenGL, so that
  // the inverse is given.
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(drawing.View.ModelToView, inverse);
  vtkNew<vtkMatrix3x3> gradients;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      gradients->SetElement(i, j, inverse->GetElement(i, j));
    }
  }
  program->SetUniformMatrix("gradientMatrix", gradients);

  std::array<std::vector<float>, 5> values;
  for (const SceneLight& light : drawing.Options.Lights)
  {
    const std::array<float, 3> parts[5] = { light.Color, light.Direction, light.Position,
      light.Attenuation, light.Cone };
    for (std::size_t i = 0; i < 5; ++i)
    {
      values[i].insert(values[i].end(), parts[i].begin(), parts[i].end());
    }
  }
  const int count = static_cast<int>(drawing.Options.Lights.size());
  program->SetUniformi("numberOfLights", count);
  const char* const names[5] = { "lightColors", "lightDirections", "lightPositions",
    "lightAttenuations", "lightCones" };
  for (std::size_t i = 0; i < 5 && count > 0; ++i)
  {
    program->SetUniform3fv(names[i], count, values[i].data());
  }
}

void ContourBuffers::Deactivate()
{
  for (BufferTexture& buffer : this->Buffers)
  {
    buffer.Deactivate();
  }
}

void ContourBuffers::Release(vtkWindow* window)
{
  for (BufferTexture& buffer : this->Buffers)
  {
    buffer.Release(window);
  }
}

} // namespace nephoscope
