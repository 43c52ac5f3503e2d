// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours of splats whose light depends on the direction of view (CameraLight.h): the scalar that a splat has in place of its colour, with what the
// direction adds to it, in the colour function.
const bool cameraLight = true;
//NEPHOSCOPE::CameraLight
uniform FloatArray lightColors; // evenly spaced in the scalar
uniform int numberOfLightColors;
uniform vec2 lightRange; // scalar of the first, and how far it is to the last
uniform mat3 VCToData;   // of directions

// `rayVC` points away from the eye.
vec3 colorTowardsCamera(float scalar, int splat, vec3 rayVC)
{
  keepCameraLight(normalize(VCToData * rayVC));
  float place = clamp((scalar + cameraLightOf(splat) - lightRange.x) / lightRange.y, 0.0, 1.0) * float(numberOfLightColors - 1);
  int below = min(int(place), numberOfLightColors - 2);
  return mix(element(lightColors, below).rgb, element(lightColors, below + 1).rgb, place - float(below));
}
