// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces of projected cells: a segment is cut where its contour scalar crosses a contour value, and the surface is composited
// there, front to back with the pieces of the medium.
//
// The scalar of a face is the same in both tetrahedra that share it, so that a surface that lies in the face belongs to just one of them.
// Constants: contourLayers, contourLighting, contourOfColor, smoothContourNormals.

// A tetrahedron's part of a ray, ends in front and at the back.
struct ContourSegment
{
  int tetrahedron;
  vec4 scalars;          // contour scalars of the vertices
  vec2 ends;             // and at the ends; where an end lies in a face, the same for the tetrahedron beyond it
  vec4 barycentricFront;
  vec4 barycentricBack;
  vec3 positionFrontVC;
  vec3 positionBackVC;
};

vec3 flatNormal(int tetrahedron, vec4 scalars)
{
  ivec4 ids = element(tetrahedra, tetrahedron);
  return gradientMatrix *
    levelNormal(element(points, ids.x).xyz, element(points, ids.y).xyz, element(points, ids.z).xyz, element(points, ids.w).xyz, scalars);
}

vec3 smoothNormal(int tetrahedron, vec4 barycentric)
{
  ivec4 ids = element(tetrahedra, tetrahedron);
  vec3 gradient = vec3(0.0);
  for (int i = 0; i < 4; ++i)
  {
    gradient += barycentric[i] * element(contourGradients, ids[i]).xyz;
  }
  return gradientMatrix * gradient;
}

// Premultiplied colour and alpha of a contour surface at a place of the segment.
vec4 contourSurface(int contour, ContourSegment segment, vec2 s, float place)
{
  vec4 surface = contourColor(contour, s.x);
  if (surface.a <= 0.0)
  {
    return vec4(0.0);
  }
  if (contourLighting)
  {
    vec4 barycentric = mix(segment.barycentricFront, segment.barycentricBack, place);
    vec3 normal = flatNormal(segment.tetrahedron, segment.scalars);
    if (smoothContourNormals)
    {
      vec3 gradient = smoothNormal(segment.tetrahedron, barycentric);
      normal = gradient == vec3(0.0) ? normal : gradient;
    }
    surface.rgb = litColor(surface.rgb, unit(normal), mix(segment.positionFrontVC, segment.positionBackVC, place));
  }
  return vec4(surface.a * surface.rgb, surface.a);
}

// As integrateSegment, with the surfaces that the segment crosses. `layer` is that of the tetrahedron, where layers are not those
// between the contours.
vec4 integrateSegmentWithContours(vec2 front, vec2 back, float opticalScale, ContourSegment segment, int layer)
{
  int current = contourLayer(segment.ends.x);
  int last = contourLayer(segment.ends.y);
  int direction = last < current ? -1 : 1;
  vec4 result = vec4(0.0);
  float from = 0.0;
  vec2 start = front;
  while (result.a < 0.9999999)
  {
    if (useLayers && !contourLayers)
    {
      selectLayer(layer);
    }
    selectContourLayer(current);
    bool atEnd = current == last;
    int contour = direction > 0 ? current : current - 1;
    float value = atEnd ? 0.0 : element(contours, 2 * contour).r;
    float to = atEnd ? 1.0 : clamp((value - segment.ends.x) / (segment.ends.y - segment.ends.x), from, 1.0);
    vec2 end = atEnd ? back : mix(front, back, to);
    if (contourOfColor && !atEnd)
    {
      end.x = value; // where a transfer function may jump
    }
    vec4 medium = integrateSegment(start, end, (to - from) * opticalScale);
#ifdef NEPHOSCOPE_HAZE
    vec3 endVC = mix(segment.positionFrontVC, segment.positionBackVC, to);
    medium = hazedSegment(medium, mix(segment.positionFrontVC, segment.positionBackVC, from), endVC);
#endif
    result += (1.0 - result.a) * medium;
    if (atEnd)
    {
      break;
    }
    vec4 surface = contourSurface(contour, segment, end, to);
#ifdef NEPHOSCOPE_HAZE
    surface = hazedLight(surface, endVC);
#endif
    result += (1.0 - result.a) * surface;
    current += direction;
    start = end;
    from = to;
  }
  return result;
}
