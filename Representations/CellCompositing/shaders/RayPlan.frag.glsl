//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the next round over several media is to draw: up to the place where a ray enters one of the meshes again.
//   in:  where each ray entered each mesh last, and where it will next
//   out: 0: places from, and up to; bits of the media that are entered there
//        1: faces entered last (-1: none; -2: the ray starts at the eye)
//        from 2 on, of each medium: where it was entered last when the next round begins
uniform sampler2D lastPlan;
uniform int isFirst;

float roundEnd = 3.0e38;
vec4 faces = vec4(-1.0);
int enteredAgain = 0;

//NEPHOSCOPE::Media

void main()
{
  float begin = isFirst != 0 ? -3.0e38 : texelFetch(lastPlan, ivec2(gl_FragCoord.xy), 0).y;
  findNextEntries();
  advanceMedia();
  gl_FragData[0] = vec4(begin, roundEnd, float(enteredAgain), 0.0);
  gl_FragData[1] = faces;
//NEPHOSCOPE::Outputs
}
