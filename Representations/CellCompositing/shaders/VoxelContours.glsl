// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces of the trilinear field of an evenly spaced grid along a ray, between the parts of the medium before and behind them.
//
// Along a ray through a cell the field is a polynomial of third degree. It is cut where it turns back, so that a value lies at most once
// between two cuts, at a root. The ray knows the layer that it is in, the number of values at or below the scalar, from one cell to the
// next: a surface in a face is crossed once, whatever rounding does to the scalar there.
// Constants: useContours, contourLighting, contourOfColor, smoothContourNormals.
uniform FloatArray contourSquares; // where contours are of another array than colour; above `missing` where that has no value
const float missing = 1.0e38;
CubicField contourField = noField;
vec2 layerReach = vec2(0.0); // scalars of the layer: from, and below
int contourLayerOfRay = 0;
bool layerIsKnown = false;

const float contourRounding = 1.0e-6; // amid a cell a surface is not crossed for less

// The ray may leave its layer in the present cell.
bool crossesContours()
{
  return useContours &&
    !(contourField.rangeOfRay.x >= layerReach.x + contourRounding && contourField.rangeOfRay.y < layerReach.y - contourRounding);
}

void enterContourLayer(int layer)
{
  contourLayerOfRay = layer;
  layerReach.x = layer == 0 ? -3.0e38 : element(contours, 2 * (layer - 1)).r;
  layerReach.y = layer == numberOfContours ? 3.0e38 : element(contours, 2 * layer).r;
}

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

vec3 smoothGradient(int first, vec3 p)
{
  vec3 sum = vec3(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    ivec3 c = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    vec3 w = mix(1.0 - p, p, vec3(c));
    sum += w.x * w.y * w.z * element(contourGradients, first + c.x + c.y * stride.y + c.z * stride.z).xyz;
  }
  return sum;
}

// In model coordinates; the sign and the length do not matter.
vec3 contourNormal(float way)
{
  vec3 p = clamp(rayStart + way * raySlope - cellAdded, 0.0, 1.0);
  ivec3 c = ivec3(cellAdded);
  int first = c.x + c.y * stride.y + c.z * stride.z;
  vec3 gradient = vec3(0.0);
  if (smoothContourNormals)
  {
    gradient = smoothGradient(first, p);
  }
  if (gradient == vec3(0.0))
  {
    gradient = gradientOfSquares(contourSquare(first), contourSquare(first + 1), p) * mat3(toNumbers);
  }
  return gradient;
}

void addSurface(int contour, vec3 place)
{
  vec3 normal = contourLighting ? contourNormal(place.x) : vec3(0.0);
  light += (1.0 - light.a) * contourSurface(contour, place.y, normal, (MCVCMatrix * vec4(origin + place.x * along, 1.0)).xyz);
}

// The cell that is being added piece by piece: where its field turns back, how far it is added, and the layer in which the ray leaves it.
bool inCell = false;
vec2 turns = vec2(0.0);
float partOfCell = 0.0;
vec3 pieceFront = vec3(0.0);
int lastLayer = 0;

// The axes across which the ray entered and leaves the cell are 1, the others 0.
void enterCell(vec3 entered, vec3 leaves)
{
  inCell = true;
  turns = turnsOfCubic(contourField.cubic);
  partOfCell = 0.0;
  pieceFront = cubicPlace(0.0);
  int first = layerInFace(fieldAt(contourField, 0.0), entered, 1.0 - forward);
  lastLayer = layerInFace(fieldAt(contourField, 1.0), leaves, forward);
  bool hasSurfaces = contourField.range.y < missing;
  lastLayer = hasSurfaces ? lastLayer : first;
  enterContourLayer(layerIsKnown && hasSurfaces ? contourLayerOfRay : first);
  layerIsKnown = hasSurfaces;
}

// Where the field passes a value between two places: along the chord, and from there by Newton.
float placeOfValue(float value, float from, float to)
{
  vec4 cubic = contourField.cubic;
  float front = cubicAt(cubic, from), change = cubicAt(cubic, to) - front;
  float place = from + (to - from) * (change == 0.0 ? 1.0 : clamp((value - front) / change, 0.0, 1.0));
  for (int i = 0; i < 2; ++i)
  {
    float slope = cubic.y + place * (2.0 * cubic.z + place * 3.0 * cubic.w);
    float away = value - cubicAt(cubic, place);
    place = clamp(slope == 0.0 ? place : place + away / slope, from, to);
  }
  return place;
}

// The pieces of the cell that are left, or those up to the next surface: the number of its contour; otherwise -1.
int addPiecesToSurface()
{
  float pieces = useCellScalars ? 1.0 : numberOfPieces;
  int contour = -1;
  while (inCell && contour < 0)
  {
    float to = min((floor(partOfCell * pieces + 1.0e-3) + 1.0) / pieces, 1.0);
    to = min(to, turns.x > partOfCell ? turns.x : turns.y > partOfCell ? turns.y : 1.0);
    float scalar = fieldAt(contourField, to);
    bool atEnd = to >= 1.0;
    bool up = atEnd ? lastLayer > contourLayerOfRay : scalar > layerReach.y + contourRounding;
    bool down = atEnd ? lastLayer < contourLayerOfRay : scalar < layerReach.x - contourRounding;
    contour = up ? contourLayerOfRay : down ? contourLayerOfRay - 1 : -1;
    to = contour < 0 ? to : placeOfValue(up ? layerReach.y : layerReach.x, partOfCell, to);
    vec3 back = cubicPlace(to);
    places.xy = vec2(pieceFront.x, back.x);
    scalars.xy = vec2(pieceFront.y, back.y);
    opacityScalarsHere.xy = vec2(pieceFront.z, back.z);
    addFirstPiece();
    pieceFront = back;
    partOfCell = to;
    inCell = !isOpaque() && (contour >= 0 || !atEnd);
  }
  return contour;
}

void addSurface(int contour)
{
  vec3 normal = contourLighting ? contourNormal(pieceFront.x) : vec3(0.0);
  light += (1.0 - light.a) * contourSurface(contour, pieceFront.y, normal, (MCVCMatrix * vec4(origin + pieceFront.x * along, 1.0)).xyz);
  enterContourLayer(contour < contourLayerOfRay ? contourLayerOfRay - 1 : contourLayerOfRay + 1);
}
