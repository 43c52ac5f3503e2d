// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces and layers along a ray. Within a tetrahedron the contour scalar is linear along the ray, so that where it crosses a
// value is exact; the surface is composited there, between the parts of the medium before and behind it.
//
// The ray knows the layer that it is in, the number of values at or below the scalar, from one tetrahedron to the next; only where it ends
// up in another layer does it cross a surface. Whatever rounding does to the scalar in a face, a surface in the face is crossed once.
// Constants: useContours, contourLayers, contourLighting, contourOfColor, smoothContourNormals.
uniform FloatArray contourScalars; // where contours are of another array than colour
int contourLayerOfRay = 0;
vec2 layerReach = vec2(0.0); // scalars of the layer: from, and below
bool layerIsKnown = false;

// Selects the tables of a layer, and what is clear there.
void enterLayer(int layer)
{
  selectLayer(layer);
  clear = element(layerTables, 2 * layer + 1).rg;
}

void enterContourLayer(int layer)
{
  contourLayerOfRay = layer;
  layerReach.x = layer == 0 ? -3.0e38 : element(contours, 2 * (layer - 1)).r;
  layerReach.y = layer == numberOfContours ? 3.0e38 : element(contours, 2 * layer).r;
  layerIsKnown = true;
  if (contourLayers)
  {
    vec4 contour = element(contours, 2 * max(layer - 1, 0));
    enterLayer(int(layer == 0 ? contour.y : contour.z));
  }
}

// In model coordinates, in the tetrahedron with these vertices, at the place with these weights of them.
vec3 contourNormal(ivec4 v, vec4 w)
{
  vec4 a = element(points, v.x), b = element(points, v.y), c = element(points, v.z), d = element(points, v.w);
  vec4 scalars = vec4(a.w, b.w, c.w, d.w);
  if (!contourOfColor)
  {
    scalars = vec4(element(contourScalars, v.x).r, element(contourScalars, v.y).r, element(contourScalars, v.z).r,
      element(contourScalars, v.w).r);
  }
  vec3 normal = levelNormal(a.xyz, b.xyz, c.xyz, d.xyz, scalars);
  if (smoothContourNormals)
  {
    vec3 gradient = w.x * element(contourGradients, v.x).xyz + w.y * element(contourGradients, v.y).xyz +
      w.z * element(contourGradients, v.z).xyz + w.w * element(contourGradients, v.w).xyz;
    normal = gradient == vec3(0.0) ? normal : gradient;
  }
  return normal;
}
