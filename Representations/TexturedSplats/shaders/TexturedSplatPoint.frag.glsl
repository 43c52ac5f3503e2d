//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that one splat adds to one pixel of its point: premultiplied colour and alpha = 1 - exp(-extinction * footprint).
//   in:  of the splat: see the vertex shader
//   out: the exact integral along the ray of the kernel in the shape of the cell, as in TexturedSplat.frag.glsl, by fewer operations.
//        Far splats: to first order in their size over the distance, SplatRanges.h says how far
//NEPHOSCOPE::Constants

flat in vec4 colorVSOutput;
flat in vec4 ellipseVSOutput;
flat in vec4 placeVSOutput;
flat in vec4 depthVSOutput;

//NEPHOSCOPE::Footprint

#ifdef DRAW_REGION
//NEPHOSCOPE::Region
flat in vec4 regionVSOutput;
#endif

// Shares of the kernel that are seen; |k|^2 and 1 + h over those of the ray through the centre.
vec2 sharesOfPixel(float q, float inverseK, float along)
{
  float middle = parallelRays ? depthVSOutput.x + along - 1.0 : depthVSOutput.x * along * inverseK;
  return seenShares(middle, depthVSOutput.y * sqrt(inverseK), q, farAway);
}

void main()
{
#ifdef DRAW_REGION
  if (outsideRegion(regionVSOutput))
  {
    discard;
  }
#endif
  vec2 p = gl_FragCoord.xy - placeVSOutput.xy;
  float lean = dot(placeVSOutput.zw, p); // h
  float opticalDepth = colorVSOutput.a;
  float u = dot(ellipseVSOutput.xy, p);
  float v = ellipseVSOutput.z * p.y;
  float q = u * u + v * v;
  float along = 1.0 + lean;
  float inverseK = 1.0;
  if (firstOrder)
  {
    q -= 2.0 * lean * q;
    opticalDepth += dot(depthVSOutput.zw, p);
  }
  if (!parallelRays && !firstOrder)
  {
    inverseK = 1.0 / (along * along + ellipseVSOutput.w * q);
    q *= inverseK;
    vec2 ray = rayOfPixel.xy + rayOfPixel.zw * gl_FragCoord.xy;
    opticalDepth *= sqrt((1.0 + dot(ray, ray)) * inverseK);
  }
  if (q >= 1.0)
  {
    discard;
  }
  opticalDepth *= footprint(q);
  if (cutByOpaque || peeled || clipped)
  {
    const float fromBaseTwo = 0.6931471805599453;
    putLight(fromBaseTwo * opticalDepth * sharesOfPixel(q, firstOrder ? 1.0 - 2.0 * lean : inverseK, along), colorVSOutput.rgb);
    return;
  }
  float alpha = 1.0 - exp2(-opticalDepth);
  gl_FragData[0] = vec4(alpha * colorVSOutput.rgb, alpha);
}
