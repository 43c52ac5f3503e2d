// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a mesh that one of several ranks writes: a run of tetrahedra in the order in which
// they were made, equally many for every rank but for one. That order goes layer by layer, so a
// share is a stretch of the volume from one layer to another, and what two shares have in common is
// one layer of points. Shares of columns of triangles would run side by side through the whole
// volume: more points in common, and long boxes that overlap when the ranks are sorted for drawing.
// Plain C++17.
#ifndef nephoscope_MeshSlice_h
#define nephoscope_MeshSlice_h

#include "SmokeMesh.h"

namespace nephoscope
{
// A part of `values`, from `first` up to `last`.
template <typename Value>
std::vector<Value> Stretch(const std::vector<Value>& values, std::size_t first, std::size_t last)
{
  return { values.begin() + static_cast<std::ptrdiff_t>(first),
    values.begin() + static_cast<std::ptrdiff_t>(last) };
}

// Share `part` of `parts`, with the points that it uses in their order.
inline SmokeMesh SliceOfMesh(const SmokeMesh& mesh, int part, int parts)
{
  const std::size_t count = mesh.Tetrahedra.size();
  const std::size_t first =
    count * static_cast<std::size_t>(part) / static_cast<std::size_t>(parts);
  const std::size_t last =
    count * static_cast<std::size_t>(part + 1) / static_cast<std::size_t>(parts);
  SmokeMesh slice;
  slice.Tetrahedra = Stretch(mesh.Tetrahedra, first, last);
  slice.EmissionSteps = Stretch(mesh.EmissionSteps, first, last);
  slice.Ages = Stretch(mesh.Ages, first, last);
  slice.Densities = Stretch(mesh.Densities, first, last);

  std::vector<PointId> ids(mesh.Points.size(), -1); // in the slice; -1: not used
  for (const TetrahedronPoints& tetrahedron : slice.Tetrahedra)
  {
    for (const PointId p : tetrahedron)
    {
      ids[static_cast<std::size_t>(p)] = 0;
    }
  }
  for (std::size_t p = 0; p < ids.size(); ++p)
  {
    if (ids[p] == 0)
    {
      ids[p] = static_cast<PointId>(slice.Points.size());
      slice.Points.push_back(mesh.Points[p]);
      slice.PointAges.push_back(mesh.PointAges[p]);
      slice.PointDensities.push_back(mesh.PointDensities[p]);
      slice.Hints.push_back(mesh.Hints[p]);
    }
  }
  for (TetrahedronPoints& tetrahedron : slice.Tetrahedra)
  {
    for (PointId& p : tetrahedron)
    {
      p = ids[static_cast<std::size_t>(p)];
    }
  }
  return slice;
}
}

#endif
