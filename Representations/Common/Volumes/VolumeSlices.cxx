// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "VolumeSlices.h"

#include "SavedState.h"
#include "SliceLightFragment.h"
#include "SliceRangesFragment.h"
#include "SliceSumsFragment.h"
#include "WholeViewport.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"

#include <algorithm>
#include <limits>

namespace nephoscope
{
namespace
{
VolumeSlices* current = nullptr;
constexpr double farAway = std::numeric_limits<double>::max();

/** Least and greatest distance from the eye's plane. */
struct Span
{
  double Near = std::numeric_limits<double>::max();
  double Far = -std::numeric_limits<double>::max();

  void Add(vtkCamera* camera, const vtkBoundingBox& box)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      double place[3];
      box.GetCorner(corner, place);
      double distance = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        distance +=
          (place[axis] - camera->GetPosition()[axis]) * camera->GetDirectionOfProjection()[axis];
      }
      this->Near = std::min(this->Near, distance);
      this->Far = std::max(this->Far, distance);
    }
  }
};

Span OverlapOf(vtkCamera* camera, const std::vector<VolumeSlices::Medium>& media)
{
  Span span;
  for (auto a = media.begin(); a != media.end(); ++a)
  {
    for (auto b = a + 1; b != media.end(); ++b)
    {
      vtkBoundingBox common = a->GetBox();
      if (common.IntersectBox(b->GetBox()))
      {
        span.Add(camera, common);
      }
    }
  }
  span.Near = std::max(span.Near, camera->GetClippingRange()[0]);
  span.Far = std::min(span.Far, camera->GetClippingRange()[1]);
  return span;
}

/** What the slices are divided by: distances from the eye's plane, and depths in [0, 1]. */
struct Division
{
  double Distance;
  float Depth;
};

/** In front of the span, in it, and behind it. */
std::vector<Division> Divide(vtkRenderer* renderer, const std::array<double, 2>& span, int count)
{
  vtkMatrix4x4* matrix = renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1, 1);
  std::vector<Division> divisions = { { -farAway, 0 } };
  for (int i = 0; i <= count && span[0] < span[1]; ++i)
  {
    const double distance = span[0] + (span[1] - span[0]) * i / count;
    const double depth = (matrix->GetElement(2, 3) - matrix->GetElement(2, 2) * distance) /
      (matrix->GetElement(3, 3) - matrix->GetElement(3, 2) * distance);
    divisions.push_back(
      { distance, static_cast<float>(std::min(std::max(0.5 + 0.5 * depth, 0.0), 1.0)) });
  }
  divisions.push_back({ farAway, 1 });
  return divisions;
}

class InTurn // Draw() may be left by an exception of an observer
{
public:
  explicit InTurn(VolumeSlices* slices) { current = slices; }
  ~InTurn() { current = nullptr; }
  InTurn(const InTurn&) = delete;
  InTurn& operator=(const InTurn&) = delete;
};

bool IsMoving(vtkRenderer* renderer)
{
  return renderer->GetRenderWindow()->GetDesiredUpdateRate() >= 1;
}
}

vtkBoundingBox VolumeSlices::Medium::GetBox() const
{
  vtkBoundingBox box;
  for (vtkVolume* volume : this->Volumes)
  {
    box.AddBounds(volume->GetBounds());
  }
  return box;
}

VolumeSlices::VolumeSlices() = default;
VolumeSlices::~VolumeSlices() = default;

VolumeSlices* VolumeSlices::GetCurrent()
{
  return current;
}

void VolumeSlices::Draw(vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes,
  const std::vector<Medium>& media, const Drawer& draw)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
  const SavedState saved(state);
  const VolumePeel::Request request = { volumes.front()->GetMapper(), volumes.front() };
  this->Peeled = VolumePeel::IsRequested(volumes.front());
  if (this->Peeled)
  {
    if (!this->Outer.FindRanges(window, request, this->Viewport))
    {
      return;
    }
    this->Source = this->Outer.GetRanges();
  }
  else
  {
    this->Depth.Copy(window, this->Viewport);
    this->Source = this->Depth.GetTexture();
  }
  this->FindSpans(renderer, media);
  this->Light.Begin(window, this->Viewport, 2); // clears
  this->Light.End(window);
  this->DrawSlices(renderer, volumes, draw);
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  if (this->Peeled)
  {
    this->Outer.Deliver(
      window, request, this->Viewport, this->Light.GetTexture(0), this->Light.GetTexture(1));
  }
  else
  {
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    this->Light.Overlay(window, this->Viewport);
  }
}

// Splats say where they are in their boxes.
void VolumeSlices::FindSpans(vtkRenderer* renderer, const std::vector<Medium>& media)
{
  const Span span = OverlapOf(renderer->GetActiveCamera(), media);
  this->Overlap = { span.Near, span.Far };
  DepthTiles tiles(renderer, this->Viewport);
  std::vector<VolumeSpans::Box> boxes;
  bool anyTiles = false;
  for (const Medium& medium : media)
  {
    const bool added = medium.AddTo && medium.AddTo(renderer, medium.Volumes.front(), tiles);
    boxes.push_back({ medium.GetBox(), added });
    anyTiles = anyTiles || added;
  }
  const bool areWorthwhile = VolumeSpans::AreWorthwhile(renderer, boxes) ||
    (anyTiles && tiles.GetFilling(span.Near, span.Far) < 0.5);
  this->Spanned =
    areWorthwhile ? this->Spans.Draw(renderer, boxes, tiles, this->Viewport) : nullptr;
}

// From front to back. Without a peel two slices are drawn at once, as the two ranges of a peel.
// Rays that lie in one volume at a time are drawn in the first and the last slice, of all depths
// (SliceRanges); the others have only what is between their planes.
void VolumeSlices::DrawSlices(
  vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes, const Drawer& draw)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const std::vector<Division> ends =
    Divide(renderer, this->Overlap, IsMoving(renderer) ? Count / 4 : Count);
  const std::size_t step = this->Peeled ? 1 : 2, last = ends.size() - 1;
  for (std::size_t i = 0; i < last; i += step)
  {
    const std::size_t next = this->Peeled ? i : std::min(i + 1, last);
    const Division &first = ends[i], &end = ends[std::min(next + 1, last)];
    this->Slice[0] = first.Depth;
    this->Slice[1] = ends[i + 1].Depth;
    this->Slice[2] = ends[next].Depth;
    this->Slice[3] = end.Depth;
    const bool within = !this->Spanned || (i > 0 && next + 1 < last);
    this->Front = i == 0;
    this->Distances = { within ? first.Distance : -farAway, within ? end.Distance : farAway };
    this->Depths =
      within ? std::array<float, 2>{ first.Depth, end.Depth } : std::array<float, 2>{ 0, 1 };
    this->Sums.Begin(window, this->Viewport, 2); // clears
    this->Sums.End(window);
    const InTurn turn(this);
    for (vtkVolume* volume : volumes)
    {
      window->GetState()->vtkglViewport(
        this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
      draw(renderer, volume);
    }
    this->Lay(window);
  }
}

vtkShaderProgram* VolumeSlices::ReadyRanges(vtkOpenGLRenderWindow* window, bool farthestDepth)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(wholeViewportVertex, SliceRangesFragment, "");
  if (program)
  {
    this->Source->Activate();
    program->SetUniformi("source", this->Source->GetTextureUnit());
    program->SetUniformi("haveSpans", this->Spanned != nullptr);
    if (this->Spanned)
    {
      this->Spanned->Activate();
      program->SetUniformi("spans", this->Spanned->GetTextureUnit());
      this->Spanned->Deactivate(); // units keep their textures until others are bound there
    }
    program->SetUniformi("ofPeel", this->Peeled);
    program->SetUniformi("farthestDepth", farthestDepth);
    program->SetUniform4f("slice", this->Slice);
    this->Source->Deactivate();
  }
  return program;
}

void VolumeSlices::Take(
  vtkOpenGLRenderWindow* window, vtkTextureObject* first, vtkTextureObject* second)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(wholeViewportVertex, SliceSumsFragment, "");
  if (!program)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  const SavedState saved(state);
  this->Sums.Begin(window, this->Viewport, 2, nullptr, FloatAccumulation::Keep);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  first->Activate();
  second->Activate();
  program->SetUniformi("firstLight", first->GetTextureUnit());
  program->SetUniformi("secondLight", second->GetTextureUnit());
  DrawWholeViewport(this->VertexArray);
  first->Deactivate();
  second->Deactivate();
  this->Sums.End(window);
}

// Below the light of the slices before.
void VolumeSlices::Lay(vtkOpenGLRenderWindow* window)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(wholeViewportVertex, SliceLightFragment, "");
  if (!program)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  this->Light.Begin(window, this->Viewport, 2, nullptr, FloatAccumulation::Keep);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  vtkTextureObject *first = this->Sums.GetTexture(0), *second = this->Sums.GetTexture(1);
  first->Activate();
  second->Activate();
  program->SetUniformi("firstSums", first->GetTextureUnit());
  program->SetUniformi("secondSums", second->GetTextureUnit());
  program->SetUniformi("ofPeel", this->Peeled);
  DrawWholeViewport(this->VertexArray);
  first->Deactivate();
  second->Deactivate();
  this->Light.End(window);
}

void VolumeSlices::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Outer.ReleaseGraphicsResources(window);
  this->Spans.ReleaseGraphicsResources(window);
  this->Depth.ReleaseGraphicsResources(window);
  this->Sums.ReleaseGraphicsResources(window);
  this->Light.ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
}

} // namespace nephoscope
