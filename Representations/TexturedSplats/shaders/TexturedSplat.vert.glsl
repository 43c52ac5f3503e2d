//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One vertex per splat, from back to front.
//   in:  drawingOrder[gl_VertexID], the splat to draw
//   out: its number, and its weight where levels of the hierarchy fade into each other
//NEPHOSCOPE::Constants
uniform isamplerBuffer drawingOrder;
flat out int splatVSOutput;
#ifdef FADE
uniform samplerBuffer drawingWeights; // of the extinction
flat out float weightVSOutput;
#endif

void main()
{
  splatVSOutput = texelFetch(drawingOrder, gl_VertexID).r;
#ifdef FADE
  weightVSOutput = texelFetch(drawingWeights, gl_VertexID).r;
#endif
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
