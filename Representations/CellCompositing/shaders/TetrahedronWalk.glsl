// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A ray on its way through tetrahedra, from face to face: TetrahedronWalk.h.
// A vertex as the ray sees it: x and y across, z along the ray, w its scalar; where there are MORE_SCALARS, those for opacity and contours.
// Constants: separateOpacity, opacityOnCells, useContours, contourOfColor.
struct Seen
{
  vec4 place;
#ifdef MORE_SCALARS
  vec2 more;
#endif
};
Seen walkA, walkB, walkC;     // the face that the ray is passing
float walkAB, walkBC, walkCA; // edge functions of its edges
bool walkIsLost; // the ray passed the first face by, or ran within a face or along an edge, to within rounding

float edgeFunction(Seen p, Seen q)
{
  return p.place.x * q.place.y - p.place.y * q.place.x;
}

Seen choose(bool first, Seen p, Seen q)
{
#ifdef MORE_SCALARS
  return Seen(first ? p.place : q.place, first ? p.more : q.more);
#else
  return Seen(first ? p.place : q.place);
#endif
}

float opacityScalar(Seen p)
{
#ifdef MORE_SCALARS
  return separateOpacity && !opacityOnCells ? p.more.x : p.place.w;
#else
  return p.place.w;
#endif
}

float contourScalar(Seen p)
{
#ifdef MORE_SCALARS
  return contourOfColor ? p.place.w : p.more.y;
#else
  return p.place.w;
#endif
}

// Returns true if b and c were exchanged.
bool startWalk(Seen a, Seen b, Seen c)
{
  bool turned = edgeFunction(a, b) + edgeFunction(b, c) + edgeFunction(c, a) < 0.0;
  walkA = a;
  walkB = choose(turned, c, b);
  walkC = choose(turned, b, c);
  walkAB = edgeFunction(walkA, walkB);
  walkBC = edgeFunction(walkB, walkC);
  walkCA = edgeFunction(walkC, walkA);
  walkIsLost = min(walkAB, min(walkBC, walkCA)) < 0.0; // a rasterizer may give the face a pixel whose ray passes it by
  walkAB = max(walkAB, 0.0);
  walkBC = max(walkBC, 0.0);
  walkCA = max(walkCA, 0.0);
  return turned;
}

// Leaves the tetrahedron with the vertex d; returns which vertex stays behind.
int stepWalk(Seen d)
{
  float ad = edgeFunction(walkA, d);
  float bd = edgeFunction(walkB, d);
  float cd = edgeFunction(walkC, d);
  float insideABD = lesser(bd, -ad);
  float insideADC = lesser(ad, -cd);
  float insideDBC = lesser(cd, -bd);
  float scale = 1.0e-5 * greater(greater(abs(ad), abs(bd)), abs(cd));
  walkIsLost = walkIsLost || walkAB + walkBC + walkCA <= scale || greater(insideABD, greater(insideADC, insideDBC)) < -scale;
  bool exitABD = insideABD >= insideADC && insideABD >= insideDBC;
  bool exitADC = !exitABD && insideADC >= insideDBC;
  float ab = exitABD ? walkAB : exitADC ? ad : -bd;
  float bc = exitABD ? bd : exitADC ? -cd : walkBC;
  float ca = exitABD ? -ad : exitADC ? walkCA : cd;
  walkAB = greater(ab, 0.0);
  walkBC = greater(bc, 0.0);
  walkCA = greater(ca, 0.0);
  walkA = choose(exitABD || exitADC, walkA, d);
  walkB = choose(exitADC, d, walkB);
  walkC = choose(exitABD, d, walkC);
  return exitABD ? 2 : exitADC ? 1 : 0;
}

// Weights of the vertices of the face where the ray passes it. Where the face is seen edge-on, any of its points will do.
vec3 faceWeights()
{
  vec3 weights = vec3(walkBC, walkCA, walkAB);
  float sum = weights.x + weights.y + weights.z;
  return sum > 0.0 ? weights / sum : vec3(1.0 / 3.0);
}

// Where all vertices of a face are on one side of a value, so is every point of it, in spite of rounding.
float contourScalarOnFace(vec3 weights)
{
  vec3 s = vec3(contourScalar(walkA), contourScalar(walkB), contourScalar(walkC));
  return clamp(dot(weights, s), lesser(s.x, lesser(s.y, s.z)), greater(s.x, greater(s.y, s.z)));
}

// Where the ray passes the face: depth along the ray, and the scalars of colour, opacity and contours.
vec4 passFace()
{
  vec3 weights = faceWeights();
  vec2 pass = weights.x * walkA.place.zw + weights.y * walkB.place.zw + weights.z * walkC.place.zw;
  return vec4(pass,
    weights.x * opacityScalar(walkA) + weights.y * opacityScalar(walkB) + weights.z * opacityScalar(walkC),
    useContours ? contourScalarOnFace(weights) : 0.0);
}
