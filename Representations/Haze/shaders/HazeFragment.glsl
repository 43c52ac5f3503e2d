// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the fragment is, in view coordinates: in perspective from 1 / w, which is exact to float at every distance, as depths are not.
uniform vec4 hazeViewport;   // lower left corner in pixels, 2 / width, 2 / height
uniform mat3 hazeFromDevice; // (x w, y w, w) or, of parallel rays, (x, y, z) in device coordinates, to VC
uniform vec3 hazeDeviceOrigin;

vec3 hazeFragmentVC()
{
  vec2 place = (gl_FragCoord.xy - hazeViewport.xy) * hazeViewport.zw - 1.0;
  vec3 device = hazeParallel != 0 ? vec3(place, 2.0 * gl_FragCoord.z - 1.0) : vec3(place, 1.0) / gl_FragCoord.w;
  return hazeFromDevice * (device - hazeDeviceOrigin);
}
