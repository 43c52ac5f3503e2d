// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeneratingPolygon.h"

#include "vtkMath.h"

#include <cmath>

namespace nephoscope
{
PolygonMesh TriangulateRegularPolygon(const RegularPolygon& polygon, double)
{
  double normal[3] = { polygon.Normal[0], polygon.Normal[1], polygon.Normal[2] };
  double u[3], v[3];
  vtkMath::Normalize(normal);
  vtkMath::Perpendiculars(normal, u, v, 0.0);
  PolygonMesh mesh;
  mesh.Points.push_back(polygon.Center);
  for (int i = 0; i < polygon.Sides; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / polygon.Sides;
    Vector3 corner;
    for (std::size_t c = 0; c < 3; ++c)
    {
      corner[c] =
        polygon.Center[c] + polygon.Radius * (std::cos(angle) * u[c] + std::sin(angle) * v[c]);
    }
    mesh.Points.push_back(corner);
    mesh.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % polygon.Sides });
  }
  return mesh;
}
}
