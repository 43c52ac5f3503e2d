//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One vertex per splat, from back to front.
//   in:  drawingOrder[gl_VertexID], the splat to draw
//   out: its number
uniform isamplerBuffer drawingOrder;
flat out int splatVSOutput;

void main()
{
  splatVSOutput = texelFetch(drawingOrder, gl_VertexID).r;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
