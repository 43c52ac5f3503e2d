// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a fragment of a cloud's surface that is cloud, which multiplies the opacity of that cloud along the ray; and its colour.
//   in:  place and (where hasNormals) normal of the fragment in the surface's own coordinates, texture coordinates, weights of the two
//        sets, cover, what thickness adds to the texture
//   out: share, 0 ... 1; colour, by which that of the surface is multiplied
// Constants: hasSecondSet, hasNormals, hasColors.
uniform float softness;
uniform float opticalDepth; // across the surface
uniform vec4 eyePlace;      // homogeneous: w = 0 for parallel rays
uniform vec3 thinColor;     // where the texture is at its threshold
uniform vec3 thickColor;    // where it exceeds it by colorRange
uniform float colorRange;

const float pixelDeviation = 0.5; // standard deviation of the pixel's filter, in pixels

vec3 footprints[4]; // of the pixel on the texture: both sets, across and up
vec3 facet;

// To be called where all fragments of a pixel's neighbourhood pass: it takes derivatives.
void takeFootprints(vec3 place, vec3 first, vec3 second)
{
  footprints[0] = pixelDeviation * dFdx(first);
  footprints[1] = pixelDeviation * dFdy(first);
  if (hasSecondSet)
  {
    footprints[2] = pixelDeviation * dFdx(placeInSecondSet(second)); // mirrored as the texture is
    footprints[3] = pixelDeviation * dFdy(placeInSecondSet(second));
  }
  if (!hasNormals)
  {
    facet = cross(dFdx(place), dFdy(place));
  }
}

// Optical depth of a layer that is as thick everywhere.
float opticalDepthOfLayer(vec3 place, vec3 normal)
{
  vec3 across = hasNormals ? normal : facet;
  vec3 ray = eyePlace.xyz - eyePlace.w * place;
  float squares = dot(across, across) * dot(ray, ray);
  float cosine = squares > 0.0 ? abs(dot(across, ray)) * inversesqrt(squares) : 1.0;
  return opticalDepth / max(cosine, 1.0e-3);
}

vec3 cloudTexture(vec3 first, vec3 second, vec2 weights)
{
  vec3 tex = filteredTexture(first, footprints[0], footprints[1]);
  if (hasSecondSet)
  {
    vec3 other = filteredTexture(placeInSecondSet(second), footprints[2], footprints[3]);
    tex = blendTextures(tex, other, weights);
  }
  return tex;
}

// Colour and share.
vec4 cloudLook(vec3 first, vec3 second, vec2 weights, float givenCover, float added)
{
  float cover = hasThreshold != 0 ? 0.5 : givenCover;
  vec4 look = vec4(hasColors ? thickColor : vec3(1.0), 1.0);
  if (cover <= 0.0 || cover >= 1.0)
  {
    return cover <= 0.0 ? vec4(0.0) : look;
  }
  vec3 tex = cloudTexture(first, second, weights);
  float excess = tex.x + added - cloudThreshold(tex.z, cover, softness);
  float width = max(sqrt(max(tex.y, 0.0) + softness * softness), 1.0e-4);
  look.a = cloudShare(excess, width);
  if (hasColors)
  {
    look.rgb = mix(thinColor, thickColor, cloudExcess(excess, width, colorRange));
  }
  return look;
}
