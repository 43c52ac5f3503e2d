//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes where something opaque was drawn, and adds nothing to the picture; for a query of the number of samples.
uniform sampler2D opaqueDepth;

void main()
{
  if (texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r == 1.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
}
