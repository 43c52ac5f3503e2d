// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Mean density of cells along a part of a ray, or, if the mean exceeds `enough`, any value between the two: from bin to bin, and in each bin in all tetrahedra that touch it. In a tetrahedron density is
// linear, so that the mean of its two ends times the length is exact. Outside of the cells it is 0.
//
// Places are seen along the ray: two coordinates across it, as whole numbers below 2^23, and the share of the way. An edge passes the ray on its left or
// right, which is decided exactly, and where it meets the ray as if the ray were moved aside by an infinitesimal; vertices of each tetrahedron are
// in the order of their coordinates, which gives an edge the same direction everywhere. So tetrahedra agree on their common edges and faces, and a ray in a
// common face is neither counted twice nor lost.
uniform FloatArray cloudCellPoints;   // place, density
uniform IntegerArray cloudTetrahedra; // their points
uniform IntegerArray cloudBinLists;   // where the list of each bin begins, and of the one after the last; then lists of tetrahedra
uniform mat4 cloudViewToCells;
uniform vec3 cloudBinsLow;
uniform vec3 cloudBinsPerLength;
uniform vec3 cloudBinCounts;
uniform float cloudCellsRadius; // about the origin of places
uniform int cloudFirstCellDensity; // element of cloudCellPoints from which on densities of tetrahedra are, 4 in each; < 0: they are of points

vec3 cloudRayStart, cloudRayAcross, cloudRayUp, cloudRayAlong;

vec3 alongRay(vec3 place)
{
  vec3 p = place - cloudRayStart;
  return vec3(floor(vec2(dot(p, cloudRayAcross), dot(p, cloudRayUp)) + 0.5), dot(p, cloudRayAlong));
}

// The sign of a.x b.y - a.y b.x, in two digits of 12 bits.
bool isLeftExactly(ivec2 a, ivec2 b)
{
  ivec2 aHigh = a >> 12, aLow = a & 4095, bHigh = b >> 12, bLow = b & 4095;
  int low = aLow.x * bLow.y - aLow.y * bLow.x;
  int middle = aHigh.x * bLow.y + aLow.x * bHigh.y - aHigh.y * bLow.x - aLow.y * bHigh.x + (low >> 12);
  int high = aHigh.x * bHigh.y - aHigh.y * bHigh.x + (middle >> 12);
  int rest = (middle & 4095) | (low & 4095);
  bool beside = a.x != b.x ? a.x < b.x : a.y < b.y;
  return high != 0 ? high > 0 : rest != 0 || beside;
}

bool cloudIsClose; // the ray to an edge of the tetrahedron, by rounding

// Twice the area of the triangle of the edge and the ray, and whether the ray has the edge on its left, where it is not close.
float edgeArea(vec3 a, vec3 b, out bool left)
{
  float first = a.x * b.y, second = a.y * b.x, area = first - second;
  left = area > 0.0;
  cloudIsClose = cloudIsClose || abs(area) <= 3.0e-7 * (abs(first) + abs(second));
  return abs(area);
}

// Where the ray is in the tetrahedron: share of the way and density there.
vec2 cloudEntry, cloudExit;

// A face with its vertices in their order: whether the ray meets it, and where.
void meetFace(vec3 areas, bvec3 left, vec2 a, vec2 b, vec2 c) // of bc, ac, ab
{
  if (left.x == left.z && left.x != left.y)
  {
    float area = areas.x + areas.y + areas.z;
    vec2 place = area > 0.0 ? (areas.x * a + areas.y * b + areas.z * c) / area : a;
    cloudEntry = place.x < cloudEntry.x ? place : cloudEntry;
    cloudExit = place.x > cloudExit.x ? place : cloudExit;
  }
}

// Where the ray is in a tetrahedron.
void crossTetrahedron(vec3 a, vec3 b, vec3 c, vec3 d, vec4 densities)
{
  bvec3 leftA, leftB;
  cloudIsClose = false;
  vec3 fromA = vec3(edgeArea(a, b, leftA.x), edgeArea(a, c, leftA.y), edgeArea(a, d, leftA.z));
  vec3 others = vec3(edgeArea(b, c, leftB.x), edgeArea(b, d, leftB.y), edgeArea(c, d, leftB.z));
  // At most once: software OpenGL does both sides of a condition, but no loop that nobody is in. One for all edges, as Mesa ends every loop of a
  // shader when they have made 65,535 iterations in all.
  while (cloudIsClose)
  {
    ivec2 p = ivec2(a.xy), q = ivec2(b.xy), r = ivec2(c.xy), s = ivec2(d.xy);
    leftA = bvec3(isLeftExactly(p, q), isLeftExactly(p, r), isLeftExactly(p, s));
    leftB = bvec3(isLeftExactly(q, r), isLeftExactly(q, s), isLeftExactly(r, s));
    cloudIsClose = false;
  }
  vec2 atA = vec2(a.z, densities.x), atB = vec2(b.z, densities.y), atC = vec2(c.z, densities.z), atD = vec2(d.z, densities.w);
  cloudEntry = vec2(1.0e30, 0.0);
  cloudExit = vec2(-1.0e30, 0.0);
  meetFace(vec3(others.x, fromA.y, fromA.x), bvec3(leftB.x, leftA.y, leftA.x), atA, atB, atC);
  meetFace(vec3(others.y, fromA.z, fromA.x), bvec3(leftB.y, leftA.z, leftA.x), atA, atB, atD);
  meetFace(vec3(others.z, fromA.z, fromA.y), bvec3(leftB.z, leftA.z, leftA.y), atA, atC, atD);
  meetFace(vec3(others.z, others.y, others.x), bvec3(leftB.z, leftB.y, leftB.x), atB, atC, atD);
}

// The integral of the density in a tetrahedron from one share of the way to another.
float integralInTetrahedron(int tetrahedron, float from, float to)
{
  ivec4 points = element(cloudTetrahedra, tetrahedron);
  vec4 a = element(cloudCellPoints, points.x), b = element(cloudCellPoints, points.y), c = element(cloudCellPoints, points.z),
       d = element(cloudCellPoints, points.w);
  vec4 densities = vec4(a.w, b.w, c.w, d.w);
  if (cloudFirstCellDensity >= 0)
  {
    densities = vec4(element(cloudCellPoints, cloudFirstCellDensity + (tetrahedron >> 2))[tetrahedron & 3]);
  }
  crossTetrahedron(alongRay(a.xyz), alongRay(b.xyz), alongRay(c.xyz), alongRay(d.xyz), densities);
  float first = max(cloudEntry.x, from), last = min(cloudExit.x, to);
  float middle = (0.5 * (first + last) - cloudEntry.x) / max(cloudExit.x - cloudEntry.x, 1.0e-30);
  return last > first ? (last - first) * mix(cloudEntry.y, cloudExit.y, middle) : 0.0;
}

float integralInBin(ivec3 bin, float from, float to)
{
  ivec3 counts = ivec3(cloudBinCounts);
  int number = bin.x + counts.x * (bin.y + counts.y * bin.z);
  int end = element(cloudBinLists, number + 1).x;
  int i = element(cloudBinLists, number).x;
  float sum = 0.0;
  for (; i < end; ++i)
  {
    sum += integralInTetrahedron(element(cloudBinLists, i).x, from, to);
  }
  cloudIsCut = cloudIsCut || i < end;
  return sum;
}

void lookAlong(vec3 start, vec3 way)
{
  vec3 size = abs(way);
  vec3 aside = size.x <= size.y && size.x <= size.z ? vec3(1.0, 0.0, 0.0) : size.y <= size.z ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  cloudRayStart = start;
  float scale = 8388607.0 / (cloudCellsRadius + length(start));
  vec3 across = normalize(cross(aside, way));
  cloudRayAcross = scale * across;
  cloudRayUp = scale * normalize(cross(way, across));
  cloudRayAlong = way / dot(way, way);
}

float meanDensityOfVolume(vec3 startVC, vec3 endVC, float enough)
{
  vec3 startMC = (cloudViewToCells * vec4(startVC, 1.0)).xyz;
  vec3 wayMC = (cloudViewToCells * vec4(endVC, 1.0)).xyz - startMC;
  if (dot(wayMC, wayMC) == 0.0)
  {
    return 0.0;
  }
  lookAlong(startMC, wayMC);
  vec3 start = (startMC - cloudBinsLow) * cloudBinsPerLength, way = wayMC * cloudBinsPerLength; // in bins
  float sum = 0.0;
  GridWalk walk = beginWalk(start, way, ivec3(cloudBinCounts));
  for (; walk.from < walk.end && sum < enough; goOn(walk))
  {
    if (walk.to > walk.from)
    {
      sum += integralInBin(walk.box, walk.from, walk.to);
    }
  }
  cloudIsCut = cloudIsCut || (walk.from < walk.end && sum < enough);
  return sum;
}
