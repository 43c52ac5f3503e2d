// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The polygon that smoke comes from: a regular one, or one of a dataset, as triangles of a wanted size.
#ifndef nephoscope_GeneratingPolygon_h
#define nephoscope_GeneratingPolygon_h

#include "SmokeMesh.h"

namespace nephoscope
{
struct RegularPolygon
{
  Vector3 Center{};
  double Radius = 1.0;
  int Sides = 6;
  Vector3 Normal{ { 0.0, 0.0, 1.0 } };
};

PolygonMesh TriangulateRegularPolygon(const RegularPolygon& polygon, double maximumEdgeLength);
}

#endif
