// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SteadyVolume.h"

#include "ParticleIntegrator.h"

#include <cmath>

namespace nephoscope
{
SmokeMesh BuildSteadyVolume(const VelocityField& field, const PolygonMesh& polygon,
  const FlowVolumeSettings& settings, double time, const ProgressFunction& progress)
{
  SmokeMesh mesh;
  const int steps = static_cast<int>(std::ceil(settings.Duration / settings.TimeStep - 1e-9));
  const std::size_t count = polygon.Points.size();
  std::vector<Vector3> positions = polygon.Points;
  std::vector<CellHint> hints(count);
  std::vector<unsigned char> inside(count, 1);
  ParticleIntegrator integrator(field);
  mesh.Points = positions;
  mesh.PointAges.assign(count, 0.0);
  mesh.Hints = hints;
  for (int k = 0; k < steps && progress(static_cast<double>(k) / steps); ++k)
  {
    integrator.AdvanceRungeKutta4(
      { positions.data(), hints.data(), inside.data(), count }, time, settings.TimeStep);
    const auto below = static_cast<PointId>(count) * k;
    const auto above = below + static_cast<PointId>(count);
    mesh.Points.insert(mesh.Points.end(), positions.begin(), positions.end());
    mesh.PointAges.insert(mesh.PointAges.end(), count, (k + 1) * settings.TimeStep);
    mesh.Hints.insert(mesh.Hints.end(), hints.begin(), hints.end());
    for (const auto& t : polygon.Triangles)
    {
      const auto in = [&](int i) {
        return inside[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
      };
      if (!in(0) || !in(1) || !in(2))
      {
        continue;
      }
      for (const auto& tetrahedron : PrismTetrahedra({ below + t[0], below + t[1], below + t[2],
             above + t[0], above + t[1], above + t[2] }))
      {
        mesh.Tetrahedra.push_back(tetrahedron);
        mesh.EmissionSteps.push_back(k);
        mesh.Ages.push_back((k + 0.5) * settings.TimeStep);
        mesh.Densities.push_back(1.0);
      }
    }
  }
  return mesh;
}
}
