// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "SurfaceLayers.h"

#include "DrawnQuery.h"
#include "SavedState.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

namespace nephoscope
{
namespace
{
constexpr float noLayer = -1e30f; // as the shaders have it
}

SurfaceLayers::SurfaceLayers() = default;
SurfaceLayers::~SurfaceLayers() = default;

vtkTextureObject* SurfaceLayers::Image(const Request& request, Images& images, int drawing)
{
  while (static_cast<int>(images.size()) <= drawing)
  {
    auto image = vtkSmartPointer<vtkTextureObject>::New();
    image->SetContext(request.Window);
    image->Allocate2D(static_cast<unsigned int>(request.Size[0]),
      static_cast<unsigned int>(request.Size[1]), 4, VTK_FLOAT);
    image->SetMinificationFilter(vtkTextureObject::Nearest);
    image->SetMagnificationFilter(vtkTextureObject::Nearest);
    images.push_back(image);
  }
  return images[static_cast<std::size_t>(drawing)];
}

bool SurfaceLayers::Draw(const Request& request, const Painter& paint)
{
  if (this->Size[0] != request.Size[0] || this->Size[1] != request.Size[1])
  {
    this->ReleaseGraphicsResources(request.Window);
    this->Framebuffer->SetContext(request.Window);
    this->Size[0] = request.Size[0];
    this->Size[1] = request.Size[1];
  }
  vtkOpenGLState* state = request.Window->GetState();
  const SavedState saved(state);
  vtkOpenGLState::ScopedglColorMask savedMask(state);
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->SetState(request);
  const bool done = this->DrawAll(request, paint);
  state->PopFramebufferBindings();
  return done;
}

void SurfaceLayers::SetState(const Request& request)
{
  vtkOpenGLState* state = request.Window->GetState();
  state->vtkglViewport(0, 0, request.Size[0], request.Size[1]);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MAX);
  state->vtkglDepthMask(GL_FALSE);
  // With densities back faces just behind what is opaque are wanted: the shader looks at its depth
  // itself.
  if (request.WithDensities)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
    this->Framebuffer->RemoveDepthAttachment();
  }
  else
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LESS);
    this->Framebuffer->AddDepthAttachment(request.OpaqueDepth);
  }
}

bool SurfaceLayers::DrawAll(const Request& request, const Painter& paint)
{
  this->NumberOfDrawings = 0;
  this->More = false;
  if (!this->Attach(this->Image(request, this->Depths, 0)))
  {
    return false;
  }
  while (this->NumberOfDrawings < request.Limit &&
    this->DrawDepths(request, paint, this->NumberOfDrawings))
  {
    if (request.WithDensities)
    {
      this->DrawDensities(request, paint, this->NumberOfDrawings);
    }
    ++this->NumberOfDrawings;
  }
  this->More = this->NumberOfDrawings == request.Limit && this->AnyLeft(request, paint);
  return true;
}

bool SurfaceLayers::Attach(vtkTextureObject* image)
{
  this->Framebuffer->AddColorAttachment(0, image);
  this->Framebuffer->ActivateDrawBuffer(0);
  glDrawBuffer(GL_COLOR_ATTACHMENT0); // vtkOpenGLState may think that it is so already
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool SurfaceLayers::DrawDepths(const Request& request, const Painter& paint, int drawing)
{
  this->Attach(this->Image(request, this->Depths, drawing));
  const float empty[4] = { noLayer, noLayer, noLayer, noLayer };
  glClearBufferfv(GL_COLOR, 0, empty);
  DrawnQuery query;
  paint({ drawing > 0 ? this->GetDepths(drawing - 1) : nullptr, nullptr });
  return query.End();
}

void SurfaceLayers::DrawDensities(const Request& request, const Painter& paint, int drawing)
{
  this->Attach(this->Image(request, this->Densities, drawing));
  const float empty[4] = { 0, 0, 0, 0 };
  glClearBufferfv(GL_COLOR, 0, empty);
  paint({ nullptr, this->GetDepths(drawing) });
}

// Drawn, but not written: any image other than that of the last drawing will do.
bool SurfaceLayers::AnyLeft(const Request& request, const Painter& paint)
{
  this->Attach(this->Image(request, this->Depths, request.Limit));
  request.Window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  DrawnQuery query;
  paint({ this->GetDepths(request.Limit - 1), nullptr });
  return query.End();
}

void SurfaceLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  for (Images* images : { &this->Depths, &this->Densities })
  {
    for (auto& image : *images)
    {
      image->ReleaseGraphicsResources(window);
    }
    images->clear();
  }
  this->Size[0] = this->Size[1] = this->NumberOfDrawings = 0;
}

} // namespace nephoscope
