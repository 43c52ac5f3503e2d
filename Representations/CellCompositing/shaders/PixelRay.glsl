// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray of a pixel, or one a little beside it: through `origin` in the direction `along`, across which are two others.
// Uses placeSeen(point): a point as the ray sees it; keepWalk(), for copies of what the walk uses.
// Takes the differences from pixel to pixel. Both are linear in the pixel, so that they are exact; to be called before pixels part.
void keepSteps()
{
  pointStep[0] = dFdx(rayPointVSOutput);
  pointStep[1] = dFdy(rayPointVSOutput);
  directionStep[0] = dFdx(rayDirectionVSOutput);
  directionStep[1] = dFdy(rayDirectionVSOutput);
}

// Copies what loops use: RayCells.frag.glsl says why.
void keepUniforms()
{
  unity = softwareOpenGL ? gl_FragCoord.w : 1.0;
  keepWalk();
  keepTopology();
  keepTable();
}

// `beside`: by how many pixels the ray passes the centre of its pixel.
void makeRay(vec2 beside)
{
  origin = rayPointVSOutput + beside.x * pointStep[0] + beside.y * pointStep[1];
  along = normalize(rayDirectionVSOutput + beside.x * directionStep[0] + beside.y * directionStep[1]);
  // Any two directions across: DuffEtAl2017
  float s = along.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + along.z);
  float b = along.x * along.y * a;
  across1 = vec3(1.0 + s * along.x * along.x * a, s * b, -s * along.x);
  across2 = vec3(b, s + along.y * along.y * a, -along.y);
}

// Fraction of the way to the point with these weights after which the ray passes inside the triangle.
float wayInside(vec2 a, vec2 b, vec2 c, vec3 weights)
{
  const float margin = 3.0e-5;
  vec3 place = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
  float area = place.x + place.y + place.z;
  vec3 coordinates = place / (area == 0.0 ? 1.0 : area);
  vec3 way = max((vec3(margin) - coordinates) / (weights - min(coordinates, vec3(margin))), 0.0);
  return max(way.x, max(way.y, way.z));
}

// Where an attempt passes its pixel's centre: first at it; then up to 0.002 pixels beside; then 0.001, 0.01, 0.05 and 0.25 pixels towards the inside of
// the face through which the ray enters, or farther where it must to pass there; at last at the centre again: a ray that is still lost has
// the least wrong way there.
const int lastAttempt = 8;
vec2 besideCentre(int attempt, ivec3 entered)
{
  if (attempt == 0 || attempt == lastAttempt)
  {
    return vec2(0.0);
  }
  if (attempt < 4)
  {
    return (attempt == 1 ? 2.5e-4 : attempt == 2 ? -7.5e-4 : 0.002) * vec2(0.85, 0.53);
  }
  float reach = attempt == 4 ? 0.001 : attempt == 5 ? 0.01 : attempt == 6 ? 0.05 : 0.25;
  if (startsAtEye != 0)
  {
    return reach * (attempt % 2 == 0 ? vec2(0.85, 0.53) : vec2(-0.53, 0.85));
  }
  makeRay(vec2(0.0));
  // Not towards the middle: the planes of grids often halve their faces.
  vec3 weights = attempt == 4 ? vec3(0.5, 0.3, 0.2) : attempt == 5 ? vec3(0.2, 0.5, 0.3) : vec3(0.3, 0.2, 0.5);
  vec3 a = placeSeen(entered.x), b = placeSeen(entered.y), c = placeSeen(entered.z);
  vec3 inside = mat3(a, b, c) * weights;
  float way = inside.z / length(rayDirectionVSOutput);
  vec3 right = pointStep[0] + way * directionStep[0];
  vec3 up = pointStep[1] + way * directionStep[1];
  mat2 toPixels = inverse(mat2(dot(right, across1), dot(right, across2), dot(up, across1), dot(up, across2)));
  vec2 beside = toPixels * inside.xy;
  return beside * min(0.9, max(wayInside(a.xy, b.xy, c.xy, weights), reach / length(beside)));
}
