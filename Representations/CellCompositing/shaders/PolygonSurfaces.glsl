// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygons of the input that lie in faces of the tetrahedron, as translucent surfaces where its part of the ray begins or ends. Each is
// drawn by one of the two tetrahedra that share the face. Lit as contour surfaces are (ContourSurfaces.glsl).
uniform IntegerArray tetrahedronSurfaces; // for the face opposite each vertex the number of its surface, counted from 1; 0: none
uniform FloatArray polygonSurfaces;       // four texels each: colour and opacity, red < 0: the function's; normals at the corners, MC

// Premultiplied colour and alpha of the surface in a face, where the ray crosses it.
vec4 polygonSurface(int tetrahedron, int face, vec4 coordinates, float s, vec3 crossingVC)
{
  int number = element(tetrahedronSurfaces, tetrahedron)[face];
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
  if (contourLighting)
  {
    vec3 weights = face == 0 ? coordinates.yzw : face == 1 ? coordinates.xzw : face == 2 ? coordinates.xyw : coordinates.xyz;
    vec3 normal = weights.x * element(polygonSurfaces, texel + 1).xyz + weights.y * element(polygonSurfaces, texel + 2).xyz +
      weights.z * element(polygonSurfaces, texel + 3).xyz;
    surface.rgb = litColor(surface.rgb, unit(gradientMatrix * normal), crossingVC);
  }
  surface = vec4(surface.a * surface.rgb, surface.a);
#ifdef NEPHOSCOPE_HAZE
  surface = hazedLight(surface, crossingVC);
#endif
  return surface;
}
