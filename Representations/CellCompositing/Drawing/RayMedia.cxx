// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "RayMedia.h"

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "MovedView.h"
#include "RayCells.h"
#include "RayGeometry.h"
#include "ShaderInstance.h"
#include "ShaderText.h"

#include "MixedSegmentShader.h"
#include "RayCellsVertex.h"
#include "RayMediaFragment.h"
#include "RayOwnersFragment.h"
#include "RayPlanFragment.h"
#include "RayPlanMediumShader.h"
#include "VisibleDepthsShader.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <deque>

namespace nephoscope
{
namespace
{
// As often as one of the rays enters any of the meshes, at least.
constexpr int maximumRounds = 4096;

const char* const planVertex = "//VTK::System::Dec\n"
                               "void main()\n"
                               "{\n"
                               "  vec2 corner = vec2(gl_VertexID == 1, gl_VertexID == 2);\n"
                               "  gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);\n"
                               "}\n";

std::string MediumNumber(int i)
{
  return "const int mediumNumber = " + std::to_string(i) + ";\n";
}

std::string PlanFragment(int count)
{
  std::string media, outputs;
  for (int i = 0; i < count; ++i)
  {
    media += ShaderInstance(MediumNumber(i) + RayPlanMediumShader, i);
    outputs += "  gl_FragData[" + std::to_string(2 + i) + "] = vec4(entry_" + std::to_string(i) +
      ", 0.0, 0.0);\n";
  }
  media += CallInstances("findNextEntries", "findNextEntry", "", "", count) +
    CallInstances("advanceMedia", "advanceMedium", "", "", count);
  return WithShaderParts(RayPlanFragment, { { "Media", media }, { "Outputs", outputs } });
}

std::string OwnersFragment(int count)
{
  std::string uniforms = "const int numberOfMedia = " + std::to_string(count) + ";\n";
  std::string looks;
  for (int i = 0; i < count; ++i)
  {
    const std::string name = InstanceName("firstEntries", i);
    uniforms += "uniform sampler2D " + name + ";\n";
    looks += "  look(" + std::to_string(i) + ", texelFetch(" + name + ", pixel, 0).rg);\n";
  }
  return WithShaderParts(RayOwnersFragment,
    { { "Media", uniforms + "void lookAtMedia(ivec2 pixel)\n{\n" + looks + "}\n" } });
}

std::string MediaVertex(int count)
{
  std::string text = "//VTK::System::Dec\n";
  for (int i = 0; i < count; ++i)
  {
    text += ShaderInstance(RayCellsVertex, i);
  }
  return text + CallInstances("main", "main", "", "", count);
}

std::string MediaCalls(int count)
{
  const std::string place = "float place";
  return CallInstances("prepareMedia", "prepareMedium", "", "", count) +
    CallInstances("placeBesideOfMedia", "placeBeside", "", "", count) +
    CallInstances("startMedia", "startMedium", "", "", count) +
    CallInstances("lookInMedia", "lookInMedium", place, "place", count) +
    CallInstances("findInMedia", "findInMedium", place, "place", count) +
    CallInstances("goOnInMedia", "goOnInMedium", place, "place", count) +
    CallInstances("findEvents", "findEvent", place, "place", count) +
    CallInstances("addMedia", "addMedium", "float from, float to", "from, to", count) +
    CallInstances("finishMedia", "finishMedium", place, "place", count) +
    "vec3 placeInViewOfFirst(float place) { return placeInView_0(place); }\n";
}

void AllocateFloats(
  vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height, int components)
{
  texture->SetContext(window);
  texture->Allocate2D(width, height, components, VTK_FLOAT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

void Activate(vtkShaderProgram* program, const char* name, vtkTextureObject* texture)
{
  texture->Activate();
  program->SetUniformi(name, texture->GetTextureUnit());
}
}

RayMedia::RayMedia() = default;
RayMedia::~RayMedia() = default;

bool RayMedia::HasEnoughTextures(const std::vector<Medium>& media)
{
  int count = 3; // plan, faces, depth
  for (const Medium& medium : media)
  {
    count += medium.Rays->CountTextures() + medium.OtherTextures;
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &most);
  return count <= most;
}

void RayMedia::Allocate(const CellDrawing& drawing)
{
  const int width = drawing.Viewport[2];
  const int height = drawing.Viewport[3];
  if (this->Faces->GetHandle() && this->Size[0] == width && this->Size[1] == height)
  {
    return;
  }
  this->PlanFramebuffer->SetContext(drawing.Window);
  for (vtkTextureObject* texture :
    { this->Plans[0].Get(), this->Plans[1].Get(), this->Faces.Get() })
  {
    AllocateFloats(texture, drawing.Window, width, height, 4);
  }
  this->OwnersFramebuffer->SetContext(drawing.Window);
  AllocateFloats(this->Owners, drawing.Window, width, height, 1);
  this->Size[0] = width;
  this->Size[1] = height;
}

bool RayMedia::ReadyPrograms(const std::vector<Medium>& media)
{
  const CellDrawing& drawing = *media[0].Drawing;
  const int count = static_cast<int>(media.size());
  vtkOpenGLShaderCache* cache = drawing.Window->GetShaderCache();
  std::string instances;
  for (int i = 0; i < count; ++i)
  {
    const Medium& medium = media[static_cast<std::size_t>(i)];
    if (!medium.Rays->Entries.ReadyProgram(*medium.Drawing))
    {
      return false;
    }
    instances += medium.Rays->MediumShader(*medium.Drawing, i);
  }
  this->OwnersProgram = cache->ReadyShaderProgram(planVertex, OwnersFragment(count).c_str(), "");
  const std::string constants = ShaderConstant("useDepthRanges", drawing.Peel != nullptr) +
    ShaderConstant("averageIntegration", false) + drawing.CommonConstants();
  const std::string fragment = WithShaderParts(RayMediaFragment,
    { { "MixedSegment", MixedSegmentShader }, { "VisibleDepths", VisibleDepthsShader },
      { "Media", instances + MediaCalls(count) } });
  this->PlanProgram = cache->ReadyShaderProgram(planVertex, PlanFragment(count).c_str(), "");
  this->Program = cache->ReadyShaderProgram(
    MediaVertex(count).c_str(), SpecializedShader(fragment, constants).c_str(), "");
  return this->OwnersProgram && this->PlanProgram && this->Program;
}

std::string RayMedia::Draw(const std::vector<Medium>& media)
{
  std::deque<MovedView> views; // nothing moves that is in them
  std::deque<CellDrawing> drawings;
  std::vector<Medium> moved;
  for (const Medium& medium : media)
  {
    const CellDrawing& d = *medium.Drawing;
    views.emplace_back(d.View, *d.Options.Eye);
    const bool isMoved = !medium.Rays->Voxels.CanDraw(d);
    drawings.push_back({ d.Window, d.Viewport, isMoved ? views.back().View : d.View, d.Options,
      d.Buffers, d.Contours, d.Depth, d.Peel, d.Range });
    moved.push_back({ medium.Rays, &drawings.back() });
  }
  const std::string error = this->DrawFrom(moved);
  for (const Medium& medium : moved)
  {
    medium.Rays->Entries.SetOwners(nullptr, 0);
  }
  return error;
}

std::string RayMedia::DrawFrom(const std::vector<Medium>& media)
{
  this->Allocate(*media[0].Drawing);
  if (!this->ReadyPrograms(media))
  {
    return NotCompiled;
  }
  this->Begin(media);
  if (!this->DrawLonePixels(media))
  {
    return NotCompiled;
  }
  bool more = true;
  for (int round = 0; more && round < maximumRounds; ++round)
  {
    more = this->FindNextEntries(media);
    this->DrawPlan(media, round == 0);
    this->DrawRound(media);
    std::swap(this->Last, this->Then);
    this->Plan = 1 - this->Plan;
    for (const Medium& medium : media)
    {
      medium.Rays->NumberOfLayers = std::max(medium.Rays->NumberOfLayers, round + 1);
    }
  }
  return std::string();
}

// Those whose rays enter a single mesh. The others are left for the rounds. Rays that start at the
// eye need no entry: then all are left. False if a shader did not compile.
bool RayMedia::DrawLonePixels(const std::vector<Medium>& media)
{
  for (const Medium& medium : media)
  {
    medium.Rays->NumberOfLayers = 0;
  }
  const auto startsAtEye = [](const Medium& medium) {
    return medium.Rays->StartsAtEye(*medium.Drawing->Options.Eye);
  };
  if (std::any_of(media.begin(), media.end(), startsAtEye))
  {
    return true;
  }
  this->FindOwners(media);
  const int count = static_cast<int>(media.size());
  for (int i = 0; i < count; ++i)
  {
    const Medium& medium = media[static_cast<std::size_t>(i)];
    if (!medium.Rays->DrawOwned(*medium.Drawing, this->Owners, i).empty())
    {
      return false;
    }
  }
  for (const Medium& medium : media)
  {
    medium.Rays->Entries.SetOwners(this->Owners, count);
    if (!medium.Rays->Entries.ReadyProgram(*medium.Drawing))
    {
      return false;
    }
  }
  this->Begin(media);
  return true;
}

void RayMedia::FindOwners(const std::vector<Medium>& media)
{
  const CellDrawing& drawing = *media[0].Drawing;
  vtkOpenGLState* state = drawing.Window->GetState();
  state->PushFramebufferBindings();
  this->OwnersFramebuffer->Bind();
  this->OwnersFramebuffer->AddColorAttachment(0, this->Owners);
  this->OwnersFramebuffer->ActivateDrawBuffer(0);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  vtkShaderProgram* program = this->OwnersProgram;
  drawing.Window->GetShaderCache()->ReadyShaderProgram(program);
  for (std::size_t i = 0; i < media.size(); ++i)
  {
    Activate(program, InstanceName("firstEntries", static_cast<int>(i)),
      media[i].Rays->Entries.GetTexture(this->Last));
  }
  this->VertexArray->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  for (const Medium& medium : media)
  {
    medium.Rays->Entries.GetTexture(this->Last)->Deactivate();
  }
  state->PopFramebufferBindings();
}

// The first entries; and from an eye where parts of one mesh overlap, all of these parts but one.
void RayMedia::Begin(const std::vector<Medium>& media)
{
  for (const Medium& medium : media)
  {
    const CellDrawing& drawing = *medium.Drawing;
    const EyeTetrahedron& eye = *drawing.Options.Eye;
    medium.Rays->Entries.Allocate(drawing);
    const bool inside = medium.Rays->StartsAtEye(eye);
    medium.Rays->Entries.Clear(drawing, inside ? this->Last : this->Next);
    if (!inside)
    {
      medium.Rays->Entries.Draw(drawing, this->Last, this->Next, nullptr);
      drawing.Finish();
      continue;
    }
    for (const EyeTetrahedron& other : eye.Overlapping)
    {
      if (medium.Rays->ReadySegmentProgram(drawing))
      {
        medium.Rays->DrawSegments(drawing, -1, other);
        drawing.Finish();
      }
    }
  }
}

bool RayMedia::FindNextEntries(const std::vector<Medium>& media)
{
  bool any = false;
  for (const Medium& medium : media)
  {
    any = medium.Rays->Entries.Draw(*medium.Drawing, this->Next, this->Last, nullptr) || any;
    medium.Drawing->Finish();
  }
  return any;
}

void RayMedia::DrawPlan(const std::vector<Medium>& media, bool first)
{
  const CellDrawing& drawing = *media[0].Drawing;
  vtkOpenGLState* state = drawing.Window->GetState();
  state->PushFramebufferBindings();
  this->PlanFramebuffer->Bind();
  this->PlanFramebuffer->AddColorAttachment(0, this->Plans[this->Plan]);
  this->PlanFramebuffer->AddColorAttachment(1, this->Faces);
  GLenum buffers[2 + Most];
  const int count = static_cast<int>(media.size());
  for (int i = 0; i < count; ++i)
  {
    this->PlanFramebuffer->AddColorAttachment(static_cast<unsigned int>(2 + i),
      media[static_cast<std::size_t>(i)].Rays->Entries.GetTexture(this->Then));
  }
  for (int i = 0; i < 2 + count; ++i)
  {
    buffers[i] = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i);
  }
  this->PlanFramebuffer->ActivateDrawBuffers(static_cast<unsigned int>(2 + count));
  glDrawBuffers(2 + count, buffers); // vtkOpenGLState may skip it
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);

  vtkShaderProgram* program = this->PlanProgram;
  drawing.Window->GetShaderCache()->ReadyShaderProgram(program);
  const double plane = RayGeometry(drawing.View).Distance();
  program->SetUniformi("isFirst", first ? 1 : 0);
  Activate(program, "lastPlan", this->Plans[1 - this->Plan]);
  for (int i = 0; i < count; ++i)
  {
    const Medium& medium = media[static_cast<std::size_t>(i)];
    Activate(program, InstanceName("lastEntry", i), medium.Rays->Entries.GetTexture(this->Last));
    Activate(program, InstanceName("nextEntry", i), medium.Rays->Entries.GetTexture(this->Next));
    const std::array<float, 2> range = medium.Rays->Entries.DepthRange(medium.Drawing->View);
    const float places[2] = { static_cast<float>(range[0] - plane),
      static_cast<float>(range[1] - plane) };
    program->SetUniform2f(InstanceName("entryPlaces", i), places);
    program->SetUniformi(InstanceName("startsAtEye", i),
      medium.Rays->StartsAtEye(*medium.Drawing->Options.Eye) ? 1 : 0);
  }
  this->VertexArray->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  this->Plans[1 - this->Plan]->Deactivate();
  for (const Medium& medium : media)
  {
    medium.Rays->Entries.GetTexture(this->Last)->Deactivate();
    medium.Rays->Entries.GetTexture(this->Next)->Deactivate();
  }
  for (int i = 0; i < count; ++i) // the next plan may have fewer media
  {
    this->PlanFramebuffer->RemoveColorAttachment(static_cast<unsigned int>(2 + i));
  }
  state->PopFramebufferBindings();
}

void RayMedia::DrawRound(const std::vector<Medium>& media)
{
  const CellDrawing& common = *media[0].Drawing;
  vtkOpenGLState* state = common.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  // Under what is there already.
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  vtkShaderProgram* program = this->Program;
  common.Window->GetShaderCache()->ReadyShaderProgram(program);
  this->VertexArray->Bind();
  common.SetCommonUniforms(program);
  const double plane = RayGeometry(common.View).Distance();
  program->SetUniformf("firstPlane", static_cast<float>(plane));
  Activate(program, "roundPlan", this->Plans[this->Plan]);
  Activate(program, "enteredFaces", this->Faces);
  for (int i = 0; i < static_cast<int>(media.size()); ++i)
  {
    const CellDrawing& drawing = *media[static_cast<std::size_t>(i)].Drawing;
    drawing.SetOwnUniforms(program, i);
    media[static_cast<std::size_t>(i)].Rays->SetWalk(drawing, program, i);
    program->SetUniformf(InstanceName("mediumPlace", i),
      static_cast<float>(RayGeometry(drawing.View).Distance() - plane));
  }
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  this->Plans[this->Plan]->Deactivate();
  this->Faces->Deactivate();
  for (const Medium& medium : media)
  {
    medium.Rays->DeactivateTopology();
    medium.Drawing->Finish();
  }
}

void RayMedia::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextureObject* texture :
    { this->Plans[0].Get(), this->Plans[1].Get(), this->Faces.Get(), this->Owners.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->PlanFramebuffer->ReleaseGraphicsResources(window);
  this->OwnersFramebuffer->ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->OwnersProgram = this->PlanProgram = this->Program = nullptr;
  this->Size[0] = this->Size[1] = 0;
}

} // namespace nephoscope
