// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "PickDrawing.h"

#include "SavedState.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace nephoscope
{
namespace
{
const char* const numbersShader =
  "//VTK::System::Dec\n"
  "//VTK::Output::Dec\n"
  "in vec2 texCoord;\n"
  "uniform sampler2D numbers;\n"
  "uniform vec4 viewport;\n" // relative to the first pixel, in squares
  "void main()\n"
  "{\n"
  "  ivec2 place = ivec2(floor(viewport.xy + texCoord * viewport.zw));\n"
  "  if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, textureSize(numbers, 0))))\n"
  "  {\n"
  "    discard;\n"
  "  }\n"
  "  vec4 number = texelFetch(numbers, place, 0);\n"
  "  if (number.a < 0.0)\n"
  "  {\n"
  "    discard;\n"
  "  }\n"
  "  gl_FragDepth = number.a;\n"
  "  gl_FragData[0] = vec4(number.rgb, 1.0);\n"
  "}\n";
}

PickDrawing::PickDrawing() = default;
PickDrawing::~PickDrawing() = default;

void PickDrawing::Draw(vtkOpenGLRenderWindow* window, const std::array<int, 2>& first, int width,
  const std::array<int, 2>& size, const std::vector<float>& pixels)
{
  vtkOpenGLState* state = window->GetState();
  const SavedState saved(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  this->Numbers->SetContext(window);
  this->Numbers->Create2DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), 4, VTK_FLOAT, const_cast<float*>(pixels.data()));
  this->Numbers->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Numbers->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (!this->Quad)
  {
    this->Quad.reset(new vtkOpenGLQuadHelper(window, nullptr, numbersShader, nullptr));
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  this->Numbers->Activate();
  this->Quad->Program->SetUniformi("numbers", this->Numbers->GetTextureUnit());
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float scale = 1.0f / static_cast<float>(width);
  const float relative[4] = { scale * static_cast<float>(viewport[0] - first[0]),
    scale * static_cast<float>(viewport[1] - first[1]), scale * static_cast<float>(viewport[2]),
    scale * static_cast<float>(viewport[3]) };
  this->Quad->Program->SetUniform4f("viewport", relative);
  this->Quad->Render();
  this->Numbers->Deactivate();
}

void PickDrawing::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Numbers->ReleaseGraphicsResources(window);
}

} // namespace nephoscope
