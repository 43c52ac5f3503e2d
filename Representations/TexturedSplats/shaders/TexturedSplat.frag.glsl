//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one splat adds to one pixel: premultiplied colour and alpha = 1 - exp(-extinction * footprint).
//   in:  st, a point of the ray in the plane through the centre, in cells; w, the centre seen from the eye in cells
//   out: the exact integral along the ray of the kernel in the shape of the cell (EllipsoidSplat.h): with k = w + st, at right
//        angles to each other, the ray passes the centre at the distance |st| |w| / |k|, and a cell is |ray| / |k| thick
// What lies behind opaque geometry is left out: the share of the kernel in front of it along the ray is taken as a polynomial
// of the place where it is cut.
uniform bool parallelRays;
uniform float extinctionScale;
uniform float vectorScale;  // optical depth of a vector at full strength, for a footprint of 1
uniform float streakPeriod; // in sizes of the splat
uniform vec4 vectorColor;   // and whether it counts: otherwise vectors have the splat's colour

//NEPHOSCOPE::Constants

in vec2 stGSOutput;
in vec3 positionVCGSOutput;
flat in vec4 colorGSOutput;
flat in vec2 splatGSOutput;
flat in vec3 centerVCGSOutput;
flat in vec4 vectorGSOutput;
flat in float strengthGSOutput;
in vec3 rayGSOutput;
flat in vec3 cellsGSOutput;

//NEPHOSCOPE::Footprint

// VectorTexture.h: streaks along x, period 1.
float streaks(float along, float y)
{
  float row = round(y / STREAK_SPACING);
  float across = (y - row * STREAK_SPACING) / STREAK_WIDTH;
  float wave = 0.5 + 0.5 * cos(6.283185307179586 * (along + STREAK_GOLDEN * row));
  return exp(-0.5 * across * across) * wave * wave;
}

// Streaks where the vector lies across the ray, a round dot where it points along it.
float vectorTexture(float q)
{
  vec2 nearby = parallelRays ? positionVCGSOutput.xy : positionVCGSOutput.xy * (centerVCGSOutput.z / positionVCGSOutput.z);
  vec2 place = nearby - centerVCGSOutput.xy;
  vec2 axis = vectorGSOutput.xy;
  float along = dot(place, axis) / (streakPeriod * max(vectorGSOutput.z, 0.05));
  float y = dot(place, vec2(-axis.y, axis.x));
  float roundDot = exp(-12.0 * q);
  return mix(roundDot, streaks(along - vectorGSOutput.w, y), smoothstep(0.1, 0.4, vectorGSOutput.z));
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
  float halfChord = kernelRadius * sqrt(1.0 - q) * inversesqrt(along);
  float share = shareBefore((-opaqueZ() - middle) / halfChord) - shareBefore(-middle / halfChord);
  float opticalDepth = extinctionScale * colorGSOutput.a * share * footprint(q) * length(positionVCGSOutput) * inversesqrt(along);
  float alpha = 1.0 - exp(-opticalDepth);
  gl_FragData[0] = vec4(alpha * colorGSOutput.rgb, alpha);
}

void main()
{
  if (nearEye)
  {
    drawNear();
    return;
  }
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
  // Depth of the point nearest to the centre, and half the chord through the kernel, as z in view coordinates.
  float slope = parallelRays ? 1.0 : -positionVCGSOutput.z;
  float middle = parallelRays ? positionVCGSOutput.z : positionVCGSOutput.z * square / along;
  float halfChord = slope * kernelRadius * sqrt(1.0 - q) * cell;
  float share = shareBefore((middle - opaqueZ()) / halfChord);
  float window = footprint(q) * share;
  float opticalDepth = extinctionScale * colorGSOutput.a * splatGSOutput.y * window * ray * cell;
  if (!drawVectors)
  {
    float alpha = 1.0 - exp(-opticalDepth);
    gl_FragData[0] = vec4(alpha * colorGSOutput.rgb, alpha);
    return;
  }
  // The vector lies in the middle of the medium: half of it in front, half behind (SplatOpacity.h).
  float vectorAlpha = 1.0 - exp(-vectorScale * strengthGSOutput * splatGSOutput.y * window * vectorTexture(q));
  vec3 vectorLight = mix(colorGSOutput.rgb, vectorColor.rgb, vectorColor.a);
  float halfway = exp(-0.5 * opticalDepth);
  vec3 mediumLight = colorGSOutput.rgb * (1.0 - halfway);
  gl_FragData[0] = vec4(mediumLight + halfway * mix(mediumLight, vectorLight, vectorAlpha), 1.0 - halfway * halfway * (1.0 - vectorAlpha));
}
