// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces inside tetrahedra, and layers of the medium between them: a segment is cut where its contour scalar crosses a
// contour value, and the surface is composited there, front to back with the pieces of the medium.
//
// A point lies above a value when its scalar is >= the value, and a surface is crossed between two ends on different sides. The
// scalar of a face is the same in both tetrahedra that share it, so that a surface that lies in the face belongs to just one of them.
// Constants: contourLayers, contourLighting, contourOfColor, smoothContourNormals.
uniform mat4 MCVCMatrix;
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

void selectContourLayer(int layer)
{
  if (contourLayers)
  {
    vec4 contour = element(contours, 2 * max(layer - 1, 0));
    selectLayer(int(layer == 0 ? contour.y : contour.z));
  }
}

// Normal to the level sets of a linear field over the tetrahedron, in view coordinates; its sign and length do not matter.
vec3 flatNormal(int tetrahedron, vec4 scalars)
{
  ivec4 ids = element(tetrahedra, tetrahedron);
  vec3 a = element(points, ids.x).xyz;
  mat3 edges = mat3(MCVCMatrix) *
    mat3(element(points, ids.y).xyz - a, element(points, ids.z).xyz - a, element(points, ids.w).xyz - a);
  vec3 change = scalars.yzw - scalars.x;
  return change.x * cross(edges[1], edges[2]) + change.y * cross(edges[2], edges[0]) + change.z * cross(edges[0], edges[1]);
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

vec3 unit(vec3 v)
{
  vec3 scaled = v / max(max(abs(v.x), abs(v.y)), abs(v.z)); // squares of small gradients would vanish
  return scaled / length(scaled);
}

// Phong's model as VTK's surfaces have it: both sides alike, a white highlight.
vec3 light(vec3 color, vec3 normalVC, vec3 positionVC)
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

// Premultiplied colour and alpha of a contour surface at a place of the segment.
vec4 contourSurface(int contour, ContourSegment segment, vec2 s, float place)
{
  vec4 surface = element(contours, 2 * contour + 1);
  if (surface.a <= 0.0)
  {
    return vec4(0.0);
  }
  if (surface.r < 0.0)
  {
    if (useLayers)
    {
      selectLayer(0);
    }
    surface.rgb = evaluateColor(findInterval(transferNodes, transferTable, s.x), s.x).rgb;
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
    surface.rgb = light(surface.rgb, unit(normal), mix(segment.positionFrontVC, segment.positionBackVC, place));
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
