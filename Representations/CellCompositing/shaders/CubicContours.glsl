// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces of a trilinear field along a ray, between the parts of the medium before and behind them.
//
// Along a ray through a cell the field is a polynomial of third degree. It is cut where it turns back, so that a value lies at most once
// between two cuts, at a root. The ray knows the layer that it is in, the number of values at or below the scalar, from one cell to the
// next: a surface in a face is crossed once, whatever rounding does to the scalar there.
// Constant: useContours. Uses pointAtCorner(corner): the point at a corner of the cell, 0 or 1 along each axis.
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

// The cell that is being added piece by piece: where its field turns back, how far it is added, and the layer in which the ray leaves it.
bool inCell = false;
vec2 turns = vec2(1.0);
float partOfCell = 0.0;
int lastLayer = 0;

// Into a cell, at whose ends the ray is in these layers; the first one unless it is known from the cell before.
void enterLayersOfCell(int first, int last)
{
  turns = turnsOfCubic(contourField.cubic);
  lastLayer = last;
  enterContourLayer(layerIsKnown ? contourLayerOfRay : first);
  layerIsKnown = true;
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

// Where the next of the pieces of the cell ends.
float endOfPiece(float pieces)
{
  float to = min((floor(partOfCell * pieces + 1.0e-3) + 1.0) / pieces, 1.0);
  return min(to, turns.x > partOfCell ? turns.x : turns.y > partOfCell ? turns.y : 1.0);
}

// The number of the contour whose surface lies on the way to the end of the piece, which ends there then; otherwise -1.
int contourInPiece(inout float to)
{
  float scalar = fieldAt(contourField, to);
  bool atEnd = to >= 1.0;
  bool up = atEnd ? lastLayer > contourLayerOfRay : scalar > layerReach.y + contourRounding;
  bool down = atEnd ? lastLayer < contourLayerOfRay : scalar < layerReach.x - contourRounding;
  int contour = up ? contourLayerOfRay : down ? contourLayerOfRay - 1 : -1;
  to = contour < 0 ? to : placeOfValue(up ? layerReach.y : layerReach.x, partOfCell, to);
  return contour;
}

void passContour(int contour)
{
  enterContourLayer(contour < contourLayerOfRay ? contourLayerOfRay - 1 : contourLayerOfRay + 1);
}

// The gradient at a place in the cell, in model coordinates, from those at its points.
vec3 smoothGradient(vec3 p)
{
  vec3 sum = vec3(0.0);
  for (int number = 0; number < 8; ++number)
  {
    ivec3 corner = ivec3(number & 1, (number >> 1) & 1, number >> 2);
    vec3 w = mix(1.0 - p, p, vec3(corner));
    sum += w.x * w.y * w.z * element(contourGradients, pointAtCorner(corner)).xyz;
  }
  return sum;
}
