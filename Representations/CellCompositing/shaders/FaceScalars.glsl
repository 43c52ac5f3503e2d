// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars where the pixel's ray crosses a face, the same number in both tetrahedra that share the face: its vertices are taken in the
// order of their numbers, and the ray from the pixel alone. A narrow spike of a transfer function, or a contour value, that the
// scalar of a face comes close to then lies on the same side for both, and nothing of it is lost or counted twice.
uniform IntegerArray tetrahedra;
uniform FloatArray points;
uniform vec4 eyeMC;     // w = 1; or the direction towards the eye, w = 0, in a parallel projection
uniform mat3 pixelToRay; // (pixel, 1) to the direction of the ray, or in a parallel projection to a point of it; model coordinates

// Colour, opacity and contour scalar on the face opposite a vertex; `otherwise` where the ray lies in the face's plane.
vec3 faceScalars(int tetrahedron, int opposite, vec4 colorScalars, vec4 secondScalars, vec4 thirdScalars, vec3 otherwise)
{
  ivec4 ids = element(tetrahedra, tetrahedron);
  ivec3 f = ivec3(opposite == 0 ? 1 : 0, opposite <= 1 ? 2 : 1, opposite <= 2 ? 3 : 2);
  f = ids[f.x] > ids[f.y] ? f.yxz : f;
  f = ids[f.y] > ids[f.z] ? f.xzy : f;
  f = ids[f.x] > ids[f.y] ? f.yxz : f;
  vec3 a = element(points, ids[f.x]).xyz;
  vec3 ab = element(points, ids[f.y]).xyz - a;
  vec3 ac = element(points, ids[f.z]).xyz - a;

  vec3 ray = pixelToRay * vec3(gl_FragCoord.xy, 1.0);
  vec3 direction = normalize(eyeMC.w > 0.0 ? ray : eyeMC.xyz);
  vec3 start = (eyeMC.w > 0.0 ? eyeMC.xyz : ray) - a;
  start -= dot(start, direction) * direction; // the ray's point nearest to a, relative to a
  vec3 p = cross(direction, ac);
  float determinant = dot(ab, p);
  vec2 weights = vec2(dot(start, p), dot(direction, cross(start, ab))) / determinant;
  if (!(all(lessThan(abs(weights - 0.5), vec2(1.0)))))
  {
    return otherwise;
  }
  vec3 atA = vec3(colorScalars[f.x], secondScalars[f.x], thirdScalars[f.x]);
  vec3 atB = vec3(colorScalars[f.y], secondScalars[f.y], thirdScalars[f.y]);
  vec3 atC = vec3(colorScalars[f.z], secondScalars[f.z], thirdScalars[f.z]);
  return atA + weights.x * (atB - atA) + weights.y * (atC - atA);
}
