// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Contour surfaces in hexahedra, of the coloured array.
// Constants: contourLighting, smoothContourNormals.

const bool contoursInCells = useContours && !useCellScalars;

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

vec2 rangeOfRing()
{
  return vec2(lesser(lesser(walkA.w, walkB.w), lesser(walkC.w, walkD.w)), greater(greater(walkA.w, walkB.w), greater(walkC.w, walkD.w)));
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
    vec3 seen = changes[0].w * cross(up, on) + changes[1].w * cross(on, right) + changes[2].w * cross(right, up);
    gradient = seen.x * across1 + seen.y * across2 + seen.z * along;
  }
  return gradient;
}

// What the ring is before the ray crosses the cell, and after: the layers at the ends of its way.
void findLayersOfCell(vec2 ringBefore, float front, float back)
{
  if (crossesContours())
  {
    enterLayersOfCell(layerInRing(front, ringBefore), layerInRing(back, rangeOfRing()));
  }
  else
  {
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
    light += (1.0 - light.a) * contourSurface(contour, front.y, normal, (MCVCMatrix * vec4(origin + front.x * along, 1.0)).xyz);
  }
  passContour(contour);
}
