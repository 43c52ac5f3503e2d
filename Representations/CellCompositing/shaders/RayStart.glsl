// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray enters the mesh, at a boundary face or from the eye, and how it goes on from tetrahedron to tetrahedron.
void startAtVertices()
{
  if (startWalk(seen(face.x), seen(face.y), seen(face.z)))
  {
    face = face.xzy;
  }
}

// Passes the face through which the ray enters.
void startAtFace(ivec4 boundaryFace)
{
  next = enterTetrahedron(boundaryFace, face);
  startAtVertices();
}

// Goes into the next tetrahedron. False: there is none.
bool goOn()
{
  bool lost = walkIsLost;
  if (crossFace(face, left, next))
  {
    if (!hasOtherPoints || !otherPoints)
    {
      return true;
    }
    startAtVertices();
  }
  else if (hasJumps && jumpFace >= 0)
  {
    startAtFace(element(boundaryFaces, jumpFace));
  }
  else
  {
    return false;
  }
  walkIsLost = lost;
  layerIsKnown = false;
  return true;
}

// Which of the faces of the eye's tetrahedron, across from its vertices, the ray leaves through: where it is deepest inside, ahead.
float depthInside(Seen a, Seen b, Seen c, float eyeZ)
{
  startWalk(a, b, c);
  float inside = min(edgeFunction(walkA, walkB), min(edgeFunction(walkB, walkC), edgeFunction(walkC, walkA)));
  return passFace().x > eyeZ ? inside : -3.0e38;
}

void startInEyeTetrahedron()
{
  ivec4 v = ivec4(eyeVertices[0], eyeVertices[1], eyeVertices[2], eyeVertices[3]);
  float eyeZ = dot(eyeMC - origin, along);
  enterPlace(ivec4(eyePlace[0], eyePlace[1], eyePlace[2], eyePlace[3]));
  Seen p0 = seen(v.x), p1 = seen(v.y), p2 = seen(v.z), p3 = seen(v.w);
  vec4 inside = vec4(depthInside(p1, p2, p3, eyeZ), depthInside(p0, p2, p3, eyeZ), depthInside(p0, p1, p3, eyeZ),
    depthInside(p0, p1, p2, eyeZ));
  float deepest = max(max(inside.x, inside.y), max(inside.z, inside.w));
  int across = inside.x == deepest ? 0 : inside.y == deepest ? 1 : inside.z == deepest ? 2 : 3;
  left = across == 0 ? v.x : across == 1 ? v.y : across == 2 ? v.z : v.w;
  face = across == 0 ? v.yzw : across == 1 ? v.xzw : across == 2 ? v.xyw : v.xyz;
  vec4 w = eyeWeights;
  frontWeights = across == 0 ? w.yzwx : across == 1 ? w.xzwy : across == 2 ? w.xywz : w;
  if (startWalk(seen(face.x), seen(face.y), seen(face.z)))
  {
    face = face.xzy;
    frontWeights = frontWeights.xzyw;
  }
  if (useLayers && !contourLayers)
  {
    enterLayer(element(tetrahedronLayers, cellNumber()).r);
  }
  vec4 contour = vec4(contourScalar(p0), contourScalar(p1), contourScalar(p2), contourScalar(p3));
  vec2 scalars = vec2(cameraLight ? dot(w, vec4(p0.place.w, p1.place.w, p2.place.w, p3.place.w)) : eyeScalars.x, eyeScalars.y);
  startSegment(vec4(eyeZ, scalars, dot(w, contour)), passFace(), contour.x + contour.y + contour.z + contour.w);
}
