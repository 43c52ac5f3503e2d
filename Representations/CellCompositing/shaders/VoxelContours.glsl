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
CubicField contourField = CubicField(vec4(0.0), vec2(0.0));
vec2 layerReach = vec2(0.0); // scalars of the layer: from, and below
int contourLayerOfRay = 0;
bool layerIsKnown = false;

bool crossesContours()
{
  return useContours && !(contourField.range.x >= layerReach.x && contourField.range.y < layerReach.y);
}

void keepLayer(int layer)
{
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
  ivec3 low = ivec3(cell + axes * side);
  bvec3 extends = lessThan(axes, vec3(0.5));
  int first = low.x + low.y * stride.y + low.z * stride.z;
  vec4 a = contourSquare(first), b = contourSquare(first + (extends.x ? 1 : 0));
  if (!extends.y)
  {
    a = a.xxzz;
    b = b.xxzz;
  }
  if (!extends.z)
  {
    a = a.xyxy;
    b = b.xyxy;
  }
  vec2 range = rangeOf(a, b);
  return contourLayer(clamp(scalar, range.x, range.y));
}

// The layer at a place amid the cell, if the field leaves the present one by more than it is rounded.
int layerAt(float place, int layer)
{
  const float rounding = 1.0e-6;
  float scalar = fieldAt(contourField, place);
  int there = contourLayer(scalar);
  float value = element(contours, 2 * max(there > layer ? layer : layer - 1, 0)).r;
  return there == layer || abs(scalar - value) > rounding ? there : layer;
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
  vec3 p = clamp(rayStart + way * raySlope - cell, 0.0, 1.0);
  ivec3 c = ivec3(cell);
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

void addMedium(vec3 front, vec3 back)
{
  if (back.x > front.x)
  {
    places.xy = vec2(front.x, back.x);
    scalars.xy = vec2(front.y, back.y);
    opacityScalarsHere.xy = vec2(front.z, back.z);
    addFirstPiece();
  }
}

// The cell whose fields are at hand. The axes across which the ray entered and leaves the cell are 1, the others 0.
void addCellWithContours(vec3 entered, vec3 leaves)
{
  int lowest = contourLayer(contourField.range.x);
  if (contourField.range.y > missing || lowest == contourLayer(contourField.range.y))
  {
    layerIsKnown = false;
    keepLayer(lowest);
    addPieces();
    return;
  }
  int layer = layerIsKnown ? contourLayerOfRay : layerInFace(fieldAt(contourField, 0.0), entered, 1.0 - forward);
  contourLayerOfRay = layerInFace(fieldAt(contourField, 1.0), leaves, forward);
  layerIsKnown = true;
  keepLayer(contourLayerOfRay);
  vec2 turns = turnsOfCubic(contourField.cubic);
  float pieces = useCellScalars ? 1.0 : numberOfPieces;
  float from = 0.0;
  vec3 front = cubicPlace(from);
  int most = 3 + int(mostPieces) + 3 * numberOfContours;
  for (int i = 0; i < most; ++i)
  {
    float to = min((floor(from * pieces + 1.0e-3) + 1.0) / pieces, 1.0);
    to = min(to, turns.x > from ? turns.x : turns.y > from ? turns.y : 1.0);
    int there = to < 1.0 ? layerAt(to, layer) : contourLayerOfRay;
    int contour = there > layer ? layer : layer - 1;
    if (there != layer)
    {
      to = crossingOfCubic(contourField.cubic, element(contours, 2 * contour).r, from, to);
    }
    vec3 back = cubicPlace(to);
    addMedium(front, back);
    if (there != layer)
    {
      addSurface(contour, back);
      layer += there > layer ? 1 : -1;
    }
    else if (to >= 1.0)
    {
      break;
    }
    if (isOpaque())
    {
      break;
    }
    front = back;
    from = to;
  }
}
