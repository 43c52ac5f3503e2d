// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The polygon that smoke comes from: a regular one, or those of a dataset, as triangles of a wanted
// size.
#ifndef nephoscope_GeneratingPolygon_h
#define nephoscope_GeneratingPolygon_h

#include "PolygonShape.h"

#include <string>

class vtkPolyData;

namespace nephoscope
{
struct RegularPolygon
{
  Vector3 Center{};
  double Radius = 1.0; // to the corners
  int Sides = 6;
  Vector3 Normal{ { 0.0, 0.0, 1.0 } }; // of any length
};

// Well-shaped triangles with edges that are not longer; 0: a quarter of the diameter. The mesh is
// empty where there would be more than a million triangles, and where the radius or the normal is
// zero or not finite.
PolygonMesh TriangulateRegularPolygon(const RegularPolygon& polygon, double maximumEdgeLength);

// The polygons (and triangles, quadrilaterals and strips) of a dataset; 0: a quarter of their
// longest extent. They may be concave, have points in a row on a side, or turn either way; points
// in the same place count as one. A polygon is refused if a point is further from its mean plane
// than 5 % of its longest extent, if it crosses itself, has no area or points that are not finite:
// false, and a sentence with the remedy in `problem`. The order of the points makes no difference.
bool TriangulatePolygons(
  vtkPolyData* polygons, double maximumEdgeLength, PolygonMesh& mesh, std::string& problem);
}

#endif
