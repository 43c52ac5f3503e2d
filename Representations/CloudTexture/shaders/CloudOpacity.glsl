// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How opaque a fragment of a cloud's surface is: the share of it that is cloud, times the opacity of that cloud along the ray.
//   in:  place and (where hasNormals) normal of the fragment in the surface's own coordinates, texture coordinates, cover
//   out: opacity, 0 ... 1
// To be called where all fragments of a pixel's neighbourhood pass: it takes derivatives.
// Constants: hasSecondSet, hasNormals.
uniform vec2 textureWeights;
uniform float softness;
uniform float opticalDepth; // across the surface
uniform vec4 eyePlace;      // homogeneous: w = 0 for parallel rays

const float pixelDeviation = 0.5; // standard deviation of the pixel's filter, in pixels

vec3 textureThroughPixel(vec3 p)
{
  return filteredTexture(p, pixelDeviation * dFdx(p), pixelDeviation * dFdy(p));
}

float opacityAlongRay(vec3 place, vec3 normal)
{
  vec3 across = hasNormals ? normal : cross(dFdx(place), dFdy(place));
  vec3 ray = eyePlace.xyz - eyePlace.w * place;
  float squares = dot(across, across) * dot(ray, ray);
  float cosine = squares > 0.0 ? abs(dot(across, ray)) * inversesqrt(squares) : 1.0;
  return 1.0 - exp(-opticalDepth / max(cosine, 1.0e-3));
}

float cloudOpacity(vec3 place, vec3 normal, vec3 first, vec3 second, float cover)
{
  vec3 tex = textureThroughPixel(first);
  if (hasSecondSet)
  {
    tex = blendTextures(tex, textureThroughPixel(placeInSecondSet(second)), textureWeights);
  }
  return cloudShare(tex, cover, softness) * opacityAlongRay(place, normal);
}
