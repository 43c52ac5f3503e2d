//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The depth at the centre of a pixel of a multisampled buffer. Samples lie around it, so that on a plane their mean is the depth there; a
// single one is that of a place beside, on a slope far in front of what the pixel's ray meets. Where most see nothing, there is nothing.
uniform sampler2DMS depths;
uniform int numberOfSamples;
uniform ivec2 corner; // of the region in the buffer
uniform vec2 size;
in vec2 texCoord;     // in the region

void main()
{
  float sum = 0.0;
  int covered = 0;
  for (int i = 0; i < numberOfSamples; ++i)
  {
    float depth = texelFetch(depths, corner + ivec2(texCoord * size), i).r;
    sum += depth < 1.0 ? depth : 0.0;
    covered += depth < 1.0 ? 1 : 0;
  }
  gl_FragDepth = 2 * covered >= numberOfSamples ? sum / float(covered) : 1.0;
}
