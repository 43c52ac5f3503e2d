// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "RayEntries.h"

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "CellGeometry.h"
#include "RayGeometry.h"
#include "ShaderText.h"

#include "EntryFacesFragment.h"
#include "EntryFacesVertex.h"

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

RayEntries::RayEntries() = default;
RayEntries::~RayEntries() = default;

void RayEntries::SetFaces(
  const CellGeometry& geometry, const std::vector<BoundaryFace>& faces, std::size_t count)
{
  this->NumberOfFaces = count;
  this->Radius = geometry.Radius();
  this->Bounds = PointBounds();
  std::vector<std::int32_t> vertices;
  vertices.reserve(6 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      vertices.insert(vertices.end(), { faces[i][corner], static_cast<std::int32_t>(i) });
      this->Bounds.Add(geometry.Position(faces[i][corner]));
    }
  }
  this->Vertices.Upload(vertices, 2);
  this->Slices.SetFaces(geometry, faces, count);
}

std::array<float, 2> RayEntries::DepthRange(const SceneView& view) const
{
  return RayGeometry(view).DepthRange(this->Radius);
}

void RayEntries::Allocate(const CellDrawing& drawing)
{
  const int width = drawing.Viewport[2];
  const int height = drawing.Viewport[3];
  if (this->Depth->GetHandle() && this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  this->Framebuffer->SetContext(drawing.Window);
  for (auto& entries : this->Entries)
  {
    entries->SetContext(drawing.Window);
    entries->Allocate2D(width, height, 2, VTK_FLOAT);
    entries->SetMinificationFilter(vtkTextureObject::Nearest);
    entries->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  this->Depth->SetContext(drawing.Window);
  this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  this->Size[0] = width;
  this->Size[1] = height;
}

void RayEntries::SetOwners(vtkTextureObject* owners, int owner)
{
  this->Owners = owners;
  this->Owner = owner;
}

bool RayEntries::ReadyProgram(const CellDrawing& drawing)
{
  this->Program = drawing.Window->GetShaderCache()->ReadyShaderProgram(
    SpecializedShader(EntryFacesVertex, std::string()).c_str(),
    SpecializedShader(EntryFacesFragment,
      ShaderConstant("useDepthRanges", drawing.Peel != nullptr) +
        ShaderConstant("hasOwners", this->Owners != nullptr))
      .c_str(),
    "");
  return this->Program != nullptr;
}

void RayEntries::Clear(const CellDrawing& drawing, int number)
{
  const float none[4] = { -1, -1, 0, 0 }; // in front of all
  drawing.Window->GetState()->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Entries[number]);
  this->Framebuffer->ActivateDrawBuffer(0);
  glClearBufferfv(GL_COLOR, 0, none);
  drawing.Window->GetState()->PopFramebufferBindings();
}

void RayEntries::SliceFaces(const CellDrawing& drawing)
{
  const std::array<float, 2> range = this->DepthRange(drawing.View);
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

void RayEntries::DrawFaces(const FaceSlices::Slice* slice)
{
  if (!slice)
  {
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * this->NumberOfFaces));
    return;
  }
  this->SliceVertices->Bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(slice->Count), GL_UNSIGNED_INT,
    reinterpret_cast<const void*>(sizeof(std::uint32_t) * slice->First));
  this->SliceVertices->Release();
}

bool RayEntries::Draw(
  const CellDrawing& drawing, int into, int lastNumber, const FaceSlices::Slice* slice)
{
  vtkOpenGLState* state = drawing.Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Entries[into]);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDisable(GL_BLEND);
  const float none[4] = { -1, 2, 0, 0 }; // behind all: no entry next time
  const float far = 1.0f;
  glClearBufferfv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &far);

  vtkShaderProgram* program = this->Program;
  drawing.Window->GetShaderCache()->ReadyShaderProgram(program);
  this->VertexArray->Bind();
  drawing.SetUniforms(program);
  program->SetUniform2f("depthRange", this->DepthRange(drawing.View).data());
  vtkTextureObject* last = this->Entries[lastNumber];
  last->Activate();
  program->SetUniformi("lastEntries", last->GetTextureUnit());
  vtkTextureObject* passed = this->Entries[slice ? Passed : lastNumber];
  if (passed != last)
  {
    passed->Activate();
  }
  program->SetUniformi("passedEntries", passed->GetTextureUnit());
  if (this->Owners)
  {
    this->Owners->Activate();
    program->SetUniformi("pixelOwners", this->Owners->GetTextureUnit());
    program->SetUniformf("owner", static_cast<float>(this->Owner));
  }
  program->SetUniformi("isSliced", slice ? 1 : 0);
  const float range[2] = { slice ? slice->Low : 0.0f, slice ? slice->High : 0.0f };
  program->SetUniform2f("slice", range);
  this->Vertices.Activate(program, "pointAndFace");

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
  this->Vertices.Deactivate();
  this->VertexArray->Release();
  last->Deactivate();
  if (passed != last)
  {
    passed->Deactivate();
  }
  if (this->Owners)
  {
    this->Owners->Deactivate();
  }
  state->PopFramebufferBindings();
  return any != 0;
}

void RayEntries::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& entries : this->Entries)
  {
    entries->ReleaseGraphicsResources(window);
  }
  this->Vertices.Release();
  this->SliceVertices->ReleaseGraphicsResources();
  this->Depth->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
