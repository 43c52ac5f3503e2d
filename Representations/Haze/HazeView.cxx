// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "HazeView.h"

#include "HazeFunctions.h"
#include "HazeLink.h"
#include "ViewState.h"
#include "vtkHaze.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
void ToView(vtkMatrix4x4* worldToView, const double in[3], double w, double out[3])
{
  const double p[4] = { in[0], in[1], in[2], w };
  double q[4];
  worldToView->MultiplyPoint(p, q);
  std::copy(q, q + 3, out);
}
}

HazeView::HazeView(vtkRenderer* renderer)
{
  HazeLink* link = HazeLink::Of(renderer);
  vtkHaze* haze = link ? link->GetHaze() : nullptr;
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  if (!haze || !haze->IsSeen() || !link->GetPlacement().Exists || !camera)
  {
    return;
  }
  vtkMatrix4x4 *worldToView, *viewToDevice, *worldToDevice; // transposed, as OpenGL wants them
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToDevice, worldToDevice);
  vtkNew<vtkMatrix4x4> world, device;
  vtkMatrix4x4::Transpose(worldToView, world);
  vtkMatrix4x4::Transpose(viewToDevice, device);

  this->On = true;
  const HazePlacement& placement = link->GetPlacement();
  this->OnGlobe = placement.OnGlobe;
  this->Parallel = IsParallelProjection(device);
  this->Unit = static_cast<float>(1 / placement.ScaleHeight);
  this->Extinction = static_cast<float>(placement.Extinction * placement.ScaleHeight);
  Vector4 eye = FindEye(device);
  double start[3] = { 0, 0, 0 }; // the camera
  for (int c = 0; c < 3; ++c)
  {
    this->Tint[c] = static_cast<float>(haze->GetColor()[c]);
    const auto axis = static_cast<std::size_t>(c);
    start[c] = this->Parallel ? 0 : eye[axis] / eye[3];
    this->Eye[c] = static_cast<float>(this->Parallel ? -eye[axis] / std::abs(eye[2]) : start[c]);
  }
  this->SetPlace(*haze, placement, world, start);
  this->SetSun(*link, world);
  this->SetDevice(device);
}

void HazeView::SetSun(const HazeLink& link, vtkMatrix4x4* worldToView)
{
  this->Asymmetry = static_cast<float>(link.GetHaze()->GetAsymmetry());
  if (!link.GetSun())
  {
    return;
  }
  double inView[3];
  ToView(worldToView, link.GetSun(), 0, inView);
  std::copy_n(inView, 3, this->Sun);
  this->ShadowUnit = link.GetShadows().GetUnit();
  if (this->ShadowUnit >= 0)
  {
    vtkNew<vtkMatrix4x4> viewToWorld, toShadows;
    vtkMatrix4x4::Invert(worldToView, viewToWorld);
    vtkMatrix4x4::Multiply4x4(link.GetShadows().GetFromWorld(), viewToWorld, toShadows);
    for (int i = 0; i < 16; ++i)
    {
      this->ToShadows[i] = static_cast<float>(toShadows->GetElement(i % 4, i / 4));
    }
  }
}

// In double: the eye may be close to the ground and far from the planet's centre.
void HazeView::SetPlace(
  vtkHaze& haze, const HazePlacement& placement, vtkMatrix4x4* worldToView, const double start[3])
{
  const double scaleHeight = placement.ScaleHeight;
  double frame[3], place[3];
  vtkNew<vtkMatrix4x4> viewToWorld;
  vtkMatrix4x4::Invert(worldToView, viewToWorld);
  ToView(viewToWorld, start, 1, place);
  if (this->OnGlobe)
  {
    double fromCenter[3], squares = 0;
    for (int c = 0; c < 3; ++c)
    {
      fromCenter[c] = (place[c] - haze.GetCenter()[c]) / scaleHeight;
      squares += fromCenter[c] * fromCenter[c];
    }
    ToView(worldToView, fromCenter, 0, frame);
    this->Height[0] = static_cast<float>(std::sqrt(squares));
    this->Height[1] = static_cast<float>(std::sqrt(squares) - placement.Radius / scaleHeight);
  }
  else
  {
    const double* up = haze.GetUpDirection();
    const double length = std::sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]);
    const double unit[3] = { up[0] / length, up[1] / length, up[2] / length };
    ToView(worldToView, unit, 0, frame);
    const double level = unit[0] * place[0] + unit[1] * place[1] + unit[2] * place[2];
    const double altitude = placement.MovesDown ? std::max(0.0, level - placement.BaseLevel)
                                                : level - placement.BaseLevel;
    this->Height[0] = 0;
    this->Height[1] = static_cast<float>(altitude / scaleHeight);
  }
  for (int c = 0; c < 3; ++c)
  {
    this->Frame[c] = static_cast<float>(frame[c]);
  }
}

// Rows x, y and w of the projection are inverted; x, y and z where rays are parallel.
void HazeView::SetDevice(vtkMatrix4x4* viewToDevice)
{
  const int rows[3] = { 0, 1, this->Parallel ? 2 : 3 };
  vtkNew<vtkMatrix3x3> linear;
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      linear->SetElement(r, c, viewToDevice->GetElement(rows[r], c));
    }
    this->DeviceOrigin[r] = static_cast<float>(viewToDevice->GetElement(rows[r], 3));
  }
  linear->Invert();
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->FromDevice[3 * c + r] = static_cast<float>(linear->GetElement(r, c));
    }
  }
}

std::string HazeView::Definition() const
{
  const bool isLit = this->Sun[0] != 0 || this->Sun[1] != 0 || this->Sun[2] != 0;
  const auto constant = [](const char* name, bool value) {
    return std::string("#define ") + name + (value ? " true\n" : " false\n");
  };
  return this->On ? "#define NEPHOSCOPE_HAZE\n" + constant("HAZE_ON_GLOBE", this->OnGlobe) +
      constant("HAZE_IS_LIT", isLit) + (this->ShadowUnit >= 0 ? "#define HAZE_SHADOWS\n" : "") +
      HazeFunctions
                  : std::string();
}

void HazeView::SetUniforms(vtkShaderProgram* program) const
{
  if (!this->On || !program->IsUniformUsed("hazeExtinction"))
  {
    return;
  }
  program->SetUniformi("hazeOnGlobe", this->OnGlobe);
  program->SetUniformi("hazeParallel", this->Parallel);
  program->SetUniformf("hazeUnit", this->Unit);
  program->SetUniformf("hazeExtinction", this->Extinction);
  program->SetUniform3f("hazeTint", this->Tint);
  program->SetUniform3f("hazeSun", this->Sun);
  program->SetUniformf("hazeAsymmetry", this->Asymmetry);
  program->SetUniform3f("hazeEye", this->Eye);
  program->SetUniform3f("hazeFrame", this->Frame);
  program->SetUniform2f("hazeHeight", this->Height);
  if (program->IsUniformUsed("hazeShadows"))
  {
    program->SetUniformi("hazeShadows", this->ShadowUnit);
    program->SetUniformMatrix4x4("hazeToShadows", const_cast<float*>(this->ToShadows));
  }
  if (program->IsUniformUsed("hazeFromDevice"))
  {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    const float place[4] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]),
      2.0f / static_cast<float>(viewport[2]), 2.0f / static_cast<float>(viewport[3]) };
    program->SetUniform4f("hazeViewport", place);
    program->SetUniformMatrix3x3("hazeFromDevice", const_cast<float*>(this->FromDevice));
    program->SetUniform3f("hazeDeviceOrigin", this->DeviceOrigin);
  }
}

} // namespace nephoscope
