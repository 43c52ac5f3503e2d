// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "RayVoxels.h"

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "ContourBuffers.h"
#include "RayGeometry.h"
#include "RayShaders.h"
#include "ShaderInstance.h"
#include "ShaderText.h"
#include "VolumePeel.h"

#include "RayCellsVertex.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr int maximumSteps = 1 << 16;

std::string VoxelShader(const CellDrawing& drawing, bool hasOwners)
{
  return SpecializedShader(VoxelsShader(),
    drawing.Buffers.SmallTableDefinition() + drawing.ShaderConstants() +
      ShaderConstant("hasOwners", hasOwners) +
      ShaderConstant("trilinear", drawing.Options.Trilinear));
}

// Each cell needs the scalars of two squares: two fetches instead of eight.
template <class Scalar>
std::string UploadSquares(vtkOpenGLRenderWindow* window, BufferTexture& buffer,
  const ChessboardGrid& grid, std::size_t count, const Scalar& scalarOf)
{
  const std::size_t row = static_cast<std::size_t>(grid.Size[0]);
  const std::size_t layer = row * static_cast<std::size_t>(grid.Size[1]);
  const auto scalar = [&](std::size_t i) { return scalarOf(std::min(i, count - 1)); };
  std::vector<std::array<float, 4>> squares(count);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      squares[i] = { { scalar(i), scalar(i + row), scalar(i + layer), scalar(i + layer + row) } };
    }
  });
  return buffer.Upload(window, squares.data(), count, 4, VTK_FLOAT);
}

/** Pixels without a range of the peel fail the depth test before their shader starts. */
class OnlyInRanges
{
public:
  OnlyInRanges(vtkOpenGLState* state, const VolumePeel* peel)
    : State(peel ? state : nullptr)
  {
    if (this->State)
    {
      attach(peel->GetDepth()->GetHandle());
      this->State->vtkglEnable(GL_DEPTH_TEST);
      this->State->vtkglDepthFunc(GL_GREATER);
      glDepthRange(1, 1); // behind the near end of any range
    }
  }
  ~OnlyInRanges()
  {
    if (this->State)
    {
      glDepthRange(0, 1);
      this->State->vtkglDisable(GL_DEPTH_TEST);
      attach(0);
    }
  }
  OnlyInRanges(const OnlyInRanges&) = delete;
  OnlyInRanges& operator=(const OnlyInRanges&) = delete;

private:
  static void attach(unsigned int texture)
  {
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
  }

  vtkOpenGLState* State;
};
}

std::string RayVoxels::UploadScalars(vtkOpenGLRenderWindow* window, const CellGeometry& geometry)
{
  const bool ofPoints = geometry.CellScalars.empty();
  this->HasOpacity = geometry.OpacityOnCells != ofPoints;
  const bool used = geometry.Lattice.Found && ofPoints;
  const std::vector<float>& opacities = geometry.OpacityScalars;
  const bool second = used && geometry.HasOpacityScalars && this->HasOpacity;
  const std::string error = UploadSquares(window, this->Squares, geometry.Grid,
    used ? geometry.Points.size() : 0, [&](std::size_t i) { return geometry.Points[i].Scalar; });
  return error.empty()
    ? UploadSquares(window, this->OpacitySquares, geometry.Grid, second ? opacities.size() : 0,
        [&](std::size_t i) { return opacities[i]; })
    : error;
}

std::string RayVoxels::UploadContoured(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const std::vector<float>& scalars)
{
  constexpr float missing = 3e38f;
  return UploadSquares(window, this->ContourSquares, geometry.Grid,
    geometry.Lattice.Found ? scalars.size() : 0,
    [&](std::size_t i) { return std::isnan(scalars[i]) ? missing : scalars[i]; });
}

std::string RayVoxels::Upload(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
  const CellBox& box, const std::vector<std::uint8_t>& clearDistances)
{
  this->Grid = geometry.Grid;
  this->Box = box;
  this->Lattice = geometry.Lattice;
  return this->ClearDistances.Upload(
    window, clearDistances.data(), clearDistances.size(), 1, VTK_UNSIGNED_CHAR);
}

bool RayVoxels::CanDraw(const CellDrawing& drawing) const
{
  const bool hasOpacity = drawing.Buffers.HasOpacityScalars(),
             opacityIsKnown = !hasOpacity || (this->HasOpacity && drawing.Options.Trilinear);
  // Light for the camera changes colours alone: neither where there is something to see, nor
  // surfaces.
  const bool lightIsKnown =
    !drawing.Options.CameraLight || (hasOpacity && opacityIsKnown && !drawing.Contours.IsUsed());
  return this->Lattice.Found && opacityIsKnown && lightIsKnown &&
    (!drawing.Contours.IsUsed() || drawing.Options.Trilinear) && !drawing.Contours.HasPolygons() &&
    !drawing.Buffers.HasLayers();
}

std::string RayVoxels::MediumShader(const CellDrawing& drawing, int instance) const
{
  const std::string constants =
    drawing.MediumConstants(instance) + ShaderConstant("trilinear", drawing.Options.Trilinear);
  return ShaderInstance(SpecializedShader(VoxelsMediumShader(), constants), instance);
}

void RayVoxels::SetGrid(vtkShaderProgram* program, int instance)
{
  const auto name = [=](const char* uniform) { return InstanceName(uniform, instance); };
  const int stride[3] = { 1, this->Grid.Size[0], this->Grid.Size[0] * this->Grid.Size[1] };
  float low[3], high[3];
  std::copy(this->Box.Low, this->Box.Low + 3, low);
  std::copy(this->Box.High, this->Box.High + 3, high);
  program->SetUniformi(name("maximumSteps"), maximumSteps);
  program->SetUniform1iv(name("gridStride"), 3, stride);
  program->SetUniform3f(name("boxLow"), low);
  program->SetUniform3f(name("boxHigh"), high);
  program->SetUniformi(name("oddOffset"), this->Grid.OddOffset & 1);
  vtkNew<vtkMatrix4x4> toNumbers;
  toNumbers->DeepCopy(this->Lattice.ToNumbers.data());
  toNumbers->Transpose(); // as OpenGL wants it
  program->SetUniformMatrix(name("toNumbers"), toNumbers);
  program->SetUniformi(name("squares"), this->Squares.Activate());
  if (program->IsUniformUsed(name("opacitySquares")))
  {
    program->SetUniformi(name("opacitySquares"), this->OpacitySquares.Activate());
  }
  if (program->IsUniformUsed(name("contourSquares")))
  {
    program->SetUniformi(name("contourSquares"), this->ContourSquares.Activate());
  }
  program->SetUniformi(name("clearDistances"), this->ClearDistances.Activate());
}

void RayVoxels::Deactivate()
{
  this->Squares.Deactivate();
  this->OpacitySquares.Deactivate();
  this->ContourSquares.Deactivate();
  this->ClearDistances.Deactivate();
}

void RayVoxels::SetRays(vtkShaderProgram* program, const SceneView& view)
{
  RayGeometry rays(view);
  program->SetUniformMatrix3x3("rayPoint", rays.Point().data());
  program->SetUniformMatrix3x3("rayDirection", rays.Direction().data());
  float eye[4];
  std::copy(view.EyeView, view.EyeView + 4, eye);
  program->SetUniform4f("eyeVC", eye);
}

std::string RayVoxels::Draw(const CellDrawing& drawing, vtkTextureObject* owners, int owner)
{
  vtkShaderProgram* program = drawing.Window->GetShaderCache()->ReadyShaderProgram(
    RayCellsVertex, VoxelShader(drawing, owners != nullptr).c_str(), "");
  if (!program)
  {
    return "the shaders did not compile";
  }
  vtkOpenGLState* state = drawing.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  this->VertexArray->Bind();
  drawing.SetUniforms(program);
  this->SetGrid(program);
  this->SetRays(program, drawing.View);
  if (owners)
  {
    owners->Activate();
    program->SetUniformi("pixelOwners", owners->GetTextureUnit());
    program->SetUniformf("owner", static_cast<float>(owner));
  }
  {
    const OnlyInRanges ranges(state, drawing.Peel);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  this->VertexArray->Release();
  this->Deactivate();
  if (owners)
  {
    owners->Deactivate();
  }
  drawing.Finish();
  return std::string();
}

void RayVoxels::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Squares.Release(window);
  this->OpacitySquares.Release(window);
  this->ContourSquares.Release(window);
  this->ClearDistances.Release(window);
  this->VertexArray->ReleaseGraphicsResources();
}

} // namespace nephoscope
