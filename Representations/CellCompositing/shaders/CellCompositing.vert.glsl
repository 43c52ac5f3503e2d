//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One vertex per tetrahedron, in visibility order.
//   in:  drawingOrder[gl_VertexID], the tetrahedron to draw
//   out: its number
uniform isamplerBuffer drawingOrder;
flat out int tetrahedronVSOutput;

void main()
{
  tetrahedronVSOutput = texelFetch(drawingOrder, gl_VertexID).r;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
