// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygons of the input that lie in faces of tetrahedra, as translucent surfaces. Lit as contour surfaces are (ContourSurfaces.glsl).
// For the face opposite each vertex the number of its surface, counted from 1, or 0 for none. Vertices ascend by their numbers, and both
// tetrahedra that share the face have its surface.
uniform IntegerArray tetrahedronSurfaces;
uniform FloatArray polygonSurfaces;       // four texels each: colour and opacity, red < 0: the function's; normals at the corners, MC

// Premultiplied colour and alpha of the surface with a number, where the ray crosses it: weights of its corners, scalar of colour, place.
vec4 polygonSurface(int number, vec3 weights, float s, vec3 crossingVC)
{
  if (number == 0)
  {
    return vec4(0.0);
  }
  int texel = 4 * (number - 1);
  vec4 surface = element(polygonSurfaces, texel);
  if (surface.r < 0.0)
  {
    if (useLayers)
    {
      selectLayer(0);
    }
    surface.rgb = evaluateColor(findInterval(transferNodes, transferTable, s), s).rgb;
  }
  vec3 normal = weights.x * element(polygonSurfaces, texel + 1).xyz + weights.y * element(polygonSurfaces, texel + 2).xyz +
    weights.z * element(polygonSurfaces, texel + 3).xyz;
  return surfaceSeen(surface, normal, crossingVC);
}
