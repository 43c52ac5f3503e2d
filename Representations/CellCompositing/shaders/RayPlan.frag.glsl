//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The next stretch of a ray through several media: up to the place where it enters one of the meshes again.
//   in:  where each ray entered each mesh last, and where it will next
//   out: 0: the last place; bits of the media that are entered there
//        1: faces entered last (-1: none; -2: the ray starts at the eye)
//        from 2 on, of each medium: where it was entered last when the next stretch begins
float stretchEnd = 3.0e38;
vec4 faces = vec4(-1.0);
int enteredAgain = 0;

//NEPHOSCOPE::Media

void main()
{
  findNextEntries();
  advanceMedia();
  gl_FragData[0] = vec4(stretchEnd, float(enteredAgain), 0.0, 0.0);
  gl_FragData[1] = faces;
//NEPHOSCOPE::Outputs
}
