// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A walk along a ray through the boxes of a uniform grid, in coordinates in which boxes are unit cubes from 0 to `counts`.
//   for (GridWalk walk = beginWalk(start, way, counts); walk.from < walk.end; goOn(walk))
// The ray is in walk.box from the fraction walk.from of its way to walk.to, which are the same where it touches the box only.
struct GridWalk
{
  vec3 start, perWay;
  ivec3 counts, ahead, box; // ahead: 1 along the axes along which the ray rises, else 0
  vec3 leave;               // where it leaves the box along each axis
  float from, to, end;
  int left; // boxes that it may still meet
};

void findExit(inout GridWalk walk)
{
  walk.leave = (vec3(walk.box + walk.ahead) - walk.start) * walk.perWay;
  walk.to = max(walk.from, min(walk.end, min(walk.leave.x, min(walk.leave.y, walk.leave.z))));
}

GridWalk beginWalk(vec3 start, vec3 way, ivec3 counts)
{
  GridWalk walk;
  walk.start = start;
  walk.perWay = 1.0 / mix(way, vec3(1.0e-20), lessThan(abs(way), vec3(1.0e-20)));
  vec3 toLow = -start * walk.perWay, toHigh = (vec3(counts) - start) * walk.perWay;
  vec3 entries = min(toLow, toHigh), exits = max(toLow, toHigh);
  walk.from = max(0.0, max(entries.x, max(entries.y, entries.z)));
  walk.end = min(1.0, min(exits.x, min(exits.y, exits.z)));
  walk.counts = counts;
  walk.box = clamp(ivec3(floor(start + walk.from * way)), ivec3(0), counts - 1);
  walk.ahead = ivec3(greaterThan(walk.perWay, vec3(0.0)));
  walk.left = counts.x + counts.y + counts.z + 3;
  findExit(walk);
  return walk;
}

void goOn(inout GridWalk walk)
{
  ivec3 side = 2 * walk.ahead - 1;
  vec3 leave = walk.leave;
  walk.box += leave.x <= leave.y && leave.x <= leave.z ? ivec3(side.x, 0, 0)
    : leave.y <= leave.z                               ? ivec3(0, side.y, 0)
                                                       : ivec3(0, 0, side.z);
  walk.from = walk.to;
  --walk.left;
  bool isOutside = any(lessThan(walk.box, ivec3(0))) || any(greaterThanEqual(walk.box, walk.counts));
  walk.end = isOutside || walk.left == 0 ? walk.from : walk.end;
  findExit(walk);
}
