// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Mean density of an image along a part of a ray, from voxel to voxel. In a voxel the density is trilinear, and so a cubic of the way along a
// ray, which Simpson's rule integrates exactly. Outside of the image it is 0.
uniform sampler3D cloudVolume;
uniform mat4 cloudViewToVolume; // from view coordinates to indices of points

vec4 cloudCorners[2]; // of the voxel: at its low z and at its high z

void readVoxel(ivec3 voxel)
{
  for (int z = 0; z < 2; ++z)
  {
    ivec3 at = voxel + ivec3(0, 0, z);
    cloudCorners[z] = vec4(texelFetch(cloudVolume, at, 0).r, texelFetch(cloudVolume, at + ivec3(1, 0, 0), 0).r,
      texelFetch(cloudVolume, at + ivec3(0, 1, 0), 0).r, texelFetch(cloudVolume, at + ivec3(1, 1, 0), 0).r);
  }
}

float densityInVoxel(vec3 place)
{
  vec4 inZ = mix(cloudCorners[0], cloudCorners[1], place.z);
  vec2 inY = mix(inZ.xy, inZ.zw, place.y);
  return mix(inY.x, inY.y, place.x);
}

float meanDensityOfVolume(vec3 startVC, vec3 endVC)
{
  vec3 start = (cloudViewToVolume * vec4(startVC, 1.0)).xyz;
  vec3 way = (cloudViewToVolume * vec4(endVC, 1.0)).xyz - start;
  ivec3 last = textureSize(cloudVolume, 0) - 1;
  vec3 perWay = 1.0 / mix(way, vec3(1.0e-20), lessThan(abs(way), vec3(1.0e-20)));
  vec3 toLow = -start * perWay, toHigh = (vec3(last) - start) * perWay;
  vec3 entries = min(toLow, toHigh), exits = max(toLow, toHigh);
  float from = max(0.0, max(entries.x, max(entries.y, entries.z)));
  float end = min(1.0, min(exits.x, min(exits.y, exits.z)));
  ivec3 voxel = clamp(ivec3(floor(start + from * way)), ivec3(0), last - 1);
  ivec3 ahead = ivec3(greaterThan(perWay, vec3(0.0)));
  int steps = last.x + last.y + last.z + 3;
  float sum = 0.0;
  for (int i = 0; i < steps && from < end; ++i)
  {
    vec3 leave = (vec3(voxel + ahead) - start) * perWay;
    float to = max(from, min(end, min(leave.x, min(leave.y, leave.z))));
    if (to > from)
    {
      readVoxel(voxel);
      vec3 a = start + from * way - vec3(voxel), b = start + to * way - vec3(voxel);
      sum += (to - from) / 6.0 * (densityInVoxel(a) + 4.0 * densityInVoxel(0.5 * (a + b)) + densityInVoxel(b));
    }
    from = to;
    ivec3 side = 2 * ahead - 1;
    voxel += leave.x <= leave.y && leave.x <= leave.z ? ivec3(side.x, 0, 0)
      : leave.y <= leave.z                            ? ivec3(0, side.y, 0)
                                                      : ivec3(0, 0, side.z);
    if (any(lessThan(voxel, ivec3(0))) || any(greaterThanEqual(voxel, last)))
    {
      break;
    }
  }
  return sum;
}
