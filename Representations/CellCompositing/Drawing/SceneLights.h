// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The lights of a renderer in view coordinates, as shaders take them. */
#ifndef nephoscope_SceneLights_h
#define nephoscope_SceneLights_h

#include "vtkCamera.h"
#include "vtkCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nephoscope
{

constexpr std::size_t maximumNumberOfLights = 16; // as the shader has it

struct SceneLight
{
  std::array<float, 3> Color;     ///< times intensity
  std::array<float, 3> Direction; ///< away from the light
  std::array<float, 3> Position;
  std::array<float, 3> Attenuation; ///< constant, linear, quadratic
  std::array<float, 3> Cone; ///< 1 if positional, -1 if VTK's sole headlight; cosine of the cone
                             ///< angle, -2 without a cone; exponent
};

inline SceneLight DescribeLight(vtkLight* light, vtkMatrix4x4* worldToView)
{
  double position[4], focus[4], color[3], attenuation[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focus);
  position[3] = focus[3] = 1.0;
  worldToView->MultiplyPoint(position, position);
  worldToView->MultiplyPoint(focus, focus);
  double direction[3] = { focus[0] - position[0], focus[1] - position[1], focus[2] - position[2] };
  vtkMath::Normalize(direction);
  light->GetDiffuseColor(color);
  light->GetAttenuationValues(attenuation);
  const bool positional = light->GetPositional() != 0;
  const double angle = light->GetConeAngle();
  SceneLight result;
  for (std::size_t c = 0; c < 3; ++c)
  {
    result.Color[c] = static_cast<float>(color[c] * light->GetIntensity());
    result.Direction[c] = static_cast<float>(direction[c]);
    result.Position[c] = static_cast<float>(position[c]);
    result.Attenuation[c] = static_cast<float>(attenuation[c]);
  }
  result.Cone = { { positional ? 1.0f : 0.0f,
    angle <= 90.0 ? static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(angle))) : -2.0f,
    static_cast<float>(light->GetExponent()) } };
  return result;
}

/** The lights that are switched on, the first maximumNumberOfLights of them. */
inline std::vector<SceneLight> DescribeLights(vtkRenderer* renderer)
{
  std::vector<SceneLight> lights;
  vtkMatrix4x4* worldToView = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  vtkCollectionSimpleIterator iterator;
  vtkLightCollection* all = renderer->GetLights();
  all->InitTraversal(iterator);
  while (vtkLight* light = all->GetNextLight(iterator))
  {
    if (light->GetSwitch() && lights.size() < maximumNumberOfLights)
    {
      lights.push_back(DescribeLight(light, worldToView));
    }
  }
  vtkLight* first = vtkLight::SafeDownCast(all->GetItemAsObject(0));
  if (lights.size() == 1 && all->GetNumberOfItems() == 1 && first->LightTypeIsHeadlight() &&
    !first->GetPositional())
  {
    lights[0].Cone[0] = -1.0f;
  }
  return lights;
}

} // namespace nephoscope

#endif
