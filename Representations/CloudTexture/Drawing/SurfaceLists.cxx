// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "SurfaceLists.h"

#include "SavedState.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <set>
#include <string>

namespace nephoscope
{
namespace
{
constexpr int largestRows = 4095; // numbers of nodes are exact in float
// Numbers above the heads.
constexpr int rowOfCount = 0, rowOfLongest = 1, rowOfCutWays = 2, rowsOfNumbers = 3;

void AllocateStorage(
  vtkTextureObject* image, vtkOpenGLRenderWindow* window, int width, int height, bool isFloat)
{
  image->SetContext(window);
  if (!isFloat)
  {
    image->SetInternalFormat(GL_R32UI);
    image->SetFormat(GL_RED_INTEGER);
    image->SetDataType(GL_UNSIGNED_INT);
  }
  image->Allocate2D(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
    isFloat ? 4 : 1, isFloat ? VTK_FLOAT : VTK_UNSIGNED_INT);
  image->SetMinificationFilter(vtkTextureObject::Nearest);
  image->SetMagnificationFilter(vtkTextureObject::Nearest);
}
}

SurfaceLists::SurfaceLists() = default;
SurfaceLists::~SurfaceLists() = default;

// By extension, not by version: a driver may give a context of the version asked for, 3.2, with all
// that it can do beside.
bool SurfaceLists::IsSupported()
{
  const std::set<std::string> needed = { "GL_ARB_shader_image_load_store",
    "GL_ARB_shading_language_420pack" };
  std::set<std::string> found;
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
    if (name && needed.count(name) > 0)
    {
      found.insert(name);
    }
  }
  return found == needed && glBindImageTexture && glMemoryBarrier;
}

void SurfaceLists::Allocate(const SurfaceLayers::Request& request, int rows)
{
  const bool fits = this->Size[0] == request.Size[0] && this->Size[1] == request.Size[1];
  if (!fits)
  {
    this->ReleaseGraphicsResources(request.Window);
    this->HeadsFramebuffer->SetContext(request.Window);
    this->Framebuffer->SetContext(request.Window);
    AllocateStorage(
      this->Heads, request.Window, request.Size[0], request.Size[1] + rowsOfNumbers, false);
    std::copy_n(request.Size, 2, this->Size);
  }
  if (rows > this->Rows)
  {
    this->Nodes->ReleaseGraphicsResources(request.Window);
    AllocateStorage(this->Nodes, request.Window, Columns, rows, true);
    this->Rows = rows;
  }
}

bool SurfaceLists::Draw(const SurfaceLayers::Request& request, const std::function<void()>& paint)
{
  const int pixels = request.Size[0] * request.Size[1];
  this->Allocate(request, std::max(this->Rows, std::min(largestRows, pixels / Columns + 1)));
  vtkOpenGLState* state = request.Window->GetState();
  const SavedState saved(state);
  state->PushFramebufferBindings();
  int count = 0;
  bool done = this->Fill(request, paint, count);
  if (done && count > this->Rows * Columns && this->Rows < largestRows)
  {
    this->Allocate(request, std::min(largestRows, count / Columns + count / Columns / 4 + 1));
    done = this->Fill(request, paint, count);
  }
  state->PopFramebufferBindings();
  return done && count <= this->Rows * Columns;
}

bool SurfaceLists::Fill(
  const SurfaceLayers::Request& request, const std::function<void()>& paint, int& count)
{
  this->HeadsFramebuffer->Bind();
  this->HeadsFramebuffer->AddColorAttachment(0, this->Heads);
  this->HeadsFramebuffer->ActivateDrawBuffer(0);
  glDrawBuffer(GL_COLOR_ATTACHMENT0); // vtkOpenGLState may think that it is so already
  request.Window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  const GLuint none[4] = { 0, 0, 0, 0 };
  glClearBufferuiv(GL_COLOR, 0, none);

  this->Framebuffer->Bind();
  this->Framebuffer->AddDepthAttachment(request.OpaqueDepth);
  this->Framebuffer->DeactivateDrawBuffers();
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    return false;
  }
  this->SetState(request);
  this->PaintImages(paint);

  count = this->ReadNumber(rowOfCount);
  return true;
}

void SurfaceLists::PaintImages(const std::function<void()>& paint)
{
  glBindImageTexture(0, this->Heads->GetHandle(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  glBindImageTexture(1, this->Nodes->GetHandle(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  paint();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  glBindImageTexture(1, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
}

bool SurfaceLists::Rewrite(const SurfaceLayers::Request& request, int parts,
  const std::function<void(int face, int part)>& paint)
{
  vtkOpenGLState* state = request.Window->GetState();
  const SavedState saved(state);
  state->PushFramebufferBindings();
  this->HeadsFramebuffer->Bind();
  this->HeadsFramebuffer->DeactivateDrawBuffers();
  this->SetState(request);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  this->PaintImages([&]() {
    int longest = 1;
    for (int part = 0; part < parts; ++part)
    {
      for (int face = 0; face < longest; ++face)
      {
        paint(face, part);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
        longest = face == 0 && part == 0 ? this->ReadNumber(rowOfLongest) : longest;
      }
    }
  });
  const bool isWhole = this->ReadNumber(rowOfCutWays) != parts;
  state->PopFramebufferBindings();
  return isWhole;
}

int SurfaceLists::ReadNumber(int row)
{
  this->HeadsFramebuffer->Bind();
  this->HeadsFramebuffer->ActivateReadBuffer(0);
  GLuint number = 0;
  glReadPixels(0, this->Size[1] + row, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &number);
  return static_cast<int>(number);
}

void SurfaceLists::SetState(const SurfaceLayers::Request& request)
{
  vtkOpenGLState* state = request.Window->GetState();
  state->vtkglViewport(0, 0, request.Size[0], request.Size[1]);
  request.OnlyFaces ? state->vtkglEnable(GL_CULL_FACE) : state->vtkglDisable(GL_CULL_FACE);
  if (request.OnlyFaces)
  {
    state->vtkglCullFace(request.OnlyFaces == GL_BACK ? GL_FRONT : GL_BACK);
  }
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LESS);
  // With densities the back face just behind what is opaque is wanted, too.
  request.WithDensities ? state->vtkglDisable(GL_DEPTH_TEST) : state->vtkglEnable(GL_DEPTH_TEST);
}

void SurfaceLists::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("nodesInRow", Columns);
  program->SetUniformi("rowsOfNodes", this->Rows);
  program->SetUniformi("rowOfNumber", this->Size[1] + rowOfCount);
}

void SurfaceLists::ReleaseGraphicsResources(vtkWindow* window)
{
  this->HeadsFramebuffer->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Heads->ReleaseGraphicsResources(window);
  this->Nodes->ReleaseGraphicsResources(window);
  this->Size[0] = this->Size[1] = this->Rows = 0;
}

} // namespace nephoscope
