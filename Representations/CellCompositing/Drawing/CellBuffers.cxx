// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellBuffers.h"

#include "CameraLight.h"
#include "CellGeometry.h"
#include "ShaderInstance.h"
#include "ShaderText.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace nephoscope
{

namespace
{
bool HasNarrowIntervals(const std::vector<TransferFunctionTable>& tables)
{
  constexpr float narrow =
    1e-3f; // of the range of the scalar: rounding at a face is some 1e-6 of it
  return std::any_of(tables.begin(), tables.end(), [=](const TransferFunctionTable& table) {
    return std::any_of(
      table.Widths.begin(), table.Widths.end(), [=](float w) { return w > 0 && w < narrow; });
  });
}

/** A number, and a macro that does something with each of 0, 1, ... below it. */
std::string CountedDefinition(const char* number, const char* each, std::size_t count)
{
  std::string text =
    "#define " + std::string(number) + " " + std::to_string(count) + "\n#define " + each + "(DO)";
  for (std::size_t i = 0; i < count; ++i)
  {
    text += " DO(" + std::to_string(i) + ")";
  }
  return text + "\n";
}

}

std::string CellBuffers::UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry)
{
  const std::string error =
    geometry.CellScalars.empty() ? std::string() : this->UploadPoints(window, geometry);
  return error.empty() ? this->UploadValues(window, geometry, true, true) : error;
}

std::string CellBuffers::UploadPoints(vtkOpenGLRenderWindow* window, const CellGeometry& geometry)
{
  return this->Buffers[Points].Upload(
    window, geometry.Points.data(), geometry.Points.size(), 4, VTK_FLOAT);
}

std::string CellBuffers::UploadValues(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry, bool ofColor, bool ofOpacity)
{
  std::string error;
  const auto upload = [&](Name name, const std::vector<float>& values) {
    return this->Buffers[name].Upload(window, values.data(), values.size(), 1, VTK_FLOAT);
  };
  if (ofColor && geometry.CellScalars.empty()) // points have their scalars with them
  {
    error = this->UploadPoints(window, geometry);
  }
  if (ofColor && error.empty())
  {
    this->UseCellScalars = !geometry.CellScalars.empty();
    error = upload(CellScalars, geometry.CellScalars);
  }
  if (ofOpacity && error.empty())
  {
    this->SeparateOpacity = geometry.HasOpacityScalars;
    this->OpacityOnCells = geometry.OpacityOnCells;
    error = upload(OpacityScalars, geometry.OpacityScalars);
  }
  return error;
}

std::string CellBuffers::UploadCameraLight(
  vtkOpenGLRenderWindow* window, const CameraLight& light, double width)
{
  this->UseCameraLight = light.IsUsed();
  if (!light.IsUsed())
  {
    this->Buffers[LightParts].Release(window);
    return std::string();
  }
  const std::vector<std::array<float, 4>> parts = light.Parts(width);
  const std::vector<std::array<float, 2>> factors = light.Factors();
  this->TowardsSun = light.TowardsSun();
  this->NumberOfPhases = static_cast<int>(factors.size());
  const std::string error =
    this->Buffers[LightParts].Upload(window, parts.data(), parts.size(), 4, VTK_FLOAT);
  return error.empty()
    ? this->Buffers[PhaseFunction].Upload(window, factors.data(), factors.size(), 2, VTK_FLOAT)
    : error;
}

// All tables one after the other; nodes as (position, width above).
std::string CellBuffers::UploadTables(vtkOpenGLRenderWindow* window,
  const std::vector<TransferFunctionTable>& tables, Name nodes, Name intervals)
{
  std::vector<std::array<float, 2>> allNodes;
  std::vector<TransferFunctionTable::Interval> allIntervals;
  for (const TransferFunctionTable& table : tables)
  {
    for (std::size_t i = 0; i < table.Nodes.size(); ++i)
    {
      allNodes.push_back({ { table.Nodes[i], table.Widths[i] } });
    }
    allIntervals.insert(allIntervals.end(), table.Intervals.begin(), table.Intervals.end());
  }
  const std::string error =
    this->Buffers[nodes].Upload(window, allNodes.data(), allNodes.size(), 2, VTK_FLOAT);
  return error.empty() ? this->Buffers[intervals].Upload(
                           window, allIntervals.data(), 2 * allIntervals.size(), 4, VTK_FLOAT)
                       : error;
}

std::string CellBuffers::UploadTransferFunctions(vtkOpenGLRenderWindow* window,
  const std::vector<TransferFunctionTable>& colorAndOpacity,
  const std::vector<TransferFunctionTable>& opacity, const std::vector<std::int32_t>& tables)
{
  constexpr std::size_t few = 48; // up to so many, uniforms take less time than fetches
  this->NumberOfTransferNodes = static_cast<int>(colorAndOpacity[0].Nodes.size());
  this->NumberOfOpacityNodes = static_cast<int>(opacity[0].Nodes.size());
  this->UseLayers = colorAndOpacity.size() > 1;
  const bool narrow = HasNarrowIntervals(colorAndOpacity) || HasNarrowIntervals(opacity);
  const auto copyOf = [&](const TransferFunctionTable& table) {
    const bool small = table.Nodes.size() <= few && !narrow && !this->UseLayers;
    return small ? table : TransferFunctionTable();
  };
  this->SmallTable = copyOf(colorAndOpacity[0]);
  this->SmallOpacityTable =
    this->SmallTable.Nodes.empty() ? TransferFunctionTable() : copyOf(opacity[0]);
  std::vector<std::array<float, 4>>
    layers; // first node, number of nodes, of either table; clear range
  float first[2] = { 0, 0 };
  for (std::size_t i = 0; i < colorAndOpacity.size(); ++i)
  {
    const float sizes[2] = { float(colorAndOpacity[i].Nodes.size()),
      float(opacity[i].Nodes.size()) };
    const std::array<float, 2> clear = opacity[i].LongestTransparentRange();
    layers.push_back({ { first[0], sizes[0], first[1], sizes[1] } });
    layers.push_back({ { clear[0], clear[1], 0, 0 } });
    first[0] += sizes[0];
    first[1] += sizes[1];
  }
  std::string error = this->UploadTables(window, colorAndOpacity, TransferNodes, TransferIntervals);
  error =
    error.empty() ? this->UploadTables(window, opacity, OpacityNodes, OpacityIntervals) : error;
  error = error.empty()
    ? this->Buffers[LayerTables].Upload(window, layers.data(), layers.size(), 4, VTK_FLOAT)
    : error;
  return error.empty()
    ? this->Buffers[TetrahedronLayers].Upload(window, tables.data(), tables.size(), 1, VTK_INT)
    : error;
}

std::string CellBuffers::ShaderConstants() const
{
  return ShaderConstant("useCellScalars", this->UseCellScalars) +
    ShaderConstant("separateOpacity", this->SeparateOpacity) +
    ShaderConstant("opacityOnCells", this->OpacityOnCells) +
    ShaderConstant("useLayers", this->UseLayers) +
    ShaderConstant("cameraLight", this->UseCameraLight);
}

bool CellBuffers::UsesSmallOpacityTable() const
{
  return this->SeparateOpacity && !this->SmallOpacityTable.Nodes.empty();
}

bool CellBuffers::HasSmallTables(std::size_t most) const
{
  return !this->SmallTable.Nodes.empty() &&
    (this->UsesSmallOpacityTable() || !this->SeparateOpacity) &&
    std::max(this->SmallTable.Nodes.size(), this->SmallOpacityTable.Nodes.size()) <= most;
}

std::string CellBuffers::SmallTableDefinition() const
{
  const std::size_t nodes = this->SmallTable.Nodes.size();
  if (nodes == 0)
  {
    return std::string();
  }
  const std::size_t opacityNodes = this->SmallOpacityTable.Nodes.size();
  return CountedDefinition("SMALL_TABLE", "EACH_NODE", nodes) +
    (this->UsesSmallOpacityTable()
        ? CountedDefinition("SMALL_OPACITY_TABLE", "EACH_OPACITY_NODE", opacityNodes)
        : std::string()) +
    (this->UsesSmallOpacityTable() || !this->SeparateOpacity ? "#define SMALL_TABLES\n" : "");
}

void CellBuffers::SetSmallTable(vtkShaderProgram* program, int instance) const
{
  if (this->SmallTable.Nodes.empty())
  {
    return;
  }
  const auto name = [=](const char* uniform) { return InstanceName(uniform, instance); };
  std::vector<std::array<float, 4>> low, high;
  for (const TransferFunctionTable::Interval& interval : this->SmallTable.Intervals)
  {
    low.push_back(interval.Low);
    high.push_back(interval.High);
  }
  using Values = const float(*)[4];
  program->SetUniform1fv(name("smallNodes"), static_cast<int>(this->SmallTable.Nodes.size()),
    this->SmallTable.Nodes.data());
  program->SetUniform4fv(
    name("smallLow"), static_cast<int>(low.size()), reinterpret_cast<Values>(low.data()));
  program->SetUniform4fv(
    name("smallHigh"), static_cast<int>(high.size()), reinterpret_cast<Values>(high.data()));
  if (!this->UsesSmallOpacityTable())
  {
    return;
  }
  std::vector<std::array<float, 2>> opacities;
  for (const TransferFunctionTable::Interval& interval : this->SmallOpacityTable.Intervals)
  {
    opacities.push_back({ { interval.Low[3], interval.High[3] } });
  }
  const std::vector<float>& nodes = this->SmallOpacityTable.Nodes;
  program->SetUniform1fv(name("smallOpacityNodes"), static_cast<int>(nodes.size()), nodes.data());
  program->SetUniform2fv(name("smallOpacities"), static_cast<int>(opacities.size()),
    reinterpret_cast<const float(*)[2]>(opacities.data()));
}

void CellBuffers::Activate(vtkShaderProgram* program, int instance)
{
  static const char* const names[NumberOfBuffers] = { "points", "cellScalars", "opacityScalars",
    "transferNodes", "transferIntervals", "opacityNodes", "opacityIntervals", "layerTables",
    "tetrahedronLayers", "lightParts", "phaseFunction" };
  for (int i = 0; i < NumberOfBuffers; ++i)
  {
    const char* name = InstanceName(names[i], instance);
    if (program->IsUniformUsed(name))
    {
      program->SetUniformi(name, this->Buffers[i].Activate());
    }
  }
  if (this->UseCameraLight)
  {
    program->SetUniform3f(InstanceName("towardsSun", instance), this->TowardsSun.data());
    program->SetUniformi(InstanceName("numberOfPhases", instance), this->NumberOfPhases);
  }
  program->SetUniformi(
    InstanceName("numberOfTransferNodes", instance), this->NumberOfTransferNodes);
  program->SetUniformi(InstanceName("numberOfOpacityNodes", instance), this->NumberOfOpacityNodes);
}

int CellBuffers::CountTextures() const
{
  return 3 + (this->UseCellScalars ? 1 : 0) + (this->SeparateOpacity ? 3 : 0) +
    (this->UseLayers ? 2 : 0) + (this->UseCameraLight ? 2 : 0);
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
