// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Mean density of an image along a part of a ray, from voxel to voxel, or, if the mean exceeds `enough`, any value between the two. In a voxel the density is trilinear, and
// so a cubic of the way along a ray, which Gauss's rule of two points integrates exactly. Outside of the image it is 0.
// Constant: hasCorners, whether each texel has the densities at four corners of its voxel, those at low z.
uniform sampler3D cloudVolume;
uniform mat4 cloudViewToVolume; // from view coordinates to indices of points

vec4 cloudCorners[2]; // of the voxel: at its low z and at its high z

void readVoxel(ivec3 voxel)
{
  for (int z = 0; z < 2; ++z)
  {
    ivec3 at = voxel + ivec3(0, 0, z);
    cloudCorners[z] = hasCorners ? texelFetch(cloudVolume, at, 0) : vec4(texelFetch(cloudVolume, at, 0).r, texelFetch(cloudVolume, at + ivec3(1, 0, 0), 0).r,
      texelFetch(cloudVolume, at + ivec3(0, 1, 0), 0).r, texelFetch(cloudVolume, at + ivec3(1, 1, 0), 0).r);
  }
}

float densityInVoxel(vec3 place)
{
  vec4 inZ = mix(cloudCorners[0], cloudCorners[1], place.z);
  vec2 inY = mix(inZ.xy, inZ.zw, place.y);
  return mix(inY.x, inY.y, place.x);
}

float meanDensityOfVolume(vec3 startVC, vec3 endVC, float enough)
{
  const float gauss = 0.288675135; // of the way through the voxel, from its middle
  vec3 start = (cloudViewToVolume * vec4(startVC, 1.0)).xyz;
  vec3 way = (cloudViewToVolume * vec4(endVC, 1.0)).xyz - start;
  float sum = 0.0;
  for (GridWalk walk = beginWalk(start, way, textureSize(cloudVolume, 0) - 1); walk.from < walk.end && sum < enough; goOn(walk))
  {
    if (walk.to > walk.from)
    {
      readVoxel(walk.box);
      float part = walk.to - walk.from;
      vec3 middle = start + (walk.from + 0.5 * part) * way - vec3(walk.box), aside = gauss * part * way;
      sum += 0.5 * part * (densityInVoxel(middle - aside) + densityInVoxel(middle + aside));
    }
  }
  return sum;
}
