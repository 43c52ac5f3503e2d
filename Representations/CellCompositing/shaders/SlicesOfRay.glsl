// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A ray on its way through slices of depth, front to back. Light is that of the present slice.
//   FOR_EACH_SLICE(light, z, part)  what follows is done for each part, in one slice, of what lies between two places along the ray
#ifdef IN_SLICES
const bool inSlices = true;
float sliceEnds[SLICES]; // places along the ray; what lies behind the last one is in it
vec4 sliceLights[SLICES];
int slice = 0;
float transparencyBefore = 1.0; // of the slices before

void startSlices()
{
  for (int i = 0; i < SLICES; ++i)
  {
    sliceLights[i] = vec4(0.0);
  }
  slice = 0;
  transparencyBefore = 1.0;
}

// Those that end at a place, or before.
void closeSlices(inout vec4 light, float place)
{
  while (slice < SLICES - 1 && sliceEnds[slice] <= place)
  {
    sliceLights[slice] = light;
    transparencyBefore *= 1.0 - light.a;
    light = vec4(0.0);
    ++slice;
  }
}

float endInSlice(float place)
{
  return slice < SLICES - 1 ? min(place, sliceEnds[slice]) : place;
}

vec2 nextPart(inout vec4 light, float from, float to)
{
  closeSlices(light, from);
  return vec2(from, endInSlice(to));
}

bool endsInSlice(float place)
{
  return endInSlice(place) == place;
}

float transparencyOf(vec4 light)
{
  return transparencyBefore * (1.0 - light.a);
}

#define FOR_EACH_SLICE(light, z, part) for (vec2 part = nextPart(light, (z).x, (z).y); part.x < part.y; part = nextPart(light, part.y, (z).y))
#define PUT_LIGHT(light) sliceLights[slice] = light; PUT_SLICES(sliceLights)
#else
const bool inSlices = false;
void startSlices() {}
void closeSlices(inout vec4 light, float place) {}

float endInSlice(float place)
{
  return place;
}

bool endsInSlice(float place)
{
  return true;
}

float transparencyOf(vec4 light)
{
  return 1.0 - light.a;
}

#define FOR_EACH_SLICE(light, z, part) vec2 part = z; if (part.y > part.x)
#define PUT_LIGHT(light) gl_FragData[0] = light;
#endif
