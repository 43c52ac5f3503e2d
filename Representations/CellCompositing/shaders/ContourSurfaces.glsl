// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces inside tetrahedra, layers of the medium between them, and how surfaces are lit.
//
// A point lies above a value when its scalar is >= the value, and a surface is crossed between two ends on different sides.
// Constant: contourLighting.
uniform FloatArray contours; // two texels each, ascending: (value, layer below, layer above, 0), (colour, opacity); red < 0: function's
uniform FloatArray contourGradients; // per point, in model coordinates
uniform int numberOfContours;
uniform mat3 gradientMatrix;            // of gradients, from model to view coordinates
uniform vec4 contourShading;            // ambient, diffuse, specular, specular power
uniform int numberOfLights;
uniform vec3 lightColors[16];
uniform vec3 lightDirections[16];  // VC, away from the light
uniform vec3 lightPositions[16];   // VC
uniform vec3 lightAttenuations[16]; // constant, linear, quadratic
uniform vec3 lightCones[16];       // 1 if positional, -1 if the sole headlight; cosine of the cone angle (-2: none); exponent

// Number of contour values at or below s.
int contourLayer(float s)
{
  int low = 0;
  int high = numberOfContours;
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (element(contours, 2 * middle).r <= s)
    {
      low = middle + 1;
    }
    else
    {
      high = middle;
    }
  }
  return low;
}

vec3 unit(vec3 v)
{
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  vec3 scaled = v / (largest > 0.0 ? largest : 1.0); // squares of small gradients would vanish
  return scaled / max(length(scaled), 0.5);
}

// Phong's model as VTK's surfaces have it: both sides alike, a white highlight.
vec3 litColor(vec3 color, vec3 normalVC, vec3 positionVC)
{
  vec3 towardsEye = eyeVC.w > 0.0 ? normalize(eyeVC.xyz - positionVC) : normalize(eyeVC.xyz);
  vec3 normal = dot(normalVC, towardsEye) < 0.0 ? -normalVC : normalVC;
  vec3 sum = contourShading.x * color;
  for (int i = 0; i < numberOfLights; ++i)
  {
    vec3 direction = lightDirections[i];
    float strength = 1.0;
    if (lightCones[i].x > 0.0)
    {
      vec3 way = positionVC - lightPositions[i];
      float distance = length(way);
      direction = way / distance;
      strength = 1.0 / dot(lightAttenuations[i], vec3(1.0, distance, distance * distance));
      float inCone = dot(direction, lightDirections[i]);
      if (lightCones[i].y > -2.0)
      {
        strength *= inCone >= lightCones[i].y ? pow(inCone, lightCones[i].z) : 0.0;
      }
    }
    float diffuse = max(0.0, -dot(normal, direction));
    // VTK takes the highlight of a sole headlight from the normal, all others from the mirrored light.
    float mirrored = lightCones[i].x < 0.0 ? diffuse : max(0.0, dot(reflect(direction, normal), towardsEye));
    float specular = diffuse > 0.0 ? pow(mirrored, contourShading.w) : 0.0;
    sum += strength * lightColors[i] * (contourShading.y * diffuse * color + contourShading.z * specular);
  }
  return min(sum, vec3(1.0));
}

// Colour and opacity of a contour surface where the colour function's scalar is s; not lit.
vec4 contourColor(int contour, float s)
{
  vec4 surface = element(contours, 2 * contour + 1);
  if (surface.r < 0.0)
  {
    if (useLayers)
    {
      selectLayer(0);
    }
    surface.rgb = evaluateColor(findInterval(transferNodes, transferTable, s), s).rgb;
  }
  return surface;
}

// Premultiplied colour and alpha of a surface as it is seen: lit, and hazed; the normal in model coordinates.
vec4 surfaceSeen(vec4 surface, vec3 normal, vec3 positionVC)
{
  if (contourLighting)
  {
    surface.rgb = litColor(surface.rgb, unit(gradientMatrix * normal), positionVC);
  }
  surface = vec4(surface.a * surface.rgb, surface.a);
#ifdef NEPHOSCOPE_HAZE
  surface = hazedLight(surface, positionVC);
#endif
  return surface;
}

// The same of a contour, where the colour function's scalar is s.
vec4 contourSurface(int contour, float s, vec3 normal, vec3 positionVC)
{
  return surfaceSeen(contourColor(contour, s), normal, positionVC);
}

// Normal to the level sets of a linear field over a tetrahedron; its sign and length do not matter.
vec3 levelNormal(vec3 a, vec3 b, vec3 c, vec3 d, vec4 scalars)
{
  vec3 change = scalars.yzw - scalars.x;
  return change.x * cross(c - a, d - a) + change.y * cross(d - a, b - a) + change.z * cross(b - a, c - a);
}
