//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a pixel's ray has to be drawn in slices: the depths between which it lies in two boxes or more. A ray that lies in one box at a
// time is only divided where it enters the second and the last of them.
//   in:  the boxes of the volumes, in coordinates that are at most 1; the matrices between these and device coordinates
//   out: near and far depth; 1 where there is one box or none
uniform int boxCount;
uniform vec3 lowCorners[MOST_BOXES];
uniform vec3 highCorners[MOST_BOXES];
uniform mat4 boxesToDC;
uniform mat4 DCToBoxes;
uniform vec2 sizeOfViewport;
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

void main()
{
  vec3 start = unproject(-1.0);
  vec3 along = unproject(1.0) - start;
  vec2 ranges[MOST_BOXES];
  vec2 shared_ = vec2(never, -1.0); // by two boxes
  vec2 starts = vec2(never, never); // the first two
  float last = -1.0;
  for (int i = 0; i < boxCount; ++i)
  {
    ranges[i] = inBox(start, along, lowCorners[i], highCorners[i]);
    if (ranges[i].x >= ranges[i].y)
    {
      continue;
    }
    float from = ranges[i].x;
    starts = from < starts.x ? vec2(from, starts.x) : vec2(starts.x, min(from, starts.y));
    last = max(last, from);
    for (int j = 0; j < i; ++j)
    {
      vec2 both = vec2(max(from, ranges[j].x), min(ranges[i].y, ranges[j].y));
      shared_ = both.x < both.y ? vec2(min(shared_.x, both.x), max(shared_.y, both.y)) : shared_;
    }
  }
  vec2 span = shared_.x < shared_.y ? shared_ : starts.y <= 1.0 ? vec2(starts.y, last) : vec2(1.0);
  gl_FragData[0] = vec4(depthAt(start + span.x * along), depthAt(start + span.y * along), 0.0, 0.0);
}
