// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that a ray passes: contours inside a tetrahedron, and polygons in its faces. Both between the distances `range`.
// The surface of this contour where the walk is.
void addSurface(int contour, vec2 range)
{
  float z = mix(segmentFront.x, segmentBack.x, passedPlace);
  if (z >= range.x && z < range.y)
  {
    vec4 weights = mix(frontWeights, vec4(faceWeights(), 0.0), passedPlace);
    vec2 scalars = mix(segmentFront.yz, segmentBack.yz, passedPlace);
    scalars.x = useCellScalars ? element(cellScalars, cellNumber()).r : scalars.x;
    ivec3 table = transferTable;
    vec3 normal = contourLighting ? contourNormal(ivec4(pointOf(face.x), pointOf(face.y), pointOf(face.z), pointOf(left)), weights) : vec3(0.0);
    vec4 surface = contourSurface(contour, scalars.x, normal, (MCVCMatrix * vec4(origin + z * along, 1.0)).xyz);
    transferTable = table;
    closeSlices(light, z);
    light += (1.0 - light.a) * surface;
  }
}

// The polygon in the face that the ray is passing, across from this vertex.
void addPolygon(int opposite, vec2 range)
{
  vec4 pass = passFace();
  if (pass.x >= range.x && pass.x < range.y)
  {
    vec3 weights = faceWeights();
    ivec3 v = face;
    weights = v.x > v.y ? weights.yxz : weights; // of ascending vertices
    v = v.x > v.y ? v.yxz : v;
    weights = v.y > v.z ? weights.xzy : weights;
    v = v.y > v.z ? v.xzy : v;
    weights = v.x > v.y ? weights.yxz : weights;
    ivec3 table = transferTable;
    closeSlices(light, pass.x);
    light += (1.0 - light.a) *
      polygonSurface(polygonInFace(opposite), weights, pass.y, (MCVCMatrix * vec4(origin + pass.x * along, 1.0)).xyz);
    transferTable = table;
  }
}
