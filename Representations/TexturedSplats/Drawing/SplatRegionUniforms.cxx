// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatRegionUniforms.h"

#include "SplatPass.h"
#include "ViewState.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace nephoscope
{
namespace
{
// The plane x = bound along an axis of the model, of points in view coordinates; infinitely far for
// an infinite bound.
void PlaneOf(vtkMatrix4x4* viewToModel, int axis, double bound, float plane[4])
{
  const bool bounded = std::isfinite(bound);
  for (int i = 0; i < 3; ++i)
  {
    plane[i] = bounded ? static_cast<float>(viewToModel->GetElement(axis, i)) : 0.0f;
  }
  plane[3] = bounded ? static_cast<float>(viewToModel->GetElement(axis, 3) - bound)
                     : static_cast<float>(bound > 0 ? -1 : 1);
}
}

std::array<float, 4> RayOfPixel(vtkMatrix4x4* viewToDevice, const float pixelsPerDevice[2])
{
  const int shift = IsParallelProjection(viewToDevice) ? 3 : 2; // the column that moves the image
  const double sign = shift == 3 ? -1.0 : 1.0;
  std::array<float, 4> ray;
  for (int i = 0; i < 2; ++i)
  {
    const double scale = viewToDevice->GetElement(i, i);
    const auto axis = static_cast<std::size_t>(i);
    ray[axis] = static_cast<float>((sign * viewToDevice->GetElement(i, shift) - 1.0) / scale);
    ray[axis + 2] = static_cast<float>(1.0 / (pixelsPerDevice[i] * scale));
  }
  return ray;
}

void SetRegionUniforms(vtkShaderProgram* program, const SceneView& view,
  const SplatDrawingOptions& options, const float pixelsPerDevice[2])
{
  if (!IsRegion(options.Region))
  {
    return;
  }
  vtkNew<vtkMatrix4x4> viewToModel;
  vtkMatrix4x4::Invert(view.ModelToView, viewToModel);
  float low[3][4], high[3][4];
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto at = 2 * static_cast<std::size_t>(axis);
    PlaneOf(viewToModel, axis, options.Region[at], low[axis]);
    PlaneOf(viewToModel, axis, options.Region[at + 1], high[axis]);
  }
  program->SetUniform4fv("regionLow", 3, low);
  program->SetUniform4fv("regionHigh", 3, high);
  program->SetUniform4f("regionRay", RayOfPixel(view.ViewToDevice, pixelsPerDevice).data());
  program->SetUniformf("layerThickness", static_cast<float>(options.LayerThickness));
  program->SetUniformf("layerOrigin", static_cast<float>(view.ModelToView->GetElement(2, 3)));
}

} // namespace nephoscope
