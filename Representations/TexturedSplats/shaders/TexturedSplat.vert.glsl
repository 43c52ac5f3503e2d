//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One vertex per splat, from back to front.
//   in:  the splat to draw, its weight where there are weights
//   out: its number, and its weight where levels of the hierarchy fade into each other
//NEPHOSCOPE::Constants
in int splatNumber;
flat out int splatVSOutput;
#ifdef FADE
in float splatWeight; // of the extinction
flat out float weightVSOutput;
#endif

void main()
{
  splatVSOutput = splatNumber;
#ifdef FADE
  weightVSOutput = splatWeight;
#endif
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
