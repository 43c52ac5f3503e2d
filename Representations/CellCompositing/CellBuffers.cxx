// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellBuffers.h"

#include "CellPieces.h"
#include "ShaderText.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace nephoscope
{

std::string CellBuffers::UploadGeometry(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const CellPieces& pieces)
{
  this->UseCellScalars = !geometry.CellScalars.empty();
  this->SeparateOpacity = geometry.HasOpacityScalars;
  this->OpacityOnCells = geometry.OpacityOnCells;
  std::string error;
  const auto upload = [&](Name name, const auto& values, const auto& ofPieces, int components) {
    if (error.empty() && ofPieces.empty())
    {
      error = this->Buffers[name].Upload(window, values.data(), values.size(), components, VTK_FLOAT);
    }
    else if (error.empty())
    {
      const auto all = joined(values, ofPieces);
      error = this->Buffers[name].Upload(window, all.data(), all.size(), components, VTK_FLOAT);
    }
  };
  upload(Points, geometry.Points, pieces.Points, 4);
  upload(CellScalars, geometry.CellScalars, pieces.OfOwners(geometry.CellScalars), 1);
  upload(OpacityScalars, geometry.OpacityScalars,
    geometry.OpacityOnCells ? pieces.OfOwners(geometry.OpacityScalars) : pieces.OpacityScalars, 1);
  return error;
}

std::string CellBuffers::UploadTable(
  vtkOpenGLRenderWindow* window, const TransferFunctionTable& table, Name nodes, Name intervals)
{
  const std::string error =
    this->Buffers[nodes].Upload(window, table.Nodes.data(), table.Nodes.size(), 1, VTK_FLOAT);
  return error.empty() ? this->Buffers[intervals].Upload(
                           window, table.Intervals.data(), 2 * table.Intervals.size(), 4, VTK_FLOAT)
                       : error;
}

std::string CellBuffers::UploadTransferFunctions(vtkOpenGLRenderWindow* window,
  const TransferFunctionTable& colorAndOpacity, const TransferFunctionTable& opacity)
{
  constexpr std::size_t few = 8;
  this->SmallTable = colorAndOpacity.Nodes.size() <= few ? colorAndOpacity : TransferFunctionTable();
  this->NumberOfTransferNodes = static_cast<int>(colorAndOpacity.Nodes.size());
  this->NumberOfOpacityNodes = static_cast<int>(opacity.Nodes.size());
  const std::string error = this->UploadTable(window, colorAndOpacity, TransferNodes, TransferIntervals);
  return error.empty() ? this->UploadTable(window, opacity, OpacityNodes, OpacityIntervals) : error;
}

std::string CellBuffers::ShaderConstants() const
{
  return std::string(this->SeparateOpacity && !this->OpacityOnCells ? "#define SECOND_SCALAR\n" : "") +
    shaderConstant("useCellScalars", this->UseCellScalars) +
    shaderConstant("separateOpacity", this->SeparateOpacity) +
    shaderConstant("opacityOnCells", this->OpacityOnCells);
}

std::string CellBuffers::SmallTableDefinition() const
{
  return this->SmallTable.Nodes.empty()
    ? std::string()
    : "#define SMALL_TABLE " + std::to_string(this->SmallTable.Nodes.size()) + "\n";
}

void CellBuffers::SetSmallTable(vtkShaderProgram* program) const
{
  if (this->SmallTable.Nodes.empty())
  {
    return;
  }
  std::vector<std::array<float, 4>> low, high;
  for (const TransferFunctionTable::Interval& interval : this->SmallTable.Intervals)
  {
    low.push_back(interval.Low);
    high.push_back(interval.High);
  }
  using Values = const float(*)[4];
  program->SetUniform1fv("smallNodes", static_cast<int>(this->SmallTable.Nodes.size()), this->SmallTable.Nodes.data());
  program->SetUniform4fv("smallLow", static_cast<int>(low.size()), reinterpret_cast<Values>(low.data()));
  program->SetUniform4fv("smallHigh", static_cast<int>(high.size()), reinterpret_cast<Values>(high.data()));
}

void CellBuffers::Activate(vtkShaderProgram* program)
{
  static const char* const names[NumberOfBuffers] = { "points", "cellScalars", "opacityScalars", "transferNodes",
    "transferIntervals", "opacityNodes", "opacityIntervals" };
  for (int i = 0; i < NumberOfBuffers; ++i)
  {
    program->SetUniformi(names[i], this->Buffers[i].Activate());
  }
  program->SetUniformi("numberOfTransferNodes", this->NumberOfTransferNodes);
  program->SetUniformi("numberOfOpacityNodes", this->NumberOfOpacityNodes);
}

void CellBuffers::Deactivate()
{
  for (BufferTexture& buffer : this->Buffers)
  {
    buffer.Deactivate();
  }
}

void CellBuffers::Release(vtkWindow* window)
{
  for (BufferTexture& buffer : this->Buffers)
  {
    buffer.Release(window);
  }
}

} // namespace nephoscope
