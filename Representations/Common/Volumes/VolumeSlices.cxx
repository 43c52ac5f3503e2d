// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "VolumeSlices.h"

#include "SavedState.h"
#include "SliceLightFragment.h"
#include "SliceRangesFragment.h"
#include "SliceSumsFragment.h"
#include "SlicesShader.h"
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
#include <string>

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

/** Distances from the eye's plane in front of the span, in it, and behind it; depths in [0, 1]. */
template <class Division>
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

/** For shaders: how many slices there are, what is done for each, and their outputs. */
std::string Macros(int count)
{
  std::string each = "#define EACH_SLICE(what)", put = "#define PUT_SLICES(colors)";
  for (int i = 0; i < count; ++i)
  {
    const std::string number = std::to_string(i);
    each += " what(" + number + ")";
    put += " gl_FragData[" + number + "] = colors[" + number + "];";
  }
  return "#define SLICES " + std::to_string(count) + "\n" + each + "\n" + put + "\n";
}

std::vector<vtkTextureObject*> LayersOf(const FloatAccumulation& image)
{
  std::vector<vtkTextureObject*> layers;
  for (int i = 0; i < VolumeSlices::PerPass; ++i)
  {
    layers.push_back(image.GetTexture(i));
  }
  return layers;
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

/** What the slices are divided by. */
struct VolumeSlices::Division
{
  double Distance; // from the eye's plane
  float Depth;
};

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
  for (this->Range = 0; this->Range < (this->Peeled ? 2 : 1); ++this->Range)
  {
    this->Light[this->Range].Begin(window, this->Viewport); // clears
    this->Light[this->Range].End(window);
    this->DrawSlices(renderer, media, draw);
  }
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  if (this->Peeled)
  {
    this->Outer.Deliver(
      window, request, this->Viewport, this->Light[0].GetTexture(0), this->Light[1].GetTexture(0));
  }
  else
  {
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    this->Light[0].Overlay(window, this->Viewport);
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

// From front to back. Rays that lie in one volume at a time are drawn in the first and the last
// slice, of all depths (SliceRanges); the others have only what is between their planes.
void VolumeSlices::DrawSlices(
  vtkRenderer* renderer, const std::vector<Medium>& media, const Drawer& draw)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int passes = IsMoving(renderer) ? PassesInMotion : Passes;
  const std::vector<Division> ends =
    Divide<Division>(renderer, this->Overlap, passes * PerPass - 2);
  for (std::size_t first = 0; first + 1 < ends.size(); first += PerPass)
  {
    this->Sums.Begin(window, this->Viewport, PerPass); // clears
    this->Sums.End(window);
    for (const Medium& medium : media)
    {
      this->DrawPass(renderer, medium, ends, first, draw);
    }
    FloatAccumulation& light = this->Light[this->Range];
    light.Begin(window, this->Viewport, 1, nullptr, FloatAccumulation::Keep);
    window->GetState()->vtkglBlendFuncSeparate(
      GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE); // below what is there
    this->Draw(window, SliceLightFragment, LayersOf(this->Sums));
    light.End(window);
  }
}

void VolumeSlices::DrawPass(vtkRenderer* renderer, const Medium& medium,
  const std::vector<Division>& ends, std::size_t first, const Drawer& draw)
{
  vtkOpenGLState* state =
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
  const InTurn turn(this);
  for (this->First = 0; this->First < PerPass; this->First += medium.SlicesAtOnce)
  {
    this->SelectSlices(ends, first + static_cast<std::size_t>(this->First), medium.SlicesAtOnce);
    for (vtkVolume* volume : medium.Volumes)
    {
      state->vtkglViewport(
        this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
      draw(renderer, volume);
    }
  }
}

void VolumeSlices::SelectSlices(const std::vector<Division>& ends, std::size_t first, int count)
{
  const std::size_t last = ends.size() - 1;
  const auto at = [&](int i) { return ends[std::min(first + static_cast<std::size_t>(i), last)]; };
  for (int i = 0; i <= count; ++i)
  {
    this->Ends[i] = at(i).Depth;
  }
  this->AtOnce = count;
  this->Front = first == 0;
  const bool within =
    !this->Spanned || (!this->Front && first + static_cast<std::size_t>(count) < last);
  this->Distances = { within ? at(0).Distance : -farAway, within ? at(count).Distance : farAway };
  this->Depths =
    within ? std::array<float, 2>{ at(0).Depth, at(count).Depth } : std::array<float, 2>{ 0, 1 };
}

std::string VolumeSlices::Definition()
{
  return current ? "#define IN_SLICES\n" + Macros(PerPass) + SlicesShader : std::string();
}

void VolumeSlices::SetUniforms(vtkShaderProgram* program)
{
  if (current)
  {
    program->SetUniform1fv("sliceDepths", PerPass + 1, current->Ends);
  }
}

vtkShaderProgram* VolumeSlices::ReadyRanges(vtkOpenGLRenderWindow* window, bool farthestDepth)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(wholeViewportVertex, SliceRangesFragment, "");
  if (!program)
  {
    return nullptr;
  }
  vtkTextureObject* lightBefore = this->Light[this->Range].GetTexture(0);
  vtkTextureObject* spans = this->Spanned ? this->Spanned : this->Source;
  this->Source->Activate();
  spans->Activate();
  lightBefore->Activate();
  program->SetUniformi("source", this->Source->GetTextureUnit());
  program->SetUniformi("haveSpans", this->Spanned != nullptr);
  program->SetUniformi("spans", spans->GetTextureUnit());
  program->SetUniformi("lightBefore", lightBefore->GetTextureUnit());
  program->SetUniformi("ofPeel", this->Peeled);
  program->SetUniformi("rangeOfPeel", this->Range);
  program->SetUniformi("farthestDepth", farthestDepth);
  program->SetUniformi("inPairs", this->AtOnce == 2);
  const float ends[3] = { this->Ends[0], this->Ends[1], this->Ends[this->AtOnce] };
  program->SetUniform3f("ends", ends);
  lightBefore->Deactivate(); // units keep their textures until others are bound there
  spans->Deactivate();
  this->Source->Deactivate();
  return program;
}

std::string VolumeSlices::DrawAtOnce(
  vtkOpenGLRenderWindow* window, const std::function<std::string()>& cast)
{
  const std::string error = this->Image.Begin(window, this->Viewport, PerPass)
    ? cast()
    : "this OpenGL cannot draw into 32-bit float images";
  this->Image.End(window);
  if (error.empty())
  {
    this->Take(window, LayersOf(this->Image));
  }
  return error;
}

void VolumeSlices::Take(vtkOpenGLRenderWindow* window, const std::vector<vtkTextureObject*>& lights)
{
  const SavedState saved(window->GetState());
  this->Sums.Begin(window, this->Viewport, static_cast<int>(lights.size()), nullptr,
    FloatAccumulation::Keep, this->First);
  window->GetState()->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->Draw(window, SliceSumsFragment, lights);
  this->Sums.End(window);
}

void VolumeSlices::Draw(
  vtkOpenGLRenderWindow* window, const char* shader, const std::vector<vtkTextureObject*>& textures)
{
  const int count = static_cast<int>(textures.size());
  std::string fragment = shader;
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Output::Dec", "//VTK::Output::Dec\n" + Macros(count));
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(wholeViewportVertex, fragment.c_str(), "");
  if (!program)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  std::vector<int> units;
  for (vtkTextureObject* texture : textures)
  {
    texture->Activate();
    units.push_back(texture->GetTextureUnit());
  }
  program->SetUniform1iv("slices", count, units.data());
  DrawWholeViewport(this->VertexArray);
  for (vtkTextureObject* texture : textures)
  {
    texture->Deactivate();
  }
}

void VolumeSlices::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Outer.ReleaseGraphicsResources(window);
  this->Spans.ReleaseGraphicsResources(window);
  this->Depth.ReleaseGraphicsResources(window);
  this->Image.ReleaseGraphicsResources(window);
  this->Sums.ReleaseGraphicsResources(window);
  this->Light[0].ReleaseGraphicsResources(window);
  this->Light[1].ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
}

} // namespace nephoscope
