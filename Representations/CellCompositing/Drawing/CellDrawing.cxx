// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CellDrawing.h"

#include "CellBuffers.h"
#include "ContourBuffers.h"
#include "HazeAlongRayShader.h"
#include "OpaqueDepth.h"
#include "OpticalSegment.h"
#include "SamplersApart.h"
#include "ShaderInstance.h"
#include "ShaderText.h"
#include "SlicesOfRayShader.h"
#include "VolumePeel.h"
#include "VolumeSlices.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <array>

namespace nephoscope
{
bool IsSoftwareOpenGL()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  const auto has = [&](const char* part) { return renderer.find(part) != std::string::npos; };
  return has("llvmpipe") || has("softpipe") || has("SWR");
}

std::string CellDrawing::OwnConstants() const
{
  const bool more = this->Buffers.HasPointOpacity() || this->Contours.HasScalars();
  return std::string(more ? "#define MORE_SCALARS\n" : "") + this->Buffers.ShaderConstants() +
    this->Contours.ShaderConstants() +
    ShaderConstant("contourLayers", this->Options.ContourLayers && this->Buffers.HasLayers()) +
    ShaderConstant("contourLighting", this->Options.ContourLighting) +
    ShaderConstant("averageIntegration", this->Options.AverageIntegration) +
    ShaderConstant("splitAtControlPoints", this->Options.SplitAtControlPoints) +
    ShaderConstant("useDepthRanges", this->Peel != nullptr) + this->Options.Planes.Definition();
}

std::string CellDrawing::MediumConstants(int number) const
{
  constexpr std::size_t few = 12; // four media have a thousand numbers in uniforms
  const bool isSmall = this->Options.SplitAtControlPoints && this->Buffers.HasSmallTables(few);
  return (isSmall ? this->Buffers.SmallTableDefinition() : "") + this->OwnConstants() +
    "const int mediumNumber = " + std::to_string(number) + ";\n";
}

std::string CellDrawing::CommonConstants() const
{
  return ShaderConstant("softwareOpenGL", IsSoftwareOpenGL()) + this->Options.Haze.Definition() +
    HazeAlongRayShader + VolumeSlices::Definition() + SlicesOfRayShader;
}

// Where rays end: at the opaque depth, or at the ends of the ranges of a peel.
void CellDrawing::SetDepths(vtkShaderProgram* program) const
{
  if (!this->Peel)
  {
    this->Depth.GetTexture()->Activate();
    program->SetUniformi("opaqueDepth", this->Depth.GetTexture()->GetTextureUnit());
    return;
  }
  vtkTextureObject* ranges = this->Peel->GetRanges();
  ranges->Activate();
  program->SetUniformi("depthRanges", ranges->GetTextureUnit());
  program->SetUniformi("rangeNumber", this->Range);
}

void CellDrawing::SetUniforms(vtkShaderProgram* program) const
{
  this->SetCommonUniforms(program);
  this->SetOwnUniforms(program, -1);
  this->Contours.Activate(*this, program);
}

void CellDrawing::SetCommonUniforms(vtkShaderProgram* program) const
{
  SetSamplersApart(program);
  this->Options.Haze.SetUniforms(program);
  this->SetDepths(program);
  VolumeSlices::SetUniforms(program);
  program->SetUniform4f("depthToVC", DepthToViewOf(this->View.ViewToDevice).data());
  vtkNew<vtkMatrix4x4> transposed; // as OpenGL wants it
  vtkMatrix4x4::Transpose(this->View.ViewToDevice, transposed);
  program->SetUniformMatrix("VCDCMatrix", transposed);

  float nodes[numberOfQuadratureNodes][2];
  for (int i = 0; i < numberOfQuadratureNodes; ++i)
  {
    nodes[i][0] = static_cast<float>(quadratureNodes[i][0]);
    nodes[i][1] = static_cast<float>(quadratureNodes[i][1]);
  }
  program->SetUniform2fv("quadratureNodes", numberOfQuadratureNodes, nodes);
}

void CellDrawing::SetOwnUniforms(vtkShaderProgram* program, int instance) const
{
  this->Options.Planes.SetUniforms(program, InstanceName("clippingPlanes", instance));
  this->Buffers.Activate(program, instance);
  this->Buffers.SetSmallTable(program, instance);
  program->SetUniformf(
    InstanceName("extinctionScale", instance), static_cast<float>(this->Options.ExtinctionScale));
  vtkNew<vtkMatrix4x4> transposed;
  vtkMatrix4x4::Transpose(this->View.ModelToView, transposed);
  program->SetUniformMatrix(InstanceName("MCVCMatrix", instance), transposed);
}

void CellDrawing::Finish() const
{
  this->Buffers.Deactivate();
  this->Contours.Deactivate();
  if (this->Peel)
  {
    this->Peel->GetRanges()->Deactivate();
    return;
  }
  this->Depth.GetTexture()->Deactivate();
}

} // namespace nephoscope
