// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "ProjectedCells.h"

#include "CellDrawing.h"
#include "CellPieces.h"
#include "ShaderText.h"

#include "CellCompositingFragment.h"
#include "CellCompositingGeometry.h"
#include "CellCompositingVertex.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

namespace nephoscope
{
namespace
{
std::array<float, 4> toFloat(const double v[4])
{
  std::array<float, 4> result;
  std::copy(v, v + 4, result.begin());
  return result;
}
}

ProjectedCells::ProjectedCells() = default;
ProjectedCells::~ProjectedCells() = default;

std::string ProjectedCells::UploadGeometry(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const CellPieces& pieces)
{
  if (pieces.Tetrahedra.empty())
  {
    return this->Tetrahedra.Upload(window, geometry.Tetrahedra.data(), geometry.Tetrahedra.size(), 4, VTK_INT);
  }
  const std::vector<Tetrahedron> all = joined(geometry.Tetrahedra, pieces.Tetrahedra);
  return this->Tetrahedra.Upload(window, all.data(), all.size(), 4, VTK_INT);
}

std::string ProjectedCells::UploadOrder(vtkOpenGLRenderWindow* window, const std::vector<std::int32_t>& order)
{
  this->OrderSize = order.size();
  return this->Order.Upload(window, order.data(), order.size(), 1, VTK_INT);
}

std::string ProjectedCells::Draw(const CellDrawing& drawing)
{
  const std::string constants = drawing.ShaderConstants();
  vtkShaderProgram* program = drawing.Window->GetShaderCache()->ReadyShaderProgram(CellCompositingVertex,
    specializedShader(CellCompositingFragment, constants).c_str(),
    specializedShader(CellCompositingGeometry, constants).c_str());
  if (!program)
  {
    return "the shaders did not compile";
  }
  if (program != this->Program)
  {
    this->Program = program;
    this->VertexArray->ShaderProgramChanged();
  }
  this->VertexArray->Bind();
  drawing.SetUniforms(program);
  program->SetUniformi("tetrahedra", this->Tetrahedra.Activate());
  program->SetUniformi("drawingOrder", this->Order.Activate());
  program->SetUniform4f("eyeMC", toFloat(drawing.View.EyeModel).data());
  program->SetUniform4f("eyeVC", toFloat(drawing.View.EyeView).data());

  // Back faces in front of the near plane or behind the far plane still end segments inside: clamp, do not clip.
  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP);
  drawing.Window->GetState()->vtkglBlendFuncSeparate(
    GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(this->OrderSize));
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  this->VertexArray->Release();
  this->Tetrahedra.Deactivate();
  this->Order.Deactivate();
  drawing.Finish();
  return std::string();
}

void ProjectedCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Tetrahedra.Release(window);
  this->Order.Release(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}

} // namespace nephoscope
