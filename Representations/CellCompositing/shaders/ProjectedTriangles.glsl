// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The thick vertex of a tetrahedron and the fan around it, as ProjectedTriangles.h has them.
struct TetrahedronProjection
{
  vec4 front;      // barycentric coordinates of the thick vertex on the front
  vec4 back;       // and on the back
  float parameter; // front - back in units of the way from the back to the eye
  int positive;    // bit i: q[i] > 0
  int negative;    // bit i: q[i] < 0
};

TetrahedronProjection projectTetrahedron(vec4 q)
{
  const ivec4 bits = ivec4(1, 2, 4, 8);
  TetrahedronProjection p;
  p.front = max(q, 0.0);
  p.back = max(-q, 0.0);
  p.parameter = 0.0;
  ivec4 positive = bits * ivec4(greaterThan(q, vec4(0.0)));
  ivec4 negative = bits * ivec4(lessThan(q, vec4(0.0)));
  p.positive = positive.x + positive.y + positive.z + positive.w;
  p.negative = negative.x + negative.y + negative.z + negative.w;
  if (p.positive != 0 && p.negative != 0)
  {
    float sum = dot(p.front, vec4(1.0));
    p.front /= sum;
    p.back /= dot(p.back, vec4(1.0));
    p.parameter = 1.0 / sum;
  }
  return p;
}

// Whether the edge (a, b) and the thick vertex make a triangle of the fan.
bool isFanEdge(TetrahedronProjection p, int a, int b)
{
  int edge = (1 << a) | (1 << b);
  return (p.positive & ~edge) != 0 && (p.negative & ~edge) != 0;
}
