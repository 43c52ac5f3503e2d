// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that depends on the direction of view, added to the scalars of points (CameraLight.h). The sun is so far away that all points of a ray are seen at the
// same angle from it, so that the sum is linear in each tetrahedron as its parts are.
// Constant: cameraLight.
uniform FloatArray lightParts;    // two per point: diffuse flux, light straight from the sun; light scattered straight on before, with the sign of the second moment of
                                  // the diffuse light, up times the root of that
uniform FloatArray phaseFunction; // factors less 1 of the two kinds of sunlight, evenly spaced in angle
uniform vec3 towardsSun;          // unit length, in the coordinates of the data
uniform int numberOfPhases;

vec4 lightWeights = vec4(0.0); // of the first part of a point
float lightWeight = 0.0;       // of the second

// For the ray in this direction, away from the eye.
void keepCameraLight(vec3 direction)
{
  if (cameraLight)
  {
    float angle = atan(length(cross(direction, towardsSun)), dot(direction, towardsSun)); // 0: straight on
    float place = angle * (float(numberOfPhases - 1) / 3.14159265358979);
    int below = clamp(int(place), 0, numberOfPhases - 2);
    vec2 phase = mix(element(phaseFunction, below).xy, element(phaseFunction, below + 1).xy, clamp(place - float(below), 0.0, 1.0));
    lightWeights = vec4(-direction, phase.x);
    lightWeight = phase.y;
  }
}

// What is added to the scalar of a point.
float cameraLightOf(int point)
{
  vec4 second = element(lightParts, 2 * point + 1);
  float upwards = dot(lightWeights.xyz, second.yzw);
  float moment = (second.x < 0.0 ? -0.5 : 0.5) * (3.0 * upwards * upwards - dot(second.yzw, second.yzw));
  return dot(lightWeights, element(lightParts, 2 * point)) + moment + lightWeight * abs(second.x);
}

float withCameraLight(float scalar, int point)
{
  return cameraLight ? clamp(scalar + cameraLightOf(point), 0.0, 1.0) : scalar;
}
