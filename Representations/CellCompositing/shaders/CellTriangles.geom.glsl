//VTK::System::Dec
// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One tetrahedron as a fan of triangles around its thick vertex (ShirleyTuchman1990; ProjectedTriangles.glsl).
//   in:  the number of the tetrahedron
//   out: what is linear on the screen inside each triangle. z is the distance from the eye along the view axis.
//        in perspective: 1 / z_front, 1 / z_front - 1 / z_back, (x, y) of the ray at z = 1, attributes divided by z;
//        in parallel:    z_front, z_back - z_front, attributes
// Vertices leave with w = 1, so that all outputs are interpolated linearly on the screen. A tetrahedron that reaches
// the plane of the eye has no such projection and is left out (TrianglePass.h counts them).
//NEPHOSCOPE::Arrays
//NEPHOSCOPE::Constants
//NEPHOSCOPE::TetrahedronInput
//NEPHOSCOPE::ProjectedTriangles
//NEPHOSCOPE::OpticalSegment
//NEPHOSCOPE::TransferFunction
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

uniform mat4 VCDCMatrix;
uniform vec4 eyeVC;            // (position, 1) or (direction towards the eye, 0)
uniform float extinctionScale; // extinction per world length at opacity 1
uniform float smallestEyeDepth; // nearer vertices are not projected

flat in int tetrahedronVSOutput[];
out vec2 depthGSOutput;
out vec2 slopeGSOutput;
out vec4 frontGSOutput; // linearOpacity: colour and opacity of the segment; else colour and extinction on the front
out vec4 backGSOutput;  // and on the back

struct FanVertex
{
  vec4 position;
  vec2 depth;
  vec2 slope;
  vec4 front;
  vec4 back;
};

float eyeDepth(vec4 pointVC)
{
  return eyeVC.w * eyeVC.z - pointVC.z;
}

// Colour and extinction.
vec4 classify(vec2 s)
{
  vec4 value = evaluate(findIntervals(s), s);
  return vec4(value.rgb, value.a * extinctionScale);
}

FanVertex makeVertex(vec4 frontVC, float zFront, float zBack, float zDifference, vec4 front, vec4 back)
{
  bool perspective = eyeVC.w > 0.0;
  FanVertex v;
  vec4 clip = VCDCMatrix * frontVC;
  v.position = vec4(clip.xyz / clip.w, 1.0);
  v.depth = perspective ? vec2(1.0 / zFront, zDifference / (zFront * zBack)) : vec2(zFront, zDifference);
  v.slope = perspective ? (frontVC.xy - eyeVC.xy) / zFront : vec2(0.0);
  v.front = perspective && !linearOpacity ? front / zFront : front;
  v.back = perspective && !linearOpacity ? back / zBack : back;
  return v;
}

FanVertex silhouetteVertex(int i)
{
  float z = eyeDepth(positionVC[i]);
  vec4 value = classify(vec2(scalars[i], secondScalars[i]));
  return makeVertex(positionVC[i], z, z, 0.0, linearOpacity ? vec4(value.rgb, 0.0) : value, value);
}

vec2 interpolateScalars(vec4 barycentric)
{
  return vec2(scalars.w + dot(barycentric.xyz, scalars.xyz - scalars.w),
    secondScalars.w + dot(barycentric.xyz, secondScalars.xyz - secondScalars.w));
}

FanVertex thickVertex(TetrahedronProjection p)
{
  mat4 vertices = mat4(positionVC[0], positionVC[1], positionVC[2], positionVC[3]);
  vec4 frontVC = vertices * p.front, backVC = vertices * p.back;
  vec3 towardsEye = eyeVC.xyz - eyeVC.w * backVC.xyz;
  vec4 front = classify(interpolateScalars(p.front)), back = classify(interpolateScalars(p.back));
  if (linearOpacity)
  {
    float depth = p.parameter * length(towardsEye) * 0.5 * (front.a + back.a);
    front = vec4(0.5 * (front.rgb + back.rgb), averageSegmentWeights(depth, depth).x * 2.0);
  }
  return makeVertex(frontVC, eyeDepth(frontVC), eyeDepth(backVC), p.parameter * towardsEye.z, front, back);
}

void emitVertex(FanVertex v)
{
  depthGSOutput = v.depth;
  slopeGSOutput = v.slope;
  frontGSOutput = v.front;
  backGSOutput = v.back;
  gl_Position = v.position;
  EmitVertex();
}

void main()
{
  if (!readTetrahedron(tetrahedronVSOutput[0]))
  {
    return;
  }
  if (useLayers && !contourLayers)
  {
    selectLayer(layer);
  }
  FanVertex corners[4];
  for (int i = 0; i < 4; ++i)
  {
    if (eyeVC.w > 0.0 && !(eyeDepth(positionVC[i]) > smallestEyeDepth))
    {
      return;
    }
    corners[i] = silhouetteVertex(i);
  }
  TetrahedronProjection projection = projectTetrahedron(eyeBarycentric);
  if (projection.parameter == 0.0)
  {
    return; // seen edge-on
  }
  FanVertex thick = thickVertex(projection);
  for (int a = 0; a < 3; ++a)
  {
    for (int b = a + 1; b < 4; ++b)
    {
      if (isFanEdge(projection, a, b))
      {
        emitVertex(thick);
        emitVertex(corners[a]);
        emitVertex(corners[b]);
        EndPrimitive();
      }
    }
  }
}
