// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "RayCells.h"

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "CellGeometry.h"
#include "ContourBuffers.h"
#include "EyeTetrahedron.h"
#include "HexahedronNeighbors.h"
#include "MovedView.h"
#include "RayGeometry.h"
#include "RayShaders.h"
#include "ShaderInstance.h"
#include "ShaderText.h"
#include "TetrahedronNeighbors.h"

#include "RayCellsVertex.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace nephoscope
{
namespace
{
// Layers of mesh that a ray may enter; and tetrahedra between entering and leaving.
constexpr int maximumLayers = 1024;
constexpr int maximumSteps = 1 << 16;

// Points at one place with equal values are one.
std::vector<std::int32_t> MergedVertices(
  const CellGeometry& geometry, const TetrahedronNeighbors& neighbors)
{
  std::vector<std::int32_t> vertices;
  vertices.reserve(8 * geometry.Hexahedra.size());
  for (const Hexahedron& hexahedron : geometry.Hexahedra)
  {
    std::transform(hexahedron.begin(), hexahedron.end(), std::back_inserter(vertices),
      [&](std::int32_t point) { return neighbors.Merged(point); });
  }
  return vertices;
}

// Instead of numbers of entries: rays start at the eye.
constexpr int fromEye = -1;
}

RayCells::RayCells() = default;
RayCells::~RayCells() = default;

std::string RayCells::UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
  const TetrahedronNeighbors& neighbors)
{
  this->Grid = geometry.Grid;
  this->HasHiddenCells = !geometry.HiddenCells.empty();
  this->NumberOfJumps = neighbors.NumberOfJumps;
  std::string error;
  const auto upload = [&](BufferTexture& buffer, const auto& values, int components, int type) {
    if (error.empty())
    {
      error = buffer.Upload(window, values.data(), values.size(), components, type);
    }
  };
  this->HasHexahedra = !geometry.Hexahedra.empty();
  this->DividesHexahedra = geometry.DividesHexahedra;
  this->HasOtherPoints = false;
  if (this->DividesHexahedra)
  {
    this->HasOtherPoints = std::any_of(neighbors.Neighbors.begin(), neighbors.Neighbors.end(),
      [](std::int32_t link) { return link >= 0 && (link & 1) != 0; });
    upload(this->Neighbors, neighbors.Neighbors, 1, VTK_INT);
    upload(this->Hexahedra, MergedVertices(geometry, neighbors), 1, VTK_INT);
  }
  else if (this->HasHexahedra)
  {
    upload(this->Neighbors, neighbors.Neighbors, 1, VTK_INT);
    const std::size_t vertices = 8 * geometry.Hexahedra.size();
    error = error.empty()
      ? this->Hexahedra.Upload(window, geometry.Hexahedra.data(), vertices, 1, VTK_INT)
      : error;
  }
  else if (std::max(geometry.Tetrahedra.size(), neighbors.BoundaryFaces.size()) >
    TetrahedronNeighbors::Most)
  {
    error = "The mesh has more tetrahedra than rays can number (" +
      std::to_string(TetrahedronNeighbors::Most) + "): divide it, or draw it on more ranks.";
  }
  else
  {
    upload(this->Neighbors, neighbors.Links(geometry), 4, VTK_INT);
    this->Hexahedra.Release(window);
  }
  upload(this->HiddenCells, geometry.HiddenCells, 1, VTK_UNSIGNED_CHAR);
  return error.empty() ? this->Voxels.UploadScalars(window, geometry) : error;
}

std::string RayCells::UploadBoundary(vtkOpenGLRenderWindow* window,
  const std::vector<BoundaryFace>& faces, const CellGeometry& geometry, const CellBox& box,
  const std::array<float, 2>& clearRange)
{
  constexpr std::size_t most = std::size_t(1) << 28; // FaceNumber.glsl
  const std::size_t entered = faces.size() - this->NumberOfJumps;
  if (entered >= most)
  {
    return "the mesh has more boundary faces than can be numbered; distribute it over more ranks";
  }
  this->Box = box;
  this->ClearRange = clearRange;
  this->Entries.SetFaces(geometry, faces, entered);
  return this->BoundaryFaces.Upload(window, faces.data(), faces.size(), 4, VTK_INT);
}

PixelRegion RayCells::FindRegion(
  const SceneView& view, const EyeTetrahedron& eye, const int viewport[4]) const
{
  return eye.Found ? PixelRegion{ { 0, 0, viewport[2], viewport[3] } }
                   : CoveredPixels(view, this->Entries.GetBounds(), viewport);
}

TetrahedronTopology RayCells::GetTopology() const
{
  return !this->Grid.IsEmpty() ? TetrahedronTopology::Grid
    : this->HasHexahedra       ? TetrahedronTopology::Hexahedra
                               : TetrahedronTopology::List;
}

std::string RayCells::OwnConstants() const
{
  return ShaderConstant("hasHiddenCells", this->HasHiddenCells) +
    ShaderConstant("hasJumps", this->NumberOfJumps > 0) +
    ShaderConstant("hasOtherPoints", this->HasOtherPoints) +
    ShaderConstant("closedGrid", this->Box.IsClosed(this->Grid));
}

// In which the scalar is trilinear.
bool RayCells::DrawsHexahedra(const CellDrawing& drawing) const
{
  return (this->HasHexahedra && !this->DividesHexahedra) ||
    (drawing.Options.Trilinear && !this->Grid.IsEmpty() && !drawing.Contours.HasPolygons() &&
      !drawing.Buffers.HasLayers());
}

bool RayCells::ReadySegmentProgram(const CellDrawing& drawing)
{
  constexpr std::size_t few = 12; // one scalar in tetrahedra: fetches then take less time
  const bool hexahedra = this->DrawsHexahedra(drawing);
  const bool isSmall =
    hexahedra || drawing.Buffers.HasOpacityScalars() || drawing.Buffers.HasSmallTables(few);
  const std::string constants = (isSmall ? drawing.Buffers.SmallTableDefinition() : "") +
    drawing.ShaderConstants() + this->OwnConstants();
  const std::string text =
    hexahedra ? HexahedraShader(!this->Grid.IsEmpty()) : TetrahedraShader(this->GetTopology());
  this->SegmentProgram = drawing.Window->GetShaderCache()->ReadyShaderProgram(
    RayCellsVertex, SpecializedShader(text, constants).c_str(), "");
  return this->SegmentProgram != nullptr;
}

std::string RayCells::MediumShader(const CellDrawing& drawing, int instance) const
{
  if (this->Voxels.CanDraw(drawing))
  {
    return this->Voxels.MediumShader(drawing, instance);
  }
  const std::string constants = drawing.MediumConstants(instance) + this->OwnConstants();
  const std::string text = this->DrawsHexahedra(drawing)
    ? HexahedraMediumShader(!this->Grid.IsEmpty())
    : TetrahedraMediumShader(this->GetTopology());
  return ShaderInstance(SpecializedShader(text, constants), instance);
}

std::string RayCells::Draw(const CellDrawing& drawing)
{
  if (this->Voxels.CanDraw(drawing))
  {
    this->NumberOfLayers = 1;
    return this->Voxels.Draw(drawing);
  }
  const MovedView moved(drawing.View, *drawing.Options.Eye);
  const CellDrawing fromStart = { drawing.Window, drawing.Viewport, moved.View, drawing.Options,
    drawing.Buffers, drawing.Contours, drawing.Depth, drawing.Peel, drawing.Range };
  return this->DrawFrom(fromStart);
}

std::string RayCells::DrawOwned(const CellDrawing& drawing, vtkTextureObject* owners, int owner)
{
  if (this->Voxels.CanDraw(drawing))
  {
    return this->Voxels.Draw(drawing, owners, owner);
  }
  this->Entries.SetOwners(owners, owner);
  return this->DrawFrom(drawing);
}

std::string RayCells::DrawFrom(const CellDrawing& drawing)
{
  this->Entries.Allocate(drawing);
  if (!this->Entries.ReadyProgram(drawing) || !this->ReadySegmentProgram(drawing))
  {
    return "the shaders did not compile";
  }
  this->Entries.Clear(drawing, 1);
  // Pixels without a new entry fail the depth test against the entries, before their shader starts.
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
    this->Entries.GetDepth()->GetHandle(), 0);
  const EyeTetrahedron& eye = *drawing.Options.Eye;
  if (this->StartsAtEye(eye))
  {
    this->DrawSegments(drawing, fromEye, eye);
    for (const EyeTetrahedron& other : eye.Overlapping)
    {
      this->DrawSegments(drawing, fromEye, other);
    }
  }
  this->DrawLayers(drawing);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  drawing.Finish();
  return std::string();
}

bool RayCells::StartsAtEye(const EyeTetrahedron& eye) const
{
  return eye.Found &&
    (this->Grid.IsEmpty() ||
      this->Box.Contains(eye.Place)); // otherwise rays enter the box from outside
}

// The first layers from all faces; where there are more, slice by slice.
void RayCells::DrawLayers(const CellDrawing& drawing)
{
  this->NumberOfLayers = 0;
  constexpr int unsliced = 4; // even: the last one's entries are then those of number 1
  for (int layer = 0; layer < unsliced; ++layer)
  {
    const int into = layer % 2;
    if (!this->Entries.Draw(drawing, into, 1 - into, nullptr))
    {
      return;
    }
    this->DrawSegments(drawing, into, *drawing.Options.Eye);
    ++this->NumberOfLayers;
  }
  this->Entries.SliceFaces(drawing);
  for (const FaceSlices::Slice& slice : this->Entries.GetSlices())
  {
    int into = 0, last = RayEntries::Passed;
    for (int layer = 0; layer < maximumLayers && this->Entries.Draw(drawing, into, last, &slice);
         ++layer)
    {
      this->DrawSegments(drawing, into, *drawing.Options.Eye);
      ++this->NumberOfLayers;
      last = into;
      into = 2 - into;
    }
  }
}

void RayCells::SetTopology(vtkShaderProgram* program, int instance)
{
  const auto name = [=](const char* uniform) { return InstanceName(uniform, instance); };
  program->SetUniformi(name("boundaryFaces"), this->BoundaryFaces.Activate());
  program->SetUniform2f(name("clearRange"), this->ClearRange.data());
  if (program->IsUniformUsed(name("clearDistances")))
  {
    program->SetUniformi(name("clearDistances"), this->Voxels.GetClearDistances().Activate());
  }
  if (program->IsUniformUsed(name("hiddenCells")))
  {
    program->SetUniformi(name("hiddenCells"), this->HiddenCells.Activate());
  }
  program->SetUniformi(name("maximumSteps"), maximumSteps);
  if (this->Grid.IsEmpty())
  {
    program->SetUniformi(
      name(this->HasHexahedra ? "neighbors" : "tetrahedronLinks"), this->Neighbors.Activate());
    if (this->HasHexahedra)
    {
      program->SetUniformi(name("hexahedra"), this->Hexahedra.Activate());
    }
    return;
  }
  const int stride[3] = { 1, this->Grid.Size[0], this->Grid.Size[0] * this->Grid.Size[1] };
  float low[3], high[3];
  std::copy(this->Box.Low, this->Box.Low + 3, low);
  std::copy(this->Box.High, this->Box.High + 3, high);
  program->SetUniform1iv(name("gridStride"), 3, stride);
  program->SetUniform3f(name("boxLow"), low);
  program->SetUniform3f(name("boxHigh"), high);
  program->SetUniformi(name("wrapCells"), this->Grid.WrapCells);
}

void RayCells::DeactivateTopology()
{
  for (BufferTexture* buffer :
    { &this->Neighbors, &this->Hexahedra, &this->BoundaryFaces, &this->HiddenCells })
  {
    buffer->Deactivate();
  }
  this->Voxels.Deactivate();
}

void RayCells::SetWalk(const CellDrawing& drawing, vtkShaderProgram* program, int instance)
{
  this->SetRays(drawing, program, instance);
  if (this->Voxels.CanDraw(drawing))
  {
    this->Voxels.SetGrid(program, instance);
    return;
  }
  const EyeTetrahedron& eye = *drawing.Options.Eye;
  this->SetTopology(program, instance);
  this->SetEye(eye, program, instance);
  program->SetUniformi(InstanceName("startsAtEye", instance), this->StartsAtEye(eye) ? 1 : 0);
}

int RayCells::CountTextures() const
{
  return 2 + (this->Grid.IsEmpty() ? 1 : 0) + (this->HasHexahedra ? 1 : 0);
}

void RayCells::DrawSegments(const CellDrawing& drawing, int from, const EyeTetrahedron& eye)
{
  vtkOpenGLState* state = drawing.Window->GetState();
  from == fromEye ? state->vtkglDisable(GL_DEPTH_TEST) : state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_GREATER);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  // Under what is there already.
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  vtkShaderProgram* program = this->SegmentProgram;
  drawing.Window->GetShaderCache()->ReadyShaderProgram(program);
  this->VertexArray->Bind();
  drawing.SetUniforms(program);
  this->SetTopology(program);
  this->SetRays(drawing, program);
  program->SetUniformi("startsAtEye", from == fromEye);
  this->SetEye(eye, program);
  vtkTextureObject* entries = this->Entries.GetTexture(from == fromEye ? 0 : from);
  entries->Activate();
  program->SetUniformi("entryFaces", entries->GetTextureUnit());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  entries->Deactivate();
  this->DeactivateTopology();
}

void RayCells::SetRays(const CellDrawing& drawing, vtkShaderProgram* program, int instance)
{
  const auto name = [=](const char* uniform) { return InstanceName(uniform, instance); };
  RayGeometry rays(drawing.View);
  program->SetUniformMatrix3x3(name("rayPoint"), rays.Point().data());
  program->SetUniformMatrix3x3(name("rayDirection"), rays.Direction().data());
  float eye[3], eyeView[4];
  std::copy(drawing.View.EyeModel, drawing.View.EyeModel + 3, eye);
  program->SetUniform3f(name("eyeMC"), eye);
  std::copy(drawing.View.EyeView, drawing.View.EyeView + 4, eyeView);
  program->SetUniform4f(name("eyeVC"), eyeView);
}

void RayCells::SetEye(const EyeTetrahedron& eye, vtkShaderProgram* program, int instance)
{
  const auto name = [=](const char* uniform) { return InstanceName(uniform, instance); };
  program->SetUniform1iv(name("eyeVertices"), 4, eye.Vertices.data());
  program->SetUniform1iv(name("eyePlace"), 4, eye.Place.data());
  program->SetUniform1iv(name("eyeHexahedron"), 4, eye.Hexahedron.data());
  const float scalars[2] = { eye.Scalar, eye.Opacity };
  program->SetUniform2f(name("eyeScalars"), scalars);
  program->SetUniform4f(name("eyeWeights"), eye.Weights.data());
}

void RayCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Voxels.ReleaseGraphicsResources(window);
  for (BufferTexture* buffer :
    { &this->Neighbors, &this->Hexahedra, &this->BoundaryFaces, &this->HiddenCells })
  {
    buffer->Release(window);
  }
  this->Entries.ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->SegmentProgram = nullptr;
}

} // namespace nephoscope
