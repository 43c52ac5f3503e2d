// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "RayCells.h"

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "CellGeometry.h"
#include "EyeTetrahedron.h"
#include "RayGeometry.h"
#include "ShaderText.h"
#include "TetrahedronNeighbors.h"

#include "ChessboardTopologyShader.h"
#include "EntryFacesFragment.h"
#include "EntryFacesVertex.h"
#include "NeighborTopologyShader.h"
#include "RayCellsFragment.h"
#include "RayCellsVertex.h"
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

namespace nephoscope
{
namespace
{
// Layers of mesh that a ray may enter; and tetrahedra between entering and leaving.
constexpr int maximumLayers = 1024;
constexpr int maximumSteps = 1 << 16;

std::string withParts(const char* shader, const std::string& constants, bool structured)
{
  const std::string walk = withShaderParts(shader,
    { { "Topology", structured ? ChessboardTopologyShader : NeighborTopologyShader },
      { "TetrahedronWalk", TetrahedronWalkShader },
      { "RaySegments", RaySegmentsShader } });
  return specializedShader(walk, constants);
}
}

RayCells::RayCells() = default;
RayCells::~RayCells() = default;

std::string RayCells::UploadGeometry(
  vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const TetrahedronNeighbors& neighbors)
{
  this->Grid = geometry.Grid;
  this->Radius = geometry.Radius();
  this->HasHiddenCells = !geometry.HiddenCells.empty();
  std::string error;
  const auto upload = [&](BufferTexture& buffer, const auto& values, int components, int type) {
    if (error.empty())
    {
      error = buffer.Upload(window, values.data(), values.size(), components, type);
    }
  };
  upload(this->Neighbors, neighbors.Neighbors, 1, VTK_INT);
  upload(this->VertexSums, neighbors.VertexSums, 1, VTK_INT);
  upload(this->HiddenCells, geometry.HiddenCells, 1, VTK_UNSIGNED_CHAR);
  return error;
}

std::string RayCells::UploadBoundary(vtkOpenGLRenderWindow* window, const std::vector<BoundaryFace>& faces,
  const CellBox& box, const std::array<float, 2>& clearRange)
{
  constexpr std::size_t exactInFloat = std::size_t(1) << 24;
  if (faces.size() >= exactInFloat)
  {
    return "the mesh has more boundary faces than can be numbered; distribute it over more ranks";
  }
  this->Box = box;
  this->ClearRange = clearRange;
  this->NumberOfBoundaryFaces = faces.size();
  std::vector<std::int32_t> vertices;
  vertices.reserve(3 * faces.size());
  for (const BoundaryFace& face : faces)
  {
    vertices.insert(vertices.end(), face.begin(), face.begin() + 3);
  }
  this->BoundaryVertices->ReleaseGraphicsResources();
  this->BoundaryVertices->Upload(vertices, vtkOpenGLBufferObject::ElementArrayBuffer);
  return this->BoundaryFaces.Upload(window, faces.data(), faces.size(), 4, VTK_INT);
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

std::string RayCells::ReadyPrograms(const CellDrawing& drawing)
{
  const bool structured = !this->Grid.IsEmpty();
  const std::string constants = drawing.Buffers.SmallTableDefinition() + drawing.ShaderConstants() +
    shaderConstant("hasHiddenCells", this->HasHiddenCells) +
    shaderConstant("closedGrid", this->Box.IsClosed(this->Grid));
  vtkOpenGLShaderCache* cache = drawing.Window->GetShaderCache();
  this->EntryProgram = cache->ReadyShaderProgram(EntryFacesVertex, EntryFacesFragment, "");
  this->SegmentProgram = cache->ReadyShaderProgram(
    RayCellsVertex, withParts(RayCellsFragment, constants, structured).c_str(), "");
  return this->EntryProgram && this->SegmentProgram ? std::string() : "the shaders did not compile";
}

std::string RayCells::Draw(const CellDrawing& drawing)
{
  this->Allocate(drawing);
  const std::string error = this->ReadyPrograms(drawing);
  if (!error.empty())
  {
    return error;
  }
  const float none[4] = { -1, -1, 0, 0 }; // in front of all
  drawing.Window->GetState()->PushFramebufferBindings();
  this->EntryFramebuffer->Bind();
  this->EntryFramebuffer->AddColorAttachment(0, this->Entries[1]);
  this->EntryFramebuffer->ActivateDrawBuffer(0);
  glClearBufferfv(GL_COLOR, 0, none); // no last entries
  drawing.Window->GetState()->PopFramebufferBindings();
  if (drawing.Options.Eye->Found)
  {
    this->DrawSegments(drawing, -1);
  }
  for (int layer = 0; layer < maximumLayers && this->DrawEntries(drawing, layer); ++layer)
  {
    this->DrawSegments(drawing, layer);
  }
  drawing.Finish();
  return std::string();
}

void RayCells::SetTopology(vtkShaderProgram* program)
{
  program->SetUniformi("boundaryFaces", this->BoundaryFaces.Activate());
  program->SetUniform2f("clearRange", this->ClearRange.data());
  if (this->Grid.IsEmpty())
  {
    program->SetUniformi("neighbors", this->Neighbors.Activate());
    program->SetUniformi("vertexSums", this->VertexSums.Activate());
    return;
  }
  const int stride[3] = { 1, this->Grid.Size[0], this->Grid.Size[0] * this->Grid.Size[1] };
  float low[3], high[3];
  std::copy(this->Box.Low, this->Box.Low + 3, low);
  std::copy(this->Box.High, this->Box.High + 3, high);
  program->SetUniform1iv("gridStride", 3, stride);
  program->SetUniform3f("boxLow", low);
  program->SetUniform3f("boxHigh", high);
  program->SetUniformi("wrapCells", this->Grid.WrapCells);
}

// Returns false when no ray enters any more.
bool RayCells::DrawEntries(const CellDrawing& drawing, int layer)
{
  vtkOpenGLState* state = drawing.Window->GetState();
  state->PushFramebufferBindings();
  this->EntryFramebuffer->Bind();
  this->EntryFramebuffer->AddColorAttachment(0, this->Entries[layer % 2]);
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
  this->VertexArray->Bind(); // without attributes
  drawing.SetUniforms(program);
  const RayGeometry rays(drawing.View);
  program->SetUniform2f("depthRange", rays.DepthRange(this->Radius).data());
  vtkTextureObject* last = this->Entries[1 - layer % 2];
  last->Activate();
  program->SetUniformi("lastEntries", last->GetTextureUnit());

  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP); // rays enter in front of the near plane too
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(GL_BACK);
  glFrontFace(drawing.View.ModelToView->Determinant() < 0 ? GL_CW : GL_CCW);
  GLuint query = 0, any = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  this->BoundaryVertices->Bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * this->NumberOfBoundaryFaces), GL_UNSIGNED_INT, nullptr);
  this->BoundaryVertices->Release();
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &any);
  glDeleteQueries(1, &query);
  glFrontFace(GL_CCW);
  state->vtkglDisable(GL_CULL_FACE);
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  this->VertexArray->Release();
  last->Deactivate();
  state->PopFramebufferBindings();
  return any != 0;
}

void RayCells::DrawSegments(const CellDrawing& drawing, int layer)
{
  vtkOpenGLState* state = drawing.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
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
  program->SetUniformi("startsAtEye", layer < 0);
  this->SetEye(*drawing.Options.Eye, program);
  vtkTextureObject* entries = this->Entries[layer < 0 ? 0 : layer % 2];
  entries->Activate();
  program->SetUniformi("entryFaces", entries->GetTextureUnit());
  program->SetUniformi("hiddenCells", this->HiddenCells.Activate());
  program->SetUniformi("maximumSteps", maximumSteps);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  entries->Deactivate();
  this->HiddenCells.Deactivate();
  this->Neighbors.Deactivate();
  this->VertexSums.Deactivate();
  this->BoundaryFaces.Deactivate();
}

void RayCells::SetRays(const CellDrawing& drawing, vtkShaderProgram* program)
{
  RayGeometry rays(drawing.View);
  program->SetUniformMatrix3x3("rayPoint", rays.Point().data());
  program->SetUniformMatrix3x3("rayDirection", rays.Direction().data());
  float eye[3];
  std::copy(drawing.View.EyeModel, drawing.View.EyeModel + 3, eye);
  program->SetUniform3f("eyeMC", eye);
}

void RayCells::SetEye(const EyeTetrahedron& eye, vtkShaderProgram* program)
{
  program->SetUniform1iv("eyeVertices", 4, eye.Vertices.data());
  program->SetUniform1iv("eyePlace", 4, eye.Place.data());
  const float scalars[2] = { eye.Scalar, eye.Opacity };
  program->SetUniform2f("eyeScalars", scalars);
}

void RayCells::ReleaseGraphicsResources(vtkWindow* window)
{
  for (BufferTexture* buffer : { &this->Neighbors, &this->VertexSums, &this->BoundaryFaces, &this->HiddenCells })
  {
    buffer->Release(window);
  }
  for (auto& entries : this->Entries)
  {
    entries->ReleaseGraphicsResources(window);
  }
  this->EntryDepth->ReleaseGraphicsResources(window);
  this->EntryFramebuffer->ReleaseGraphicsResources(window);
  this->BoundaryVertices->ReleaseGraphicsResources();
  this->VertexArray->ReleaseGraphicsResources();
  this->EntryProgram = this->SegmentProgram = nullptr;
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
