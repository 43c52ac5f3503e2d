//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which of several media a pixel's ray enters, where it is a single one: then no other has to be walked through with it.
//   in:  where each ray enters each mesh first
//   out: number of the medium; that of all media if the ray enters several, or none
float owner = 0.0;
int entered = 0;

void look(int medium, vec2 entry)
{
  if (entry.x >= 0.0)
  {
    owner = float(medium);
    ++entered;
  }
}

//NEPHOSCOPE::Media

void main()
{
  lookAtMedia(ivec2(gl_FragCoord.xy));
  gl_FragData[0] = vec4(entered == 1 ? owner : float(numberOfMedia), 0.0, 0.0, 0.0);
}
