// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A ray on its way through hexahedra, from quadrilateral to quadrilateral, and the trilinear field in them.
//
// The ring A, B, C, D is the face through which the ray enters, E, F, G, H are the vertices across from them. As the ray sees them, x and
// y go across, z along it, and w is the scalar; the ray itself is at (0, 0). It passes a face whose edges go once around it. How an edge
// goes by, is a number that it has in common with the cells around it, so that a ray that enters a cell leaves it, whatever the shape of the
// cell and however exactly an edge or a vertex is hit. Two vertices may be one: wedges, pyramids and tetrahedra are hexahedra, with
// the field of theirs.
vec4 walkA, walkB, walkC, walkD, walkE, walkF, walkG, walkH;
float walkAB, walkBC, walkCD, walkDA; // goesBy of the edges
bool walkIsLost; // the ray passed the first face by

// The face through which the ray leaves the cell, as the ring of the next one.
struct Ring
{
  vec4 a, b, c, d;
  float ab, bc, cd, da;
};
Ring ringAhead = Ring(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), 0.0, 0.0, 0.0, 0.0);

// Edge by edge around the ray: which part of a round from p to q, counted where it crosses the axis x > 0.
float goesBy(vec4 p, vec4 q)
{
  float side = p.x * q.y - p.y * q.x;
  return p.y < 0.0 ? (q.y >= 0.0 && side > 0.0 ? 1.0 : 0.0) : (q.y < 0.0 && side < 0.0 ? -1.0 : 0.0);
}

void seeAhead()
{
  walkE = seen(pointOfRing(0, 0, 1));
  walkF = seen(pointOfRing(1, 0, 1));
  walkG = seen(pointOfRing(1, 1, 1));
  walkH = seen(pointOfRing(0, 1, 1));
}

void turnRing()
{
  int b = toB;
  toB = toD;
  toD = b;
}

// Fetches the ring and turns it counterclockwise about the ray. False: the ray does not pass it.
bool seeRing()
{
  walkA = seen(pointOfRing(0, 0, 0));
  walkB = seen(pointOfRing(1, 0, 0));
  walkC = seen(pointOfRing(1, 1, 0));
  walkD = seen(pointOfRing(0, 1, 0));
  walkAB = goesBy(walkA, walkB);
  walkBC = goesBy(walkB, walkC);
  walkCD = goesBy(walkC, walkD);
  walkDA = goesBy(walkD, walkA);
  float rounds = walkAB + walkBC + walkCD + walkDA;
  if (rounds < 0.0)
  {
    turnRing();
    vec4 b = walkB;
    walkB = walkD;
    walkD = b;
    vec4 turned = -vec4(walkDA, walkCD, walkBC, walkAB);
    walkAB = turned.x;
    walkBC = turned.y;
    walkCD = turned.z;
    walkDA = turned.w;
  }
  return rounds != 0.0;
}

// One of the two places where a line may pass the surface that the ring bounds, a bilinear patch: fractions of the ways from A to B and
// from A to D, not yet limited to the patch. `bend` is C - B - (D - A).
vec2 placeOnPatch(vec2 a, vec2 ab, vec2 ad, vec2 bend, float side, float low, float slope, float bow)
{
  float root = sqrt(max(slope * slope - 4.0 * bow * low, 0.0));
  bool stable = side * slope >= 0.0;
  float above = stable ? -2.0 * low : side * root - slope;
  float below = stable ? slope + side * root : 2.0 * bow;
  float u = below == 0.0 ? 0.5 : above / below;
  vec2 start = a + u * ab, way = ad + u * bend;
  float square = dot(way, way);
  return vec2(u, square == 0.0 ? 0.5 : -dot(start, way) / square);
}

float outside(vec2 place)
{
  vec2 beyond = abs(place - 0.5);
  return greater(beyond.x, beyond.y);
}

// Where the ray passes a face.
vec2 placeInFace(vec2 a, vec2 b, vec2 c, vec2 d)
{
  vec2 ab = b - a, ad = d - a, bc = c - b;
  vec2 bend = bc - ad;
  float low = a.x * ad.y - a.y * ad.x; // on one side of the line from AB to DC at 0, and on the other at 1
  float high = b.x * bc.y - b.y * bc.x;
  float bow = ab.x * bend.y - ab.y * bend.x;
  float slope = high - low - bow;
  vec2 place = placeOnPatch(a, ab, ad, bend, 1.0, low, slope, bow);
  if (outside(place) > 0.5001) // seen from the side, a bent face is no convex quadrilateral
  {
    vec2 other = placeOnPatch(a, ab, ad, bend, -1.0, low, slope, bow);
    place = outside(other) < outside(place) ? other : place;
  }
  return clamp(place, 0.0, 1.0);
}

vec2 placeInRing()
{
  return placeInFace(walkA.xy, walkB.xy, walkC.xy, walkD.xy);
}

vec2 placeInRingAhead()
{
  return placeInFace(ringAhead.a.xy, ringAhead.b.xy, ringAhead.c.xy, ringAhead.d.xy);
}

// Distance along the ray, and scalar.
vec2 passRing(vec2 place)
{
  return mix(mix(walkA.zw, walkB.zw, place.x), mix(walkD.zw, walkC.zw, place.x), place.y);
}

vec2 passRingAhead(vec2 place)
{
  return mix(mix(ringAhead.a.zw, ringAhead.b.zw, place.x), mix(ringAhead.d.zw, ringAhead.c.zw, place.x), place.y);
}

// Where a place in the ring is in the cell that the ray left through it, in fractions of the ways along AB, AD and AE of its ring.
vec3 placeInCell(vec2 p, int exit)
{
  return exit == exitAhead ? vec3(p, 1.0) : exit == exitAB ? vec3(p.x, 0.0, p.y) : exit == exitBC ? vec3(1.0, p.y, 1.0 - p.x)
    : exit == exitCD ? vec3(p.x, 1.0, 1.0 - p.y) : vec3(0.0, p.y, p.x);
}

// Finds the ring ahead; returns which face it is.
int leaveCell()
{
  float ef = goesBy(walkE, walkF), fg = goesBy(walkF, walkG), gh = goesBy(walkG, walkH), he = goesBy(walkH, walkE);
  float ae = goesBy(walkA, walkE), bf = goesBy(walkB, walkF), cg = goesBy(walkC, walkG), dh = goesBy(walkD, walkH);
  bool throughEnd = ef + fg + gh + he > 0.0;
  bool throughAB = walkAB + bf - ef - ae > 0.0;
  bool throughBC = walkBC + cg - fg - bf > 0.0;
  bool throughCD = walkCD + dh - gh - cg > 0.0;
  throughAB = throughAB && !throughEnd;
  throughBC = throughBC && !throughEnd && !throughAB;
  throughCD = throughCD && !throughEnd && !throughAB && !throughBC;
  ringAhead.a = throughEnd ? walkE : throughBC ? walkF : throughCD ? walkH : walkA;
  ringAhead.b = throughEnd ? walkF : throughAB || throughBC ? walkB : throughCD ? walkG : walkE;
  ringAhead.c = throughEnd ? walkG : throughAB ? walkF : throughBC || throughCD ? walkC : walkH;
  ringAhead.d = throughEnd ? walkH : throughAB ? walkE : throughBC ? walkG : walkD;
  ringAhead.ab = throughEnd ? ef : throughAB ? walkAB : throughBC ? -bf : throughCD ? -gh : ae;
  ringAhead.bc = throughEnd ? fg : throughAB ? bf : throughBC ? walkBC : throughCD ? -cg : -he;
  ringAhead.cd = throughEnd ? gh : throughAB ? -ef : throughBC ? cg : throughCD ? walkCD : -dh;
  ringAhead.da = throughEnd ? he : throughAB ? -ae : throughBC ? -fg : throughCD ? dh : walkDA;
  return throughEnd ? exitAhead : throughAB ? exitAB : throughBC ? exitBC : throughCD ? exitCD : exitDA;
}

void takeRingAhead()
{
  walkA = ringAhead.a;
  walkB = ringAhead.b;
  walkC = ringAhead.c;
  walkD = ringAhead.d;
  walkAB = ringAhead.ab;
  walkBC = ringAhead.bc;
  walkCD = ringAhead.cd;
  walkDA = ringAhead.da;
}

// At a place in the cell, what a step along AB, AD and AE changes.
mat3x4 changesInCell(vec3 p)
{
  vec4 ae = mix(walkA, walkE, p.z), bf = mix(walkB, walkF, p.z), cg = mix(walkC, walkG, p.z), dh = mix(walkD, walkH, p.z);
  vec4 right = mix(bf - ae, cg - dh, p.y);
  vec4 up = mix(dh, cg, p.x) - mix(ae, bf, p.x);
  vec4 on = mix(mix(walkE - walkA, walkF - walkB, p.x), mix(walkH - walkD, walkG - walkC, p.x), p.y);
  return mat3x4(right, up, on);
}

vec3 stepsToRay = vec3(0.0); // from the place in besidePlace, along AB, AD and AE

// Distance along the ray, and scalar, of the point of the ray next to a place in the cell: where edges are not parallel, a ray is
// no straight line between the places where it enters and leaves.
vec2 besidePlace(vec3 p)
{
  vec4 ae = mix(walkA, walkE, p.z), bf = mix(walkB, walkF, p.z), cg = mix(walkC, walkG, p.z), dh = mix(walkD, walkH, p.z);
  vec4 low = mix(ae, bf, p.x), high = mix(dh, cg, p.x);
  vec4 here = mix(low, high, p.y);
  vec4 right = mix(bf - ae, cg - dh, p.y);
  vec4 up = high - low;
  vec4 on = mix(mix(walkE - walkA, walkF - walkB, p.x), mix(walkH - walkD, walkG - walkC, p.x), p.y);
  // The step from there to the ray, by Newton.
  vec3 upOn = cross(up.xyz, on.xyz);
  float volume = dot(right.xyz, upOn);
  vec3 away = vec3(-here.xy, 0.0);
  vec3 steps = vec3(dot(away, upOn), dot(away, cross(on.xyz, right.xyz)), dot(away, cross(right.xyz, up.xyz)));
  steps = abs(volume) > 0.0 ? steps / volume : vec3(0.0);
  steps = clamp(steps, -p, 1.0 - p);
  stepsToRay = steps;
  return here.zw + steps.x * right.zw + steps.y * up.zw + steps.z * on.zw;
}

// Values of an array at the vertices A to D, or of E to H, of the cell ahead.
vec4 valuesOfRing(FloatArray values, int ahead)
{
  return vec4(element(values, pointOfRing(0, 0, ahead)).r, element(values, pointOfRing(1, 0, ahead)).r,
    element(values, pointOfRing(1, 1, ahead)).r, element(values, pointOfRing(0, 1, ahead)).r);
}

vec2 rangeOfFour(vec4 s)
{
  return vec2(lesser(lesser(s.x, s.y), lesser(s.z, s.w)), greater(greater(s.x, s.y), greater(s.z, s.w)));
}

vec2 rangeOfEight(vec4 near, vec4 far)
{
  vec2 a = rangeOfFour(near), b = rangeOfFour(far);
  return vec2(lesser(a.x, b.x), greater(a.y, b.y));
}

// At a place in the cell: a trilinear field, from its values at A to D and E to H, and what a step along AB, AD and AE changes.
vec4 fieldInCell(vec4 near, vec4 far, vec3 p)
{
  vec4 level = mix(near, far, p.z), on = far - near;
  float low = mix(level.x, level.y, p.x), high = mix(level.w, level.z, p.x);
  return vec4(mix(low, high, p.y), mix(level.y - level.x, level.z - level.w, p.y), high - low,
    mix(mix(on.x, on.y, p.x), mix(on.w, on.z, p.x), p.y));
}

// The same field at the point of the ray next to a place in the cell that besidePlace found last.
float fieldBeside(vec4 near, vec4 far, vec3 p)
{
  vec4 here = fieldInCell(near, far, p);
  return here.x + dot(here.yzw, stepsToRay);
}
