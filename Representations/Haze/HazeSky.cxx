// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "HazeSky.h"

#include "HazeFragmentFunctions.h"
#include "HazeSkyFragment.h"
#include "HazeView.h"
#include "SavedState.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <string>

namespace nephoscope
{

vtkStandardNewMacro(HazeSky);

namespace
{
// The sky lies on the far plane, at the depth of empty pixels. Compositing by depth drops such
// pixels: for it, the sky lies two steps of a 24-bit depth buffer in front of them.
constexpr float farPlane = 1;
constexpr float beforeFarPlane = 1 - 0x1p-22f;
const char* const vertexShader =
  "//VTK::System::Dec\n"
  "uniform float hazeDepth;\n"
  "void main()\n"
  "{\n"
  "  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, hazeDepth, 1.0);\n"
  "}\n";

std::string FragmentShader(const HazeView& view)
{
  std::string source = HazeSkyFragment;
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::HazeFragment", HazeFragmentFunctions);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::Haze", view.Definition());
  return source;
}
}

HazeSky::HazeSky()
  : Window([this](vtkWindow*) { this->VertexArray->ReleaseGraphicsResources(); })
{
  this->PickableOff();
  this->UseBoundsOff();
}

HazeSky::~HazeSky() = default;

void HazeSky::Enter(vtkHaze::SkyOfRank rank, vtkCamera* camera)
{
  this->HasDepth = rank == vtkHaze::SkyOfRank::BY_DEPTH;
  this->SetUseBounds(rank != vtkHaze::SkyOfRank::ALONE);
  const double reach = 100 * (camera->GetClippingRange()[1] + camera->GetParallelScale());
  for (int c = 0; c < 3; ++c)
  {
    this->Bounds[2 * c] = camera->GetPosition()[c] - reach;
    this->Bounds[2 * c + 1] = camera->GetPosition()[c] + reach;
  }
}

int HazeSky::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || renderer->GetSelector())
  {
    return 0;
  }
  const HazeView view(renderer);
  if (!view.IsOn())
  {
    return 0;
  }
  this->Window.Enter(window);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertexShader, FragmentShader(view).c_str(), "");
  if (!program)
  {
    vtkErrorMacro("The shader of the haze in front of the background did not compile.");
    return 0;
  }
  const SavedState saved(window->GetState());
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(this->HasDepth);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->VertexArray->Bind();
  view.SetUniforms(program);
  program->SetUniformf("hazeDepth", this->HasDepth ? beforeFarPlane : farPlane);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  this->VertexArray->Release();
  return 1;
}

void HazeSky::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Window.Leave(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

} // namespace nephoscope
