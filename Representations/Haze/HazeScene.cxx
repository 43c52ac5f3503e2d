// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeScene.h"

#include "RendererSun.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

namespace nephoscope
{
HazeScene::HazeScene(vtkRenderer* renderer)
{
  renderer->GetActiveCamera()->GetPosition(this->Eye);
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = bounds[2 * c];
      this->High[c] = bounds[2 * c + 1];
    }
  }
  const auto take = [renderer](const char* name, double& value) {
    value = greatestFieldValue(renderer, name, value);
  };
  take("GlobeGridProjection", this->GlobeGridProjection);
  take("PlanetRadius", this->PlanetRadius);
  take("VerticalExaggeration", this->VerticalExaggeration);
}

} // namespace nephoscope
