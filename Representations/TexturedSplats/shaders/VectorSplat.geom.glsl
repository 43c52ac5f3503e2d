// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The quadrangle on which the vector of a splat is drawn.
//   streaks: the kernel of a cell that is lengthened along the vector, so that they are not cut short, with its lattice sum still flat
//   segments: a rectangle around the projected segment, in pixels, and around the one before it while that fades out
uniform FloatArray splatVectors; // vector, phase
uniform FloatArray vectorColors; // colour, seed
uniform float greatestSpeed;        // where vectors are fully drawn
uniform float vectorUnit;           // of streakLength and segmentLength, in units of the data
uniform float streakLength;         // of the kernel along the vector
uniform float segmentLength;
uniform float segmentWidth; // pixels

struct SplatVector
{
  vec3 direction; // in VC, of unit length
  float strength; // 0 to 1
  float weight;   // on the opacity
  float unit;     // in VC
  vec4 color;     // and the seed
  float phase;
};

bool readVector(int splat, out SplatVector vector)
{
  vec4 texel = element(splatVectors, splat);
  vec3 v = mat3(modelToVC) * texel.xyz;
  float speed = length(texel.xyz);
  float magnitude = length(v);
  vector.strength = min(speed / greatestSpeed, 1.0);
  if (!(magnitude > 0.0) || vector.strength < 1.0 / 512.0)
  {
    return false;
  }
  vector.direction = v / magnitude;
  vector.unit = vectorUnit * magnitude / speed;
  vector.phase = texel.w;
  vector.weight = 1.0;
  vector.color = element(vectorColors, splat);
  return true;
}

// What the unit vector looks like on the plane through the centre that faces the eye: its direction there, and how long it is.
vec3 seenAlong(vec3 direction, vec3 centerVC)
{
  vec2 onScreen = parallelRays ? direction.xy : direction.xy - direction.z * centerVC.xy / centerVC.z;
  float seen = length(onScreen);
  return vec3(seen > 1.0e-5 ? onScreen / seen : vec2(1.0, 0.0), seen);
}

void emitStreaks(SplatVector vector, vec3 centerVC, mat3 jacobianVC)
{
  float cell = length(vector.direction * jacobianVC); // that the splat's own cell is long along the vector
  float longer = max(1.0, streakLength * vector.unit / cell);
  mat3 lengthened = jacobianVC + (longer - 1.0) * outerProduct(vector.direction, vector.direction * jacobianVC);
  SplatLook look;
  look.kind = STREAKS;
  look.factor = 1.0;
  look.center = centerVC;
  look.small = false;
  // Cells that are close together along the vector overlap the more.
  look.color = vec4(vector.color.rgb, vector.weight * vector.strength * min(1.0, cell / vector.unit));
  look.vector = vec4(seenAlong(vector.direction, centerVC), vector.phase);
  look.detail = vec4(vector.unit, vector.strength, vector.color.a, 0.0);
  emitKernel(centerVC, lengthened, look);
}

// half_: from the middle of the segment to its end.
void emitSegmentAt(vec3 middle, vec3 half_, float weight, SplatVector vector, vec3 centerVC)
{
  if (!(weight > 0.0) || (!parallelRays && middle.z >= 0.0))
  {
    return;
  }
  vec4 middleDC = VCToDC * vec4(middle, 1.0);
  vec2 pixels = toPixels(half_, middleDC);
  float reach = length(pixels);
  vec2 along = reach > 1.0e-4 ? pixels / reach : vec2(1.0, 0.0);
  vec2 size = vec2(reach, 0.5 * segmentWidth) + 3.5 * SEGMENT_FILTER;
  SplatLook look;
  look.kind = SEGMENT;
  look.center = centerVC;
  look.small = false;
  look.color = vec4(vector.color.rgb, weight * vector.weight * vector.strength);
  look.vector = vec4(0.0);
  look.detail = vec4(2.0 * reach, segmentWidth, 0.0, 0.0);
  look.factor = 1.0;
  look.ends = middle.z + abs(half_.z) * vec2(1.0, -1.0);
  for (int corner = 0; corner < 4; ++corner)
  {
    vec2 at = size * vec2(corner % 2 == 0 ? -1.0 : 1.0, corner < 2 ? -1.0 : 1.0);
    vec2 offset = (at.x * along + at.y * vec2(-along.y, along.x)) / pixelsPerDC;
    vec3 positionVC = middle + (reach > 1.0e-4 ? clamp(at.x / reach, -1.0, 1.0) : 0.0) * half_;
    emitCorner(at, positionVC, middle, 1.0, look, vec4(middleDC.xy + offset * middleDC.w, middleDC.zw));
  }
  EndPrimitive();
}

// Somewhere in the cell, moved on along the vector: VectorTexture.h.
void emitSegment(SplatVector vector, vec3 centerVC, mat3 jacobianVC)
{
  vec3 jitter = fract(vector.color.a * vec3(1.0, 61.0, 3721.0)) - 0.5;
  vec3 travel = (segmentLength * vector.unit) * vector.direction;
  float weight = min(vector.phase / SEGMENT_FADE, 1.0);
  vec3 middle = centerVC + jacobianVC * jitter + (vector.phase - 0.5 * (1.0 + SEGMENT_FADE)) * travel;
  vec3 half_ = (0.5 * vector.strength) * travel;
  emitSegmentAt(middle, half_, weight, vector, centerVC);
  emitSegmentAt(middle + travel, half_, 1.0 - weight, vector, centerVC);
}

void emitVector(SplatVector vector, vec3 centerVC, mat3 jacobianVC)
{
  if (drawSegments)
  {
    emitSegment(vector, centerVC, jacobianVC);
  }
  else
  {
    emitStreaks(vector, centerVC, jacobianVC);
  }
}
