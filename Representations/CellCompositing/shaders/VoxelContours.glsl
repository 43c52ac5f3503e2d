// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces in an evenly spaced grid.
// Constants: contourLighting, contourOfColor, smoothContourNormals.
uniform FloatArray contourSquares; // where contours are of another array than colour; above `missing` where that has no value
const float missing = 1.0e38;

int pointAtCorner(ivec3 corner)
{
  ivec3 c = ivec3(cellAdded) + corner;
  return c.x + c.y * stride.y + c.z * stride.z;
}

//NEPHOSCOPE::CubicContours

vec4 contourSquare(int first)
{
  return contourOfColor ? element(squares, first) : element(contourSquares, first);
}

// The layer of a scalar where the ray passes a face of the cell, or an edge or a vertex. It lies between the scalars of the vertices there;
// those are the same in both cells, so that rounding does not count.
int layerInFace(float scalar, vec3 axes, vec3 side)
{
  bvec3 atLow = greaterThan(axes, side), atHigh = greaterThan(axes * side, vec3(0.5));
  vec4 a = atHigh.x ? cellSquares[1] : cellSquares[0], b = atLow.x ? cellSquares[0] : cellSquares[1];
  a = atLow.y ? a.xxzz : atHigh.y ? a.yyww : a;
  b = atLow.y ? b.xxzz : atHigh.y ? b.yyww : b;
  a = atLow.z ? a.xyxy : atHigh.z ? a.zwzw : a;
  b = atLow.z ? b.xyxy : atHigh.z ? b.zwzw : b;
  vec2 range = rangeOf(a, b);
  return contourLayer(clamp(scalar, range.x, range.y));
}

vec3 gradientOfSquares(vec4 a, vec4 b, vec3 p)
{
  vec4 x = b - a, s = mix(a, b, p.x);
  vec2 up = mix(s.xz, s.yw, p.y);
  return vec3(mix(mix(x.x, x.y, p.y), mix(x.z, x.w, p.y), p.z), mix(s.y - s.x, s.w - s.z, p.z), up.y - up.x);
}

// In model coordinates; the sign and the length do not matter.
vec3 contourNormal(float way)
{
  vec3 p = clamp(rayStart + way * raySlope - cellAdded, 0.0, 1.0);
  int first = pointAtCorner(ivec3(0));
  vec3 gradient = vec3(0.0);
  if (smoothContourNormals)
  {
    gradient = smoothGradient(p);
  }
  if (gradient == vec3(0.0))
  {
    gradient = gradientOfSquares(contourSquare(first), contourSquare(first + 1), p) * mat3(toNumbers);
  }
  return gradient;
}

vec3 pieceFront = vec3(0.0);

// The axes across which the ray entered and leaves the cell are 1, the others 0.
void enterCell(vec3 entered, vec3 leaves)
{
  inCell = true;
  partOfCell = 0.0;
  pieceFront = cubicPlace(0.0);
  bool hasValues = contourField.range.y < missing;
  contourField = hasValues ? contourField : levelField(layerReach.x); // crosses nothing
  int first = layerInFace(fieldAt(contourField, 0.0), entered, 1.0 - forward);
  int last = layerInFace(fieldAt(contourField, 1.0), leaves, forward);
  layerIsKnown = layerIsKnown && hasValues;
  enterLayersOfCell(hasValues ? first : contourLayerOfRay, hasValues ? last : contourLayerOfRay);
  layerIsKnown = hasValues;
}

// The pieces of the cell that are left, or those up to the next surface: the number of its contour; otherwise -1.
int addPiecesToSurface()
{
  int contour = -1;
  while (inCell && contour < 0)
  {
    float to = endOfPiece(useCellScalars ? 1.0 : numberOfPieces);
    contour = contourInPiece(to);
    vec3 back = cubicPlace(to);
    places.xy = vec2(pieceFront.x, back.x);
    scalars.xy = vec2(pieceFront.y, back.y);
    opacityScalarsHere.xy = vec2(pieceFront.z, back.z);
    addFirstPiece();
    pieceFront = back;
    partOfCell = to;
    inCell = !isOpaque() && (contour >= 0 || to < 1.0);
  }
  return contour;
}

void addSurface(int contour)
{
  vec3 normal = contourLighting ? contourNormal(pieceFront.x) : vec3(0.0);
  closeSlices(light, pieceFront.x);
  light += (1.0 - light.a) * contourSurface(contour, pieceFront.y, normal, (MCVCMatrix * vec4(origin + pieceFront.x * along, 1.0)).xyz);
  passContour(contour);
}
