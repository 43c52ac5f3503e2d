//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One vertex per tetrahedron, in visibility order.
//   in:  the tetrahedron to draw
//   out: its number
in int tetrahedron;
flat out int tetrahedronVSOutput;

void main()
{
  tetrahedronVSOutput = tetrahedron;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
