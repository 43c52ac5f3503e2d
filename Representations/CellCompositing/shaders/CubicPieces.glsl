// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The scalar of a cell along a ray: in a trilinear field a polynomial of third degree. It is cut into pieces that are linear to within
// CUBIC_TOLERANCE of the scalar's range, of which each is integrated exactly.
const float cubicTolerance = 1.0 / 512.0;
const float mostPieces = 16.0;

// The coefficients of a polynomial from its values at 0, 1/3, 2/3 and 1.
vec4 cubicThrough(vec4 v)
{
  return vec4(v.x, dot(v, vec4(-5.5, 9.0, -4.5, 1.0)), dot(v, vec4(9.0, -22.5, 18.0, -4.5)), dot(v, vec4(-4.5, 13.5, -13.5, 4.5)));
}

float cubicAt(vec4 cubic, float t)
{
  return cubic.x + t * (cubic.y + t * (cubic.z + t * cubic.w));
}

// A chord of a part 1 / n departs from the curve by an eighth of the second derivative, by n squared.
float countPieces(vec4 cubic)
{
  float bend = 0.25 * max(abs(cubic.z), abs(cubic.z + 3.0 * cubic.w));
  return clamp(ceil(sqrt(bend / cubicTolerance)), 1.0, mostPieces);
}
