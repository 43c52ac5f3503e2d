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
    value = GreatestFieldValue(renderer, name, value);
  };
  take("GlobeGridProjection", this->GlobeGridProjection);
  take("PlanetRadius", this->PlanetRadius);
  take("VerticalExaggeration", this->VerticalExaggeration);
}

void HazeScene::Join(const MaximumOfRanks& maximum)
{
  double most[9] = { -this->Low[0], -this->Low[1], -this->Low[2], this->High[0], this->High[1],
    this->High[2], this->GlobeGridProjection, this->PlanetRadius, this->VerticalExaggeration };
  maximum(most, 9);
  for (int c = 0; c < 3; ++c)
  {
    this->Low[c] = -most[c];
    this->High[c] = most[3 + c];
  }
  this->GlobeGridProjection = most[6];
  this->PlanetRadius = most[7];
  this->VerticalExaggeration = most[8];
}

} // namespace nephoscope
