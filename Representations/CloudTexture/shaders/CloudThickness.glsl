// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Optical depth of the cloud that a ray enters at a front face, up to the next back face or to what is opaque.
//   findCloud    in:  place of the fragment in view coordinates, density there, which way the face looks; the layers of the surface
//                out: whether a cloud starts at the fragment
//   cloudDepth   in:  the same; whether the cloud is seen; optical depth of a layer, for where nothing ends the cloud
//                out: optical depth; if it exceeds cloudEnough, any value between the two
// Two functions, so that depth peeling calls the expensive one only for the fragments of the present peel.
// A back face without a front face before it ends a cloud that the eye is in: it starts at the near plane. Where the eye is in none, the
// surface is open before it.
// Constants: hasDensity, hasDensityVolume, hasDepths: the layers have optical depths in place of densities, from CloudDepths.frag.glsl.
// What looks at the layers is generated: considerLayers(pixel).
uniform sampler2D cloudOpaqueDepth;
uniform vec4 cloudDepthToView; // z = (x + y e) / (z + w e), e = 1 - depth
uniform vec2 cloudOrigin;      // of the viewport, in pixels
uniform float cloudExtinction; // per length
uniform float cloudEnough;     // optical depth beyond which the picture does not change
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
bool cloudIsFront;
vec2 cloudSame; // how far the nearest layer that looks the same way is, and the optical depth there: that of the fragment itself

void considerBack(float depth, float density)
{
  if (depth > cloudDepthHere && depth < cloudNext.x)
  {
    cloudNext = vec2(depth, density);
  }
}

void considerSame(float depth, bool isFront, float opticalDepth)
{
  float distance = abs(depth - cloudDepthHere);
  if (isFront == cloudIsFront && distance < cloudSame.x)
  {
    cloudSame = vec2(distance, opticalDepth);
  }
}

void considerLayer(vec4 depths, vec4 densities)
{
  considerBack(depths.y > noLayer ? -depths.y : noThickness, densities.y);
  considerBack(depths.w, densities.w);
  cloudHasFrontBefore = cloudHasFrontBefore || (depths.x > noLayer && -depths.x < cloudDepthHere);
}

bool cloudIsCut = false; // whether OpenGL has ended a loop in the density volume early

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

vec2 cloudEnds; // depths at which the ray enters and leaves the cloud, noThickness where nothing ends it

bool findCloud(vec3 view, float density, bool isFront)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - cloudOrigin);
  float depth = -view.z;
  cloudDepthHere = depth + (isFront ? -sameDepth : sameDepth) * abs(depth); // where both faces meet they are a pair
  cloudNext = vec2(noThickness, density);
  cloudHasFrontBefore = false;
  cloudIsFront = isFront;
  cloudSame = vec2(noThickness);
  considerLayers(pixel);
  float e = 1.0 - texelFetch(cloudOpaqueDepth, pixel, 0).r;
  float opaque = e > 0.0 ? -(cloudDepthToView.x + cloudDepthToView.y * e) / (cloudDepthToView.z + cloudDepthToView.w * e) : noThickness;
  cloudEnds = isFront ? vec2(depth, min(cloudNext.x, opaque)) : vec2(cloudNear, cloudEyeMayBeInside != 0 ? depth : noThickness);
  return isFront || !cloudHasFrontBefore;
}

float cloudDepth(vec3 view, float density, bool isFront, bool isSeen, float ofLayer)
{
  if (cloudEnds.y >= noThickness)
  {
    return ofLayer;
  }
  if (hasDepths)
  {
    return cloudSame.y < noThickness ? cloudSame.y : ofLayer;
  }
  float part = max(cloudEnds.y - cloudEnds.x, 0.0);
  float ofUnitDensity = part * cloudExtinction * (cloudIsParallel != 0 ? 1.0 : length(view) / abs(view.z)); // where the density is 1
  if (hasDensityVolume)
  {
    if (!isSeen || ofUnitDensity <= 0.0)
    {
      return 0.0;
    }
    return ofUnitDensity * meanDensityOfVolume(placeOnRay(view, cloudEnds.x), placeOnRay(view, cloudEnds.y), cloudEnough / ofUnitDensity);
  }
  float whole = cloudNext.x < noThickness ? max(cloudNext.x - cloudEnds.x, 0.0) : 0.0;
  float share = isFront && whole > 0.0 ? part / whole : 0.0;
  return ofUnitDensity * meanDensity(density, cloudNext.y, share);
}
