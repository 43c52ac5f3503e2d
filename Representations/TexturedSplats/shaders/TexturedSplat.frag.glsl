//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one splat adds to one pixel: premultiplied colour and alpha = 1 - exp(-extinction * footprint).
//   in:  st, a point of the ray in the plane through the centre, in cells; w, the centre seen from the eye in cells
//   out: the exact integral along the ray of the kernel in the shape of the cell (EllipsoidSplat.h): with k = w + st, at right
//        angles to each other, the ray passes the centre at the distance |st| |w| / |k|, and a cell is |ray| / |k| thick
// What opaque geometry, peeled surfaces and clipping planes cut off along the ray is left out: SplatFootprint.glsl.
uniform float extinctionScale;
uniform float vectorScale; // optical depth of a vector at full strength
uniform vec3 streakShape;  // length of the pattern, of the longest tail, and width, in units of the vectors

//NEPHOSCOPE::Constants

#ifdef DRAW_VECTORS
//NEPHOSCOPE::VectorTexture
#endif

in vec2 stGSOutput;
in vec3 positionVCGSOutput;
flat in int kindGSOutput;
flat in vec4 colorGSOutput;
flat in vec2 splatGSOutput;
flat in vec3 centerVCGSOutput;
flat in vec4 vectorGSOutput;
flat in vec4 detailGSOutput;
in vec3 rayGSOutput;
flat in vec3 cellsGSOutput;

//NEPHOSCOPE::Footprint

#ifdef DRAW_REGION
//NEPHOSCOPE::Region
flat in vec4 regionGSOutput;
#endif

#ifdef CAMERA_LIGHT
//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Light
flat in int litSplatGSOutput;
flat in vec2 lightGSOutput;
#endif

vec3 mediumColor()
{
  vec3 color = colorGSOutput.rgb;
#ifdef CAMERA_LIGHT
  color += lightGSOutput.y * colorTowardsCamera(lightGSOutput.x, litSplatGSOutput, parallelRays ? vec3(0.0, 0.0, -1.0) : positionVCGSOutput);
#endif
  return color;
}

// A splat so near that the eye may be inside: all that is in front of the eye.
void drawNear()
{
  vec3 k = rayGSOutput;
  float along = dot(k, k);
  float middle = dot(k, cellsGSOutput) / along; // along the ray, in lengths of it
  vec3 nearest = cellsGSOutput - middle * k;
  float q = dot(nearest, nearest) / (kernelRadius * kernelRadius);
  if (q >= 1.0)
  {
    discard;
  }
  float cell = inversesqrt(along);
  float opticalDepth = extinctionScale * colorGSOutput.a * footprint(q) * length(positionVCGSOutput) * cell;
  putLight(opticalDepth * seenShares(-middle, cell, q, 0.0), mediumColor());
}

#ifdef DRAW_VECTORS
// Streaks on the plane through the centre that faces the eye; lengths along the vector are foreshortened.
float streaksHere()
{
  vec2 nearby = parallelRays ? positionVCGSOutput.xy : positionVCGSOutput.xy * (centerVCGSOutput.z / positionVCGSOutput.z);
  vec2 place = nearby - centerVCGSOutput.xy;
  vec2 along = vectorGSOutput.xy;
  vec2 at = vec2(dot(place, along), dot(place, vec2(-along.y, along.x)));
  float unit = detailGSOutput.x;
  float seen = max(vectorGSOutput.z, 1.0e-3) * unit;
  float width = streakShape.z * unit;
  StreakShape shape = StreakShape(streakShape.x * seen, max(streakShape.y * detailGSOutput.y * seen, width), width,
    STREAK_SPACING * unit, detailGSOutput.w);
  return streakTexture(shape, at, vectorGSOutput.w, detailGSOutput.z);
}

void drawSegment()
{
  vec4 range = seenRanges();
  float z = positionVCGSOutput.z;
  vec2 alpha = vec2(range.y <= z && z <= range.x, range.w <= z && z < range.z) *
    segmentCoverage(stGSOutput, detailGSOutput.x, detailGSOutput.y) * (1.0 - exp(-vectorScale)) * colorGSOutput.a;
  if (!any(greaterThan(alpha, vec2(0.0))))
  {
    discard;
  }
  gl_FragData[0] = vec4(alpha.x * colorGSOutput.rgb, alpha.x);
  if (peeled)
  {
    gl_FragData[1] = vec4(alpha.y * colorGSOutput.rgb, alpha.y);
  }
}

#endif

void main()
{
#ifdef DRAW_REGION
  if (outsideRegion(regionGSOutput))
  {
    discard;
  }
#endif
  if (nearEye && kindGSOutput == VIEWPORT)
  {
    drawNear();
    return;
  }
#ifdef DRAW_VECTORS
  if (kindGSOutput == SEGMENT)
  {
    drawSegment();
    return;
  }
#endif
  float inPlane = dot(stGSOutput, stGSOutput);
  float square = splatGSOutput.x; // |w|^2
  float along = parallelRays ? square : square + inPlane; // |k|^2
  float q = inPlane * square / (along * kernelRadius * kernelRadius);
  if (q >= 1.0)
  {
    discard;
  }
  float ray = parallelRays ? 1.0 : length(positionVCGSOutput);
  float cell = inversesqrt(along); // 1 / |k|
  // Depth of the point nearest to the centre, and a cell along the ray, as z in view coordinates.
  float slope = parallelRays ? 1.0 : -positionVCGSOutput.z;
  float middle = parallelRays ? positionVCGSOutput.z : positionVCGSOutput.z * square / along;
  vec2 window = splatGSOutput.y * footprint(q) * seenShares(middle, slope * cell, q, farAway);
  vec2 opticalDepth = extinctionScale * colorGSOutput.a * window * ray * cell;
#ifdef DRAW_VECTORS
  if (kindGSOutput == STREAKS)
  {
    opticalDepth = vectorScale * colorGSOutput.a * window / FOOTPRINT_PEAK * streaksHere();
  }
  else if (kindGSOutput == HALF_MEDIUM)
  {
    opticalDepth *= 0.5;
  }
#endif
  putLight(opticalDepth, kindGSOutput == STREAKS ? colorGSOutput.rgb : mediumColor());
}
