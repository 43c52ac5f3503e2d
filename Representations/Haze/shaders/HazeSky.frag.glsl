//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Haze along the whole ray of a pixel: up to where there is none, or down to altitude 0.
//   out: premultiplied colour and alpha = 1 - T, to be laid over the background
//NEPHOSCOPE::Haze
//NEPHOSCOPE::HazeFragment

void main()
{
  // Parallel rays: any place in front of the camera.
  vec2 place = (gl_FragCoord.xy - hazeViewport.xy) * hazeViewport.zw - 1.0;
  vec3 amid = hazeFromDevice * (vec3(place, hazeParallel != 0 ? 0.0 : 1.0) - hazeDeviceOrigin);
  vec3 startVC = hazeStart(amid);
  vec3 direction = normalize(hazeParallel != 0 ? hazeEye : amid - startVC);
  HazePlace start = hazePlaceOfStart(startVC);
  float air = HAZE_ON_GLOBE ? globeHazeLengthToSky(start, direction)
                               : flatHazeLengthToSky(start.height.y, dot(hazeFrame, direction));
  float opacity = 1.0 - exp(-hazeExtinction * air);
  const float far = 1.0e5; // scale heights: the light is that of the haze on the way
  vec3 light = hazeIsLit() ? hazeAirlight(start, far * direction, opacity) : opacity * hazeTint;
  gl_FragData[0] = vec4(light, opacity);
}
