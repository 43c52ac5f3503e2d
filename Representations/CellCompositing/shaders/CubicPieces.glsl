// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The scalar of a cell along a ray: in a trilinear field a polynomial of third degree. It is cut into pieces that are linear to within
// CUBIC_TOLERANCE of the scalar's range, of which each is integrated exactly.
const float cubicTolerance = 1.0 / 512.0;
const float mostPieces = 16.0;

// The first three pieces of a ray in a cell: distances where they begin and end, the scalars there, and those of a separate opacity.
vec4 places = vec4(0.0), scalars = vec4(0.0), opacityScalarsHere = vec4(0.0);
float numberOfPieces = 3.0; // of the whole cell

float lesserOf(vec3 v)
{
  float xy = v.x < v.y ? v.x : v.y;
  return xy < v.z ? xy : v.z;
}

float lowestOf(vec4 v)
{
  return min(lesserOf(v.xyz), v.w);
}

// The coefficients of a polynomial from its values at 0, 1/3, 2/3 and 1. From differences, since large values would be rounded.
vec4 cubicThrough(vec4 v)
{
  vec3 d = v.yzw - v.x;
  return vec4(v.x, dot(d, vec3(9.0, -4.5, 1.0)), dot(d, vec3(-22.5, 18.0, -4.5)), dot(d, vec3(13.5, -13.5, 4.5)));
}

float cubicAt(vec4 cubic, float t)
{
  return cubic.x + t * (cubic.y + t * (cubic.z + t * cubic.w));
}

// Where the polynomial turns back between 0 and 1, ascending; 1 where it does not.
vec2 turnsOfCubic(vec4 cubic)
{
  float square = 3.0 * cubic.w, bend = cubic.z;
  float root = bend * bend - square * cubic.y;
  float sum = -bend - (bend < 0.0 ? -1.0 : 1.0) * sqrt(max(root, 0.0));
  vec2 turns = vec2(square == 0.0 ? 1.0 : sum / square, sum == 0.0 ? 1.0 : cubic.y / sum);
  turns = mix(turns, vec2(1.0), bvec2(root <= 0.0));
  turns = mix(vec2(1.0), turns, bvec2(turns.x > 0.0 && turns.x < 1.0, turns.y > 0.0 && turns.y < 1.0));
  return vec2(min(turns.x, turns.y), max(turns.x, turns.y));
}

// A chord of a part 1 / n departs from the curve by an eighth of the second derivative, by n squared.
float bendOfCubic(vec4 cubic)
{
  return 0.25 * max(abs(cubic.z), abs(cubic.z + 3.0 * cubic.w));
}

float countPieces(vec4 cubic)
{
  return clamp(ceil(sqrt(bendOfCubic(cubic) / cubicTolerance)), 1.0, mostPieces);
}

// The trilinear field along a ray through a cell, and the scalars between which it lies in the cell, and along the ray.
struct CubicField
{
  vec4 cubic;
  vec2 range;
  vec2 rangeOfRay;
};

const CubicField noField = CubicField(vec4(0.0), vec2(0.0), vec2(0.0));

CubicField levelField(float value)
{
  return CubicField(vec4(value, 0.0, 0.0, 0.0), vec2(value), vec2(value));
}

float fieldAt(CubicField field, float t)
{
  return clamp(cubicAt(field.cubic, t), field.range.x, field.range.y);
}
