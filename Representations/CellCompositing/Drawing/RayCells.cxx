// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "RayCells.h"

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "CellGeometry.h"
#include "ContourBuffers.h"
#include "EyeTetrahedron.h"
#include "MovedView.h"
#include "RayGeometry.h"
#include "ShaderInstance.h"
#include "ShaderText.h"
#include "TetrahedronNeighbors.h"

#include "CameraLightShader.h"
#include "ChessboardTopologyShader.h"
#include "CubicPiecesShader.h"
#include "EntryFacesFragment.h"
#include "EntryFacesVertex.h"
#include "GridHexahedraShader.h"
#include "HexahedronWalkShader.h"
#include "ListedHexahedraShader.h"
#include "NeighborTopologyShader.h"
#include "PixelRayShader.h"
#include "RayCellsFragment.h"
#include "RayCellsVertex.h"
#include "RayContoursShader.h"
#include "RayHexahedraFragment.h"
#include "RayMediumShader.h"
#include "RayRangeShader.h"
#include "RaySegmentsShader.h"
#include "TetrahedronWalkShader.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
// Layers of mesh that a ray may enter; and tetrahedra between entering and leaving.
constexpr int maximumLayers = 1024;
constexpr int maximumSteps = 1 << 16;

// Instead of numbers of entries: rays start at the eye.
constexpr int fromEye = -1;
// The entries that hold the last ones of the unsliced layers, while slices are drawn.
constexpr int passedEntries = 1;

std::string withParts(const std::string& shader, bool structured)
{
  return withShaderParts(shader,
    { { "Topology", structured ? ChessboardTopologyShader : NeighborTopologyShader },
      { "TetrahedronWalk", TetrahedronWalkShader }, { "RaySegments", RaySegmentsShader },
      { "RayRange", RayRangeShader }, { "PixelRay", PixelRayShader },
      { "RayContours", RayContoursShader }, { "CameraLight", CameraLightShader } });
}

std::string hexahedraShader(bool structured)
{
  return withShaderParts(RayHexahedraFragment,
    { { "Topology", structured ? GridHexahedraShader : ListedHexahedraShader },
      { "HexahedronWalk", HexahedronWalkShader }, { "CubicPieces", CubicPiecesShader },
      { "RaySegments", RaySegmentsShader }, { "RayRange", RayRangeShader },
      { "PixelRay", PixelRayShader } });
}
}

RayCells::RayCells() = default;
RayCells::~RayCells() = default;

std::string RayCells::UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
  const TetrahedronNeighbors& neighbors)
{
  this->Grid = geometry.Grid;
  this->Radius = geometry.Radius();
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
  if (this->HasHexahedra)
  {
    upload(this->Neighbors, neighbors.Neighbors, 1, VTK_INT);
    const std::size_t vertices = 8 * geometry.Hexahedra.size();
    error = error.empty()
      ? this->Hexahedra.Upload(window, geometry.Hexahedra.data(), vertices, 1, VTK_INT)
      : error;
  }
  else
  {
    const auto pairs = neighbors.WithNextVertices(geometry); // two in an element of the texture
    error = this->Neighbors.Upload(window, pairs.data(), pairs.size() / 2, 4, VTK_INT);
    this->Hexahedra.Release(window);
  }
  upload(this->VertexSums, neighbors.VertexSums, 1, VTK_INT);
  upload(this->HiddenCells, geometry.HiddenCells, 1, VTK_UNSIGNED_CHAR);
  return error.empty() ? this->Voxels.UploadScalars(window, geometry) : error;
}

std::string RayCells::UploadBoundary(vtkOpenGLRenderWindow* window,
  const std::vector<BoundaryFace>& faces, const CellGeometry& geometry, const CellBox& box,
  const std::array<float, 2>& clearRange)
{
  constexpr std::size_t exactInFloat = std::size_t(1) << 24;
  this->NumberOfBoundaryFaces = faces.size() - this->NumberOfJumps;
  if (this->NumberOfBoundaryFaces >= exactInFloat)
  {
    return "the mesh has more boundary faces than can be numbered; distribute it over more ranks";
  }
  this->Box = box;
  this->ClearRange = clearRange;
  this->Bounds = PointBounds();
  std::vector<std::int32_t> vertices;
  vertices.reserve(6 * this->NumberOfBoundaryFaces);
  for (std::size_t i = 0; i < this->NumberOfBoundaryFaces; ++i)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      vertices.insert(vertices.end(), { faces[i][corner], static_cast<std::int32_t>(i) });
      this->Bounds.Add(geometry.Position(faces[i][corner]));
    }
  }
  this->EntryVertices.Upload(vertices, 2);
  this->Slices.SetFaces(geometry, faces, this->NumberOfBoundaryFaces);
  return this->BoundaryFaces.Upload(window, faces.data(), faces.size(), 4, VTK_INT);
}

PixelRegion RayCells::FindRegion(
  const SceneView& view, const EyeTetrahedron& eye, const int viewport[4]) const
{
  return eye.Found ? PixelRegion{ { 0, 0, viewport[2], viewport[3] } }
                   : coveredPixels(view, this->Bounds, viewport);
}

void RayCells::Allocate(const CellDrawing& drawing)
{
  const int width = drawing.Viewport[2];
  const int height = drawing.Viewport[3];
  if (this->EntryDepth->GetHandle() && this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  this->EntryFramebuffer->SetContext(drawing.Window);
  for (auto& entries : this->Entries)
  {
    entries->SetContext(drawing.Window);
    entries->Allocate2D(width, height, 2, VTK_FLOAT);
    entries->SetMinificationFilter(vtkTextureObject::Nearest);
    entries->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->EntryDepth->SetContext(drawing.Window);
  this->EntryDepth->AllocateDepth(width, height, vtkTextureObject::Float32);
  this->Size[0] = width;
  this->Size[1] = height;
}

std::string RayCells::OwnConstants() const
{
  return shaderConstant("hasHiddenCells", this->HasHiddenCells) +
    shaderConstant("hasJumps", this->NumberOfJumps > 0) +
    shaderConstant("closedGrid", this->Box.IsClosed(this->Grid));
}

// In which the scalar is trilinear.
bool RayCells::DrawsHexahedra(const CellDrawing& drawing) const
{
  return this->HasHexahedra ||
    (drawing.Options.Trilinear && !this->Grid.IsEmpty() && !drawing.Contours.IsUsed() &&
      !drawing.Contours.HasPolygons() && !drawing.Buffers.HasLayers() &&
      !drawing.Buffers.HasOpacityScalars());
}

bool RayCells::ReadyEntryProgram(const CellDrawing& drawing)
{
  this->EntryProgram = drawing.Window->GetShaderCache()->ReadyShaderProgram(
    specializedShader(EntryFacesVertex, std::string()).c_str(),
    specializedShader(EntryFacesFragment, shaderConstant("useDepthRanges", drawing.Peel != nullptr))
      .c_str(),
    "");
  return this->EntryProgram != nullptr;
}

bool RayCells::ReadySegmentProgram(const CellDrawing& drawing)
{
  const std::string constants =
    drawing.Buffers.SmallTableDefinition() + drawing.ShaderConstants() + this->OwnConstants();
  const std::string text = this->DrawsHexahedra(drawing)
    ? hexahedraShader(!this->Grid.IsEmpty())
    : withParts(RayCellsFragment, !this->Grid.IsEmpty());
  this->SegmentProgram = drawing.Window->GetShaderCache()->ReadyShaderProgram(
    RayCellsVertex, specializedShader(text, constants).c_str(), "");
  return this->SegmentProgram != nullptr;
}

std::string RayCells::MediumShader(const CellDrawing& drawing, int instance) const
{
  const std::string walk = RayCellsFragment;
  const std::string constants = drawing.OwnConstants() + this->OwnConstants() +
    "const int mediumNumber = " + std::to_string(instance) + ";\n";
  const std::string text = walk.substr(0, walk.find("void main()")) + RayMediumShader;
  const auto without = [](const std::string& shader) { // what all media have in common
    return withShaderParts(
      shader, { { "Arrays", "" }, { "OpaqueDepth", "" }, { "OpticalSegment", "" } });
  };
  return shaderInstance(
    specializedShader(without(withParts(text, !this->Grid.IsEmpty())), constants), instance);
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

std::string RayCells::DrawFrom(const CellDrawing& drawing)
{
  this->Allocate(drawing);
  if (!this->ReadyEntryProgram(drawing) || !this->ReadySegmentProgram(drawing))
  {
    return "the shaders did not compile";
  }
  this->ClearEntries(drawing, 1);
  // Pixels without a new entry fail the depth test against the entries, before their shader starts.
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->EntryDepth->GetHandle(), 0);
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

// No last entries.
void RayCells::ClearEntries(const CellDrawing& drawing, int number)
{
  const float none[4] = { -1, -1, 0, 0 }; // in front of all
  drawing.Window->GetState()->PushFramebufferBindings();
  this->EntryFramebuffer->Bind();
  this->EntryFramebuffer->AddColorAttachment(0, this->Entries[number]);
  this->EntryFramebuffer->ActivateDrawBuffer(0);
  glClearBufferfv(GL_COLOR, 0, none);
  drawing.Window->GetState()->PopFramebufferBindings();
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
    if (!this->DrawEntries(drawing, into, 1 - into, nullptr))
    {
      return;
    }
    this->DrawSegments(drawing, into, *drawing.Options.Eye);
    ++this->NumberOfLayers;
  }
  this->SliceFaces(drawing);
  for (const FaceSlices::Slice& slice : this->Slices.GetSlices())
  {
    int into = 0, last = passedEntries;
    for (int layer = 0; layer < maximumLayers && this->DrawEntries(drawing, into, last, &slice);
         ++layer)
    {
      this->DrawSegments(drawing, into, *drawing.Options.Eye);
      ++this->NumberOfLayers;
      last = into;
      into = 2 - into;
    }
  }
}

void RayCells::SliceFaces(const CellDrawing& drawing)
{
  const std::array<float, 2> range = RayGeometry(drawing.View).DepthRange(this->Radius);
  const double scale = -1.0 / (double(range[1]) - range[0]);
  const vtkMatrix4x4* toView = drawing.View.ModelToView;
  const auto toZ = [&](int column) { return toView->GetElement(2, column); };
  const double rounding =
    8.0 * std::numeric_limits<float>::epsilon() * std::max(std::abs(range[0]), std::abs(range[1]));
  this->Slices.Sort(
    { { scale * toZ(0), scale * toZ(1), scale * toZ(2), scale * (toZ(3) + range[0]) } },
    -scale * rounding);
  this->SliceVertices->ReleaseGraphicsResources();
  this->SliceVertices->Upload(
    this->Slices.GetVertices(), vtkOpenGLBufferObject::ElementArrayBuffer);
}

void RayCells::DrawFaces(const FaceSlices::Slice* slice)
{
  if (!slice)
  {
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * this->NumberOfBoundaryFaces));
    return;
  }
  this->SliceVertices->Bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(slice->Count), GL_UNSIGNED_INT,
    reinterpret_cast<const void*>(sizeof(std::uint32_t) * slice->First));
  this->SliceVertices->Release();
}

void RayCells::SetTopology(vtkShaderProgram* program, int instance)
{
  const auto name = [=](const char* uniform) { return instanceName(uniform, instance); };
  program->SetUniformi(name("boundaryFaces"), this->BoundaryFaces.Activate());
  program->SetUniform2f(name("clearRange"), this->ClearRange.data());
  if (program->IsUniformUsed(name("hiddenCells")))
  {
    program->SetUniformi(name("hiddenCells"), this->HiddenCells.Activate());
  }
  program->SetUniformi(name("maximumSteps"), maximumSteps);
  if (this->Grid.IsEmpty())
  {
    program->SetUniformi(name("neighbors"), this->Neighbors.Activate());
    BufferTexture& vertices = this->HasHexahedra ? this->Hexahedra : this->VertexSums;
    program->SetUniformi(
      name(this->HasHexahedra ? "hexahedra" : "vertexSums"), vertices.Activate());
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
  for (BufferTexture* buffer : { &this->Neighbors, &this->VertexSums, &this->Hexahedra,
         &this->BoundaryFaces, &this->HiddenCells })
  {
    buffer->Deactivate();
  }
}

int RayCells::CountTextures() const
{
  return 1 + (this->HasHiddenCells ? 1 : 0) + (this->Grid.IsEmpty() ? 2 : 0);
}

// Those behind the last ones; returns false when no ray enters any more.
bool RayCells::DrawEntries(
  const CellDrawing& drawing, int into, int lastNumber, const FaceSlices::Slice* slice)
{
  vtkOpenGLState* state = drawing.Window->GetState();
  state->PushFramebufferBindings();
  this->EntryFramebuffer->Bind();
  this->EntryFramebuffer->AddColorAttachment(0, this->Entries[into]);
  this->EntryFramebuffer->AddDepthAttachment(this->EntryDepth);
  this->EntryFramebuffer->ActivateDrawBuffer(0);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDisable(GL_BLEND);
  const float none[4] = { -1, 2, 0, 0 }; // behind all: no entry next time
  const float far = 1.0f;
  glClearBufferfv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &far);

  vtkShaderProgram* program = this->EntryProgram;
  drawing.Window->GetShaderCache()->ReadyShaderProgram(program);
  this->VertexArray->Bind();
  drawing.SetUniforms(program);
  const RayGeometry rays(drawing.View);
  program->SetUniform2f("depthRange", rays.DepthRange(this->Radius).data());
  vtkTextureObject* last = this->Entries[lastNumber];
  last->Activate();
  program->SetUniformi("lastEntries", last->GetTextureUnit());
  vtkTextureObject* passed = this->Entries[slice ? passedEntries : lastNumber];
  if (passed != last)
  {
    passed->Activate();
  }
  program->SetUniformi("passedEntries", passed->GetTextureUnit());
  program->SetUniformi("isSliced", slice ? 1 : 0);
  const float range[2] = { slice ? slice->Low : 0.0f, slice ? slice->High : 0.0f };
  program->SetUniform2f("slice", range);
  this->EntryVertices.Activate(program, "pointAndFace");

  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP); // rays enter in front of the near plane too
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(GL_BACK);
  glFrontFace(drawing.View.ModelToView->Determinant() < 0 ? GL_CW : GL_CCW);
  GLuint query = 0, any = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  this->DrawFaces(slice);
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &any);
  glDeleteQueries(1, &query);
  glFrontFace(GL_CCW);
  state->vtkglDisable(GL_CULL_FACE);
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  this->EntryVertices.Deactivate();
  this->VertexArray->Release();
  last->Deactivate();
  if (passed != last)
  {
    passed->Deactivate();
  }
  state->PopFramebufferBindings();
  return any != 0;
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
  drawing.Buffers.SetSmallTable(program);
  this->SetRays(drawing, program);
  program->SetUniformi("startsAtEye", from == fromEye);
  this->SetEye(eye, program);
  vtkTextureObject* entries = this->Entries[from == fromEye ? 0 : from];
  entries->Activate();
  program->SetUniformi("entryFaces", entries->GetTextureUnit());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  entries->Deactivate();
  this->DeactivateTopology();
}

void RayCells::SetRays(const CellDrawing& drawing, vtkShaderProgram* program, int instance)
{
  const auto name = [=](const char* uniform) { return instanceName(uniform, instance); };
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
  const auto name = [=](const char* uniform) { return instanceName(uniform, instance); };
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
  for (BufferTexture* buffer : { &this->Neighbors, &this->VertexSums, &this->Hexahedra,
         &this->BoundaryFaces, &this->HiddenCells })
  {
    buffer->Release(window);
  }
  for (auto& entries : this->Entries)
  {
    entries->ReleaseGraphicsResources(window);
  }
  this->EntryVertices.Release();
  this->SliceVertices->ReleaseGraphicsResources();
  this->EntryDepth->ReleaseGraphicsResources(window);
  this->EntryFramebuffer->ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->EntryProgram = this->SegmentProgram = nullptr;
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
