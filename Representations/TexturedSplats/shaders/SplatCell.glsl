// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a splat is and which shape it has, in view coordinates.
// Splats without a Jacobian of their own are (centre, -), others the columns of J with the centre in the fourth components: all, or the
// nodes of the hierarchy, which follow those that share one.
uniform FloatArray splats;
uniform int firstNode;
uniform mat4 modelToVC;
uniform mat3 sharedJacobian;
uniform bool testsFarEnds;
uniform vec2 sliceZ; // near and far z in VC of what is drawn, where volumes are drawn in slices (VolumeSlices.h)

void readSplat(int splat, out vec3 centerVC, out mat3 jacobianVC)
{
  vec3 center;
  mat3 jacobian = sharedJacobian;
  if (jacobianPerSplat || splat >= firstNode)
  {
    int first = jacobianPerSplat ? 3 * splat : firstNode + 3 * (splat - firstNode);
    vec4 x = element(splats, first);
    vec4 y = element(splats, first + 1);
    vec4 z = element(splats, first + 2);
    center = vec3(x.w, y.w, z.w);
    jacobian = mat3(x.xyz, y.xyz, z.xyz);
  }
  else
  {
    center = element(splats, splat).xyz;
  }
  centerVC = (modelToVC * vec4(center, 1.0)).xyz;
  jacobianVC = mat3(modelToVC) * jacobian;
}

// The depth, times w, that the depth test sees of a splat whose reach ends at these z in VC: its near end must lie in front of opaque
// geometry, and where surfaces are peeled its far end behind the near end of a range. The near and the far plane cut nothing.
float testedDepth(float nearZ, float farZ, float w)
{
  const float margin = 2.0e-5; // more than a rasterizer errs in depth
  float z = testsFarEnds ? farZ : nearZ;
  float scale = VCToDC[2][3] * z + VCToDC[3][3];
  float depth = (VCToDC[2][2] * z + VCToDC[3][2]) / scale;
  return w * (testsFarEnds ? (scale > 0.0 ? clamp(depth + margin, -1.0, 1.0) : 1.0) : (scale > 0.0 ? clamp(depth - margin, -1.0, 1.0) : -1.0));
}

// How far a kernel reaches from its centre, along z.
float reachAlongZ(mat3 J, float radius)
{
  return radius * length(vec3(J[0].z, J[1].z, J[2].z));
}

bool outsideSlice(vec3 center, mat3 J, float radius)
{
  float reach = reachAlongZ(J, radius);
  return peeled && (center.z - reach > sliceZ.x || center.z + reach < sliceZ.y);
}
