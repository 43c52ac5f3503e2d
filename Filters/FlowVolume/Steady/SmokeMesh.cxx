// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeMesh.h"

#include "SmokeGeometry.h"

namespace nephoscope
{
void CompactPoints(SmokeMesh& mesh)
{
  std::vector<PointId> places(mesh.Points.size(), -1);
  for (const TetrahedronPoints& tetrahedron : mesh.Tetrahedra)
  {
    for (PointId point : tetrahedron)
    {
      places[static_cast<std::size_t>(point)] = 0;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] == 0)
    {
      places[i] = static_cast<PointId>(count);
      mesh.Points[count] = mesh.Points[i];
      mesh.PointAges[count] = mesh.PointAges[i];
      if (!mesh.Ends.empty())
      {
        mesh.Ends[count] = mesh.Ends[i];
      }
      mesh.Hints[count++] = mesh.Hints[i];
    }
  }
  if (count == places.size())
  {
    return;
  }
  mesh.Points.resize(count);
  mesh.PointAges.resize(count);
  mesh.Ends.resize(mesh.Ends.empty() ? 0 : count);
  mesh.Hints.resize(count);
  for (TetrahedronPoints& tetrahedron : mesh.Tetrahedra)
  {
    for (PointId& point : tetrahedron)
    {
      point = places[static_cast<std::size_t>(point)];
    }
  }
}

void ScaleDensities(SmokeMesh& mesh)
{
  std::vector<double> sums(mesh.Report.MassPerStep.size(), 0.0);
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    sums[static_cast<std::size_t>(mesh.EmissionSteps[i])] +=
      mesh.Densities[i] * VolumeOf(mesh.Tetrahedra[i], mesh.Points);
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
  {
    double& mass = mesh.Report.MassPerStep[k];
    mass = sums[k] > 0.0 ? mass : 0.0; // where every tetrahedron is too small to be written
    sums[k] = sums[k] > 0.0 ? mass / sums[k] : 1.0;
  }
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    mesh.Densities[i] *= sums[static_cast<std::size_t>(mesh.EmissionSteps[i])];
  }
}

void AverageDensities(SmokeMesh& mesh)
{
  std::vector<double> volumes(mesh.Points.size(), 0.0);
  mesh.PointDensities.assign(mesh.Points.size(), 0.0);
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const double volume = VolumeOf(mesh.Tetrahedra[i], mesh.Points);
    for (const PointId point : mesh.Tetrahedra[i])
    {
      volumes[static_cast<std::size_t>(point)] += volume;
      mesh.PointDensities[static_cast<std::size_t>(point)] += volume * mesh.Densities[i];
    }
  }
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const bool fades = !mesh.Ends.empty() && mesh.Ends[i] != 0;
    mesh.PointDensities[i] *= fades || !(volumes[i] > 0.0) ? 0.0 : 1.0 / volumes[i];
  }
}
}
