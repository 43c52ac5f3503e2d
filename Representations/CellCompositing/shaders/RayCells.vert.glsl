//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One triangle over the whole viewport, without vertex buffers.
//   out: a point and the direction of the ray through each pixel, which are linear in device coordinates p = (x, y):
//        rayPoint * (1, p) and rayDirection * (1, p)
uniform mat3 rayPoint;
uniform mat3 rayDirection;
noperspective out vec3 rayPointVSOutput;
noperspective out vec3 rayDirectionVSOutput;

void main()
{
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  rayPointVSOutput = rayPoint * vec3(1.0, corner);
  rayDirectionVSOutput = rayDirection * vec3(1.0, corner);
  gl_Position = vec4(corner, 1.0, 1.0); // behind every entry, for the depth test
}
