//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a pixel's ray has to be drawn in slices: the depths between which it may lie in two boxes or more, from where it enters the second
// to where it leaves the last but one. Before and behind there is one medium alone.
//   in:  the boxes of the media, in coordinates that are at most 1; the matrices between these and device coordinates; whether a medium is
//        only between the depths of its square of pixels (DepthTiles.h)
//   out: near and far depth; 1 where there is one box or none; where two boxes lie apart, the depth where the second begins
uniform int boxCount;
uniform vec3 lowCorners[MOST_BOXES];
uniform vec3 highCorners[MOST_BOXES];
uniform mat4 boxesToDC;
uniform mat4 DCToBoxes;
uniform vec2 sizeOfViewport;
uniform int inTiles[MOST_BOXES];
uniform sampler2D tiles;
uniform int sideOfTiles;
const float never = 2.0;

vec3 unproject(float z)
{
  vec4 place = DCToBoxes * vec4(2.0 * gl_FragCoord.xy / sizeOfViewport - 1.0, z, 1.0);
  return place.xyz / place.w;
}

// The part of a segment that lies in a box; empty where x >= y.
vec2 inBox(vec3 start, vec3 along, vec3 low, vec3 high)
{
  vec2 range = vec2(0.0, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (along[axis] == 0.0)
    {
      range = start[axis] >= low[axis] && start[axis] <= high[axis] ? range : vec2(1.0, 0.0);
      continue;
    }
    vec2 ends = (vec2(low[axis], high[axis]) - start[axis]) / along[axis];
    range = vec2(max(range.x, min(ends.x, ends.y)), min(range.y, max(ends.x, ends.y)));
  }
  return range;
}

float depthAt(vec3 place)
{
  vec4 device = boxesToDC * vec4(place, 1.0);
  return clamp(0.5 + 0.5 * device.z / device.w, 0.0, 1.0);
}

// The part of a segment between two depths.
vec2 betweenDepths(vec3 start, vec3 along, vec2 depths)
{
  float square = dot(along, along);
  return depths.x < depths.y
    ? vec2(dot(unproject(2.0 * depths.x - 1.0) - start, along), dot(unproject(2.0 * depths.y - 1.0) - start, along)) / square
    : vec2(1.0, 0.0);
}

void main()
{
  vec3 start = unproject(-1.0);
  vec3 along = unproject(1.0) - start;
  vec2 inTile = betweenDepths(start, along, texelFetch(tiles, ivec2(gl_FragCoord.xy) / sideOfTiles, 0).rg);
  vec2 starts = vec2(never);  // the first two
  vec2 ends = vec2(-never);   // the last two
  for (int i = 0; i < boxCount; ++i)
  {
    vec2 range = inBox(start, along, lowCorners[i], highCorners[i]);
    range = inTiles[i] != 0 ? vec2(max(range.x, inTile.x), min(range.y, inTile.y)) : range;
    if (range.x < range.y)
    {
      starts = range.x < starts.x ? vec2(range.x, starts.x) : vec2(starts.x, min(range.x, starts.y));
      ends = range.y > ends.x ? vec2(range.y, ends.x) : vec2(ends.x, max(range.y, ends.y));
    }
  }
  vec2 span = starts.y < never ? vec2(starts.y, max(starts.y, ends.y)) : vec2(1.0);
  gl_FragData[0] = vec4(depthAt(start + span.x * along), depthAt(start + span.y * along), 0.0, 0.0);
}
