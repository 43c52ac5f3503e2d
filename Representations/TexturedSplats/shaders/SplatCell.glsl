// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a splat is and which shape it has, in view coordinates.
uniform samplerBuffer splats; // (centre, -), or the columns of J with the centre in the fourth components
uniform mat4 modelToVC;
uniform mat3 sharedJacobian;

void readSplat(int splat, out vec3 centerVC, out mat3 jacobianVC)
{
  vec3 center;
  mat3 jacobian = sharedJacobian;
  if (jacobianPerSplat)
  {
    vec4 x = texelFetch(splats, 3 * splat);
    vec4 y = texelFetch(splats, 3 * splat + 1);
    vec4 z = texelFetch(splats, 3 * splat + 2);
    center = vec3(x.w, y.w, z.w);
    jacobian = mat3(x.xyz, y.xyz, z.xyz);
  }
  else
  {
    center = texelFetch(splats, splat).xyz;
  }
  centerVC = (modelToVC * vec4(center, 1.0)).xyz;
  jacobianVC = mat3(modelToVC) * jacobian;
}
