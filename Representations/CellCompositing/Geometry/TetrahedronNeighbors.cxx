// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetrahedronNeighbors.h"

#include "BoundaryFaces.h"
#include "CellGeometry.h"
#include "VisibilityOrder.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
/** Vertex numbers of tetrahedra after coincident points with equal scalars have become one. */
class MergedVertices
{
public:
  MergedVertices(const CellGeometry& geometry, const VisibilityOrder& connected)
    : Geometry(geometry)
    , Connected(connected)
  {
  }

  std::int32_t Merged(std::int32_t point) const
  {
    const std::int32_t first = this->Connected.CanonicalPoint(point);
    const bool same = this->Geometry.Points[std::size_t(first)].Scalar == this->Geometry.Points[std::size_t(point)].Scalar &&
      (!this->Geometry.HasOpacityScalars || this->Geometry.OpacityOnCells ||
        this->Geometry.OpacityScalars[std::size_t(first)] == this->Geometry.OpacityScalars[std::size_t(point)]);
    return same ? first : point;
  }

  Tetrahedron Vertices(std::size_t tetrahedron) const
  {
    Tetrahedron t = this->Geometry.Tetrahedra[tetrahedron];
    std::transform(t.begin(), t.end(), t.begin(), [this](std::int32_t p) { return this->Merged(p); });
    return t;
  }

  /** The tetrahedron across the face opposite vertex `face`, if it has the same three vertices. */
  std::int32_t Neighbor(std::size_t tetrahedron, const Tetrahedron& vertices, int face) const
  {
    const std::int32_t neighbor = this->Connected.UnfoldedNeighbor(tetrahedron, face);
    if (neighbor < 0)
    {
      return -1;
    }
    const Tetrahedron other = this->Vertices(std::size_t(neighbor));
    for (int k = 0; k < 4; ++k)
    {
      if (k != face && std::find(other.begin(), other.end(), vertices[std::size_t(k)]) == other.end())
      {
        return -1;
      }
    }
    return neighbor;
  }

private:
  const CellGeometry& Geometry;
  const VisibilityOrder& Connected;
};
}

void TetrahedronNeighbors::Clear()
{
  *this = TetrahedronNeighbors();
}

void TetrahedronNeighbors::Build(const CellGeometry& geometry, const VisibilityOrder& connected)
{
  const std::size_t n = geometry.Tetrahedra.size();
  const MergedVertices merged(geometry, connected);
  this->MergedPoints.resize(geometry.Points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(geometry.Points.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->MergedPoints[std::size_t(i)] = merged.Merged(std::int32_t(i));
    }
  });
  this->DependOnValues = false;
  for (std::size_t i = 0; i < geometry.Points.size() && !this->DependOnValues; ++i)
  {
    this->DependOnValues = connected.CanonicalPoint(std::int32_t(i)) != std::int32_t(i);
  }
  this->Neighbors.assign(4 * n, -1);
  this->VertexSums.assign(n, 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i)
    {
      const Tetrahedron t = merged.Vertices(i);
      for (int face = 0; face < 4; ++face)
      {
        const std::int32_t opposite = t[std::size_t(face)];
        const auto rank = std::count_if(t.begin(), t.end(), [opposite](std::int32_t v) { return v < opposite; });
        this->Neighbors[4 * i + std::size_t(rank)] = merged.Neighbor(i, t, face);
        this->VertexSums[i] ^= opposite;
      }
    }
  });
  this->BoundaryFaces.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    Tetrahedron t = merged.Vertices(i);
    std::sort(t.begin(), t.end());
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (this->Neighbors[4 * i + k] < 0)
      {
        BoundaryFace face = { { t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4], t[k] } };
        turnOutwards(geometry, face);
        face[3] = std::int32_t(i);
        this->BoundaryFaces.push_back(face);
      }
    }
  }
}

} // namespace nephoscope
