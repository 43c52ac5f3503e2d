// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "VolumeSpans.h"

#include "SliceSpansFragment.h"
#include "WholeViewport.h"

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

#include <algorithm>
#include <array>
#include <string>

namespace nephoscope
{
namespace
{
constexpr double margin = 1.0e-4; // of the box around all, more than single precision errs

/**
 * Area in device coordinates of the rectangle around a box on the screen; the whole screen has 4.
 */
double AreaOf(const vtkBoundingBox& box, vtkMatrix4x4* worldToDevice)
{
  vtkBoundingBox seen;
  for (int corner = 0; corner < 8; ++corner)
  {
    double place[4] = { 0, 0, 0, 1 };
    box.GetCorner(corner, place);
    worldToDevice->MultiplyPoint(place, place);
    if (!(place[3] > 0))
    {
      return 4; // around the eye
    }
    seen.AddPoint(place[0] / place[3], place[1] / place[3], 0);
  }
  return seen.IntersectBox(vtkBoundingBox(-1, 1, -1, 1, 0, 0))
    ? seen.GetLength(0) * seen.GetLength(1)
    : 0;
}

/** Boxes in coordinates from -1 to 1, in which single precision suffices wherever the data are. */
struct Boxes
{
  using Corner = std::array<float, 3>;
  std::vector<Corner> Low, High;
  std::vector<int> InTiles;
  vtkNew<vtkMatrix4x4> ToWorld;

  explicit Boxes(const std::vector<VolumeSpans::Box>& boxes)
  {
    vtkBoundingBox all;
    for (const VolumeSpans::Box& box : boxes)
    {
      all.AddBox(box.Bounds);
    }
    double middle[3];
    all.GetCenter(middle);
    const double half = std::max(0.5 * all.GetMaxLength(), 1.0e-300);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->ToWorld->SetElement(axis, axis, half);
      this->ToWorld->SetElement(axis, 3, middle[axis]);
    }
    for (const VolumeSpans::Box& box : boxes)
    {
      double bounds[6];
      box.Bounds.GetBounds(bounds);
      Corner low, high;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = static_cast<float>((bounds[2 * axis] - middle[axis]) / half - margin);
        high[axis] = static_cast<float>((bounds[2 * axis + 1] - middle[axis]) / half + margin);
      }
      this->Low.push_back(low);
      this->High.push_back(high);
      this->InTiles.push_back(box.InTiles ? 1 : 0);
    }
  }

  void SetUniforms(vtkShaderProgram* program, vtkRenderer* renderer) const
  {
    vtkNew<vtkMatrix4x4> toDevice, inverse;
    vtkMatrix4x4::Multiply4x4(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                                renderer->GetTiledAspectRatio(), -1, 1),
      this->ToWorld, toDevice);
    vtkMatrix4x4::Invert(toDevice, inverse);
    toDevice->Transpose(); // as OpenGL wants it
    inverse->Transpose();
    program->SetUniformMatrix("boxesToDC", toDevice);
    program->SetUniformMatrix("DCToBoxes", inverse);
    const int count = static_cast<int>(this->Low.size());
    program->SetUniformi("boxCount", count);
    const auto triples = [](const std::vector<Corner>& corners) {
      return reinterpret_cast<const float(*)[3]>(corners.data());
    };
    program->SetUniform3fv("lowCorners", count, triples(this->Low));
    program->SetUniform3fv("highCorners", count, triples(this->High));
    program->SetUniform1iv("inTiles", count, this->InTiles.data());
  }
};
}

VolumeSpans::VolumeSpans() = default;
VolumeSpans::~VolumeSpans() = default;

bool VolumeSpans::AreWorthwhile(vtkRenderer* renderer, const std::vector<Box>& boxes)
{
  vtkMatrix4x4* toDevice = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1, 1);
  vtkBoundingBox all;
  double shared = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    all.AddBox(boxes[i].Bounds);
    for (std::size_t j = 0; j < i; ++j)
    {
      vtkBoundingBox both(boxes[i].Bounds);
      if (both.IntersectBox(boxes[j].Bounds))
      {
        shared += AreaOf(both, toDevice);
      }
    }
  }
  return shared < 0.5 * AreaOf(all, toDevice);
}

vtkTextureObject* VolumeSpans::Draw(vtkRenderer* renderer, const std::vector<Box>& boxes,
  const DepthTiles& tiles, const int viewport[4])
{
  if (boxes.size() > Most)
  {
    return nullptr;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const std::string most = "#define MOST_BOXES " + std::to_string(Most) + "\n";
  std::string fragment = SliceSpansFragment;
  vtkShaderProgram::Substitute(fragment, "//VTK::Output::Dec", "//VTK::Output::Dec\n" + most);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(wholeViewportVertex, fragment.c_str(), "");
  if (!program || !this->Image.Begin(window, viewport))
  {
    return nullptr;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  Boxes(boxes).SetUniforms(program, renderer);
  std::vector<std::array<float, 2>> ranges = tiles.GetRanges(); // the texture takes what may change
  this->Tiles->SetContext(window);
  this->Tiles->Create2DFromRaw(static_cast<unsigned int>(tiles.GetWidth()),
    static_cast<unsigned int>(tiles.GetHeight()), 2, VTK_FLOAT, ranges.data());
  this->Tiles->Activate();
  program->SetUniformi("tiles", this->Tiles->GetTextureUnit());
  program->SetUniformi("sideOfTiles", DepthTiles::Side);
  const float size[2] = { float(viewport[2]), float(viewport[3]) };
  program->SetUniform2f("sizeOfViewport", size);
  DrawWholeViewport(this->VertexArray);
  this->Tiles->Deactivate();
  this->Image.End(window);
  return this->Image.GetTexture(0);
}

void VolumeSpans::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Image.ReleaseGraphicsResources(window);
  this->Tiles->ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
}

} // namespace nephoscope
