// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "ProjectedCells.h"

#include "CellDrawing.h"
#include "CellGeometry.h"
#include "OpacityTable.h"
#include "ShaderText.h"
#include "TrianglePass.h"

#include "CellCompositingFragment.h"
#include "CellCompositingGeometry.h"
#include "CellCompositingVertex.h"

#include "vtkMatrix4x4.h"
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
std::array<float, 4> ToFloat(const double v[4])
{
  std::array<float, 4> result;
  std::copy(v, v + 4, result.begin());
  return result;
}

std::string CellShader(const char* shader, const std::string& constants)
{
  return SpecializedShader(WithTriangleShaders(shader), constants);
}
}

ProjectedCells::ProjectedCells() = default;
ProjectedCells::~ProjectedCells() = default;

std::string ProjectedCells::UploadGeometry(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry)
{
  const std::vector<float> table = MakeOpacityTable();
  const std::string error =
    this->AlphaTable.Upload(window, table.data(), table.size(), 1, VTK_FLOAT);
  const std::vector<Tetrahedron> list = geometry.Tetrahedra.Copy();
  return error.empty() ? this->Tetrahedra.Upload(window, list.data(), list.size(), 4, VTK_INT)
                       : error;
}

void ProjectedCells::UploadOrder(const std::vector<std::int32_t>& order)
{
  this->OrderSize = order.size();
  this->Order.Upload(order);
}

std::string ProjectedCells::Draw(const CellDrawing& drawing)
{
  const CellMethod method = drawing.Options.Method;
  const std::string constants = drawing.ShaderConstants() +
    ShaderConstant("linearOpacity", method == CellMethod::TrianglesLinear);
  const bool triangles = DrawsTriangles(method);
  vtkShaderProgram* program = drawing.Window->GetShaderCache()->ReadyShaderProgram(
    CellCompositingVertex,
    CellShader(triangles ? TriangleFragmentShader() : CellCompositingFragment, constants).c_str(),
    CellShader(triangles ? TriangleGeometryShader() : CellCompositingGeometry, constants).c_str());
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
  this->Order.Activate(program, "tetrahedron");
  program->SetUniformi("alphaTable", this->AlphaTable.Activate());
  program->SetUniformf("alphaTableEnd", static_cast<float>(opacityTableEnd));
  program->SetUniformi("alphaTableLast", opacityTableEntries - 1);
  program->SetUniformf("smallestEyeDepth",
    static_cast<float>(SmallestEyeDepth(drawing.View.EyeView, drawing.View.ViewToDevice)));
  program->SetUniform4f("eyeMC", ToFloat(drawing.View.EyeModel).data());
  const float halfViewport[2] = { 0.5f * static_cast<float>(drawing.Viewport[2]),
    0.5f * static_cast<float>(drawing.Viewport[3]) };
  program->SetUniform2f("halfViewport", halfViewport);
  program->SetUniform4f("eyeVC", ToFloat(drawing.View.EyeView).data());

  // Back faces in front of the near plane or behind the far plane still end segments inside: clamp,
  // do not clip.
  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP);
  drawing.Window->GetState()->vtkglBlendFuncSeparate(
    GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(this->OrderSize));
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  this->Order.Deactivate();
  this->VertexArray->Release();
  this->Tetrahedra.Deactivate();
  this->AlphaTable.Deactivate();
  drawing.Finish();
  return std::string();
}

void ProjectedCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Tetrahedra.Release(window);
  this->Order.Release();
  this->AlphaTable.Release(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}

} // namespace nephoscope
