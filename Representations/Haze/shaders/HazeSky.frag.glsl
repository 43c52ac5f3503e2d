//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Haze along the whole ray of a pixel: up to where there is none, or down to altitude 0.
//   out: premultiplied colour and alpha = 1 - T, to be laid over the background
//NEPHOSCOPE::Haze
//NEPHOSCOPE::HazeFragment

float flatHazeLengthToSky(float altitude, float rise)
{
  float slope = max(abs(rise), 1.0e-6);
  return (rise >= 0.0 ? hazeDensity(altitude) : max(0.0, 1.0 - hazeDensity(altitude))) / slope;
}

float globeHazeLengthToSky(HazePlace from, vec3 direction)
{
  const float top = 30.0;
  float radius = from.height.x;
  float altitude = from.height.y;
  float along = dot(from.place, direction);
  float planet = radius - altitude;
  float toGround = altitude * (planet + radius);
  float toTop = (top - altitude) * (planet + top + radius);
  float ground = along * along - toGround;
  float sky = along * along + toTop;
  bool meetsGround = along < 0.0 && ground > 0.0 && altitude > 0.0;
  if (!(sky > 0.0) || (along > 0.0 && toTop < 0.0))
  {
    return 0.0;
  }
  float reach = meetsGround ? toGround / (sqrt(ground) - along) : sqrt(sky) - along;
  float start = along < 0.0 && toTop < 0.0 ? -along - sqrt(sky) : 0.0;
  return globeHazeLength(movedHazePlace(from, start * direction), (reach - start) * direction);
}

void main()
{
  // Parallel rays: any place in front of the camera.
  vec2 place = (gl_FragCoord.xy - hazeViewport.xy) * hazeViewport.zw - 1.0;
  vec3 amid = hazeFromDevice * (vec3(place, hazeParallel != 0 ? 0.0 : 1.0) - hazeDeviceOrigin);
  vec3 startVC = hazeStart(amid);
  vec3 direction = normalize(hazeParallel != 0 ? hazeEye : amid - startVC);
  HazePlace start = hazePlaceOfStart(startVC);
  float air = hazeOnGlobe != 0 ? globeHazeLengthToSky(start, direction)
                               : flatHazeLengthToSky(start.height.y, dot(hazeFrame, direction));
  float opacity = 1.0 - exp(-hazeExtinction * air);
  gl_FragData[0] = vec4(opacity * hazeTint, opacity);
}
