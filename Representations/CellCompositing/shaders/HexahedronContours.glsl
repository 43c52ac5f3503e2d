// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces in hexahedra.
// Constants: contourLighting, contourOfColor, smoothContourNormals.
uniform FloatArray contourScalars; // where contours are of another array than colour

const bool contoursInCells = useContours && !(useCellScalars && contourOfColor);

// What is contoured at the vertices of the cell: A to D, and E to H.
vec4 contourNear = vec4(0.0), contourFar = vec4(0.0);
bool hasContourValues = true;

// Before the ring goes on. Those of the coloured array are at hand.
void seeContours()
{
  if (contoursInCells && !contourOfColor)
  {
    contourNear = valuesOfRing(contourScalars, 0);
    contourFar = valuesOfRing(contourScalars, 1);
    hasContourValues = !isnan(dot(contourNear + contourFar, vec4(1.0)));
  }
  else if (contoursInCells)
  {
    contourNear = vec4(walkA.w, walkB.w, walkC.w, walkD.w);
    contourFar = vec4(walkE.w, walkF.w, walkG.w, walkH.w);
  }
}

vec2 rangeOfContours()
{
  return rangeOfEight(contourNear, contourFar);
}

// In the face through which the ray leaves the cell.
vec2 rangeOfContoursBehind(int exit)
{
  vec4 n = contourNear, f = contourFar;
  return rangeOfFour(exit == exitAhead ? f : exit == exitAB ? vec4(n.xy, f.xy) : exit == exitBC ? vec4(n.yz, f.yz)
    : exit == exitCD ? vec4(n.zw, f.zw) : vec4(n.wx, f.wx));
}

// At a place in the cell: what is contoured, and what a step along AB, AD and AE changes.
vec4 contouredAt(vec3 p)
{
  return fieldInCell(contourNear, contourFar, p);
}

float contouredBeside(vec3 p)
{
  return fieldBeside(contourNear, contourFar, p);
}

int pointAtCorner(ivec3 corner)
{
  return pointOfRing(corner.x, corner.y, corner.z);
}

//NEPHOSCOPE::CubicContours

// The layer of a scalar where the ray passes the ring. It lies between the scalars of the ring, which both cells have in common.
int layerInRing(float scalar, vec2 range)
{
  return contourLayer(clamp(scalar, range.x, range.y));
}

// Where the ray enters and leaves the cell, in fractions of the ways along AB, AD and AE of the ring through which it enters.
vec3 placeEntered = vec3(0.0), placeLeft = vec3(0.0);

// In model coordinates; the sign and the length do not matter. The ring must still be that of the cell.
vec3 contourNormal()
{
  vec3 p = clamp(mix(placeEntered, placeLeft, partOfCell), 0.0, 1.0);
  vec3 gradient = vec3(0.0);
  if (smoothContourNormals)
  {
    gradient = smoothGradient(p);
  }
  if (gradient == vec3(0.0))
  {
    mat3x4 changes = changesInCell(p);
    vec3 right = changes[0].xyz, up = changes[1].xyz, on = changes[2].xyz;
    vec3 change = contouredAt(p).yzw;
    vec3 seen = change.x * cross(up, on) + change.y * cross(on, right) + change.z * cross(right, up);
    gradient = seen.x * across1 + seen.y * across2 + seen.z * along;
  }
  return gradient;
}

// The layers at the ends of the way through the cell. `values`: what is contoured at its ends and its thirds.
void findLayersOfCell(vec4 values, int exit)
{
  vec2 ofRay = rangeOfFour(values);
  vec4 cubic = cubicThrough(values);
  float beside = bendOfCubic(cubic) / 9.0; // of the chords between the values
  contourField = CubicField(cubic, rangeOfContours(), vec2(ofRay.x - beside, ofRay.y + beside));
  if (hasContourValues && crossesContours())
  {
    enterLayersOfCell(layerInRing(values.x, rangeOfFour(contourNear)), layerInRing(values.w, rangeOfContoursBehind(exit)));
  }
  else
  {
    contourField = levelField(layerReach.x);
    turns = vec2(1.0);
    lastLayer = contourLayerOfRay;
    layerIsKnown = false;
  }
}

void addSurface(int contour, vec2 front, vec2 range)
{
  if (front.x >= range.x && front.x < range.y)
  {
    vec3 normal = contourLighting ? contourNormal() : vec3(0.0);
    closeSlices(light, front.x);
    light += (1.0 - light.a) * contourSurface(contour, front.y, normal, (MCVCMatrix * vec4(origin + front.x * along, 1.0)).xyz);
  }
  passContour(contour);
}
