// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Optical depth of the cloud that a ray enters at a front face, up to the next back face or to what is opaque.
//   in:  place of the fragment in view coordinates, density there, which way the face looks; the layers of the surface
//   out: optical depth; noThickness where nothing ends the cloud; < 0 where the fragment is not the start of one
// A back face without a front face before it ends a cloud that the eye is in: it starts at the near plane. Where the eye is in none, the
// surface is open before it.
// Constants: hasDensity, hasDensityVolume. What looks at the layers is generated: considerLayers(pixel).
uniform sampler2D cloudOpaqueDepth;
uniform vec4 cloudDepthToView; // z = (x + y e) / (z + w e), e = 1 - depth
uniform vec2 cloudOrigin;      // of the viewport, in pixels
uniform float cloudExtinction; // per length
uniform float cloudNear;       // depth of the near plane
uniform int cloudEyeMayBeInside;
uniform int cloudIsParallel;
uniform int cloudFrontIsFront;
uniform int cloudDrawings;     // of layers; 1: lists; < 0: layers are not known

const float noLayer = -1.0e30;
const float noThickness = 1.0e30;
const float sameDepth = 1.0e-6; // relative

float cloudDepthHere;
vec2 cloudNext; // depth of the next back face, and the density there
bool cloudHasFrontBefore;

void considerBack(float depth, float density)
{
  if (depth > cloudDepthHere && depth < cloudNext.x)
  {
    cloudNext = vec2(depth, density);
  }
}

void considerLayer(vec4 depths, vec4 densities)
{
  considerBack(depths.y > noLayer ? -depths.y : noThickness, densities.y);
  considerBack(depths.w, densities.w);
  cloudHasFrontBefore = cloudHasFrontBefore || (depths.x > noLayer && -depths.x < cloudDepthHere);
}

//NEPHOSCOPE::Layers
//NEPHOSCOPE::DensityVolume

// Mean density from the first end to a share of the way to the second, where it changes linearly.
float meanDensity(float first, float second, float share)
{
  return first + 0.5 * share * (second - first);
}

vec3 placeOnRay(vec3 view, float depth)
{
  return cloudIsParallel != 0 ? vec3(view.xy, -depth) : view * (depth / -view.z);
}

float cloudOpticalDepth(vec3 view, float density, bool isFront)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - cloudOrigin);
  float depth = -view.z;
  float lengthPerDepth = cloudExtinction * (cloudIsParallel != 0 ? 1.0 : length(view) / abs(view.z));
  cloudDepthHere = depth + (isFront ? -sameDepth : sameDepth) * abs(depth); // where both faces meet they are a pair
  cloudNext = vec2(noThickness, density);
  cloudHasFrontBefore = false;
  considerLayers(pixel);
  if (!isFront && (cloudHasFrontBefore || cloudEyeMayBeInside == 0)) // known before the way through a density volume is walked
  {
    return cloudHasFrontBefore ? -1.0 : noThickness;
  }
  if (!isFront)
  {
    float mean = hasDensityVolume ? meanDensityOfVolume(placeOnRay(view, cloudNear), view) : density;
    return max(depth - cloudNear, 0.0) * lengthPerDepth * mean;
  }
  float e = 1.0 - texelFetch(cloudOpaqueDepth, pixel, 0).r;
  float opaque = e > 0.0 ? -(cloudDepthToView.x + cloudDepthToView.y * e) / (cloudDepthToView.z + cloudDepthToView.w * e) : noThickness;
  float end = min(cloudNext.x, opaque);
  if (end >= noThickness)
  {
    return noThickness;
  }
  float whole = cloudNext.x < noThickness ? max(cloudNext.x - depth, 0.0) : 0.0;
  float part = max(end - depth, 0.0);
  if (hasDensityVolume)
  {
    return part * lengthPerDepth * meanDensityOfVolume(view, placeOnRay(view, end));
  }
  return part * lengthPerDepth * meanDensity(density, cloudNext.y, whole > 0.0 ? part / whole : 0.0);
}
