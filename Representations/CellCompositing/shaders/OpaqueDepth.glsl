// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Depths in [0, 1] as z in view coordinates (VC).
uniform sampler2D opaqueDepth; // of the opaque geometry
uniform vec4 depthToVC;        // z in VC = (x + y e) / (z + w e) with e = 1 - depth

float zFromDepth(float depth)
{
  float e = 1.0 - depth;
  return (depthToVC.x + depthToVC.y * e) / (depthToVC.z + depthToVC.w * e);
}
