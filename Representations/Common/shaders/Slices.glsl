// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where volumes are drawn in slices of depth (VolumeSlices.h), a shader draws all slices of a pass at once.
// Constants: IN_SLICES, SLICES, where volumes are drawn so. PUT_SLICES writes an array of SLICES colours.
#ifdef IN_SLICES
uniform float sliceDepths[SLICES + 1]; // near and far ends

// The depth of an end in a pixel; `ranges`: near and far depth of all slices, those between which the ray is divided.
float sliceDepth(int end, vec4 ranges)
{
  float depth = sliceDepths[end];
  depth = depth <= 0.0 || depth >= 1.0 ? depth : clamp(depth, ranges.z, ranges.w);
  return clamp(depth, ranges.x, ranges.y);
}
#endif
