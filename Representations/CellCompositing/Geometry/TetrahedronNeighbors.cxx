// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetrahedronNeighbors.h"

#include "BoundaryFaces.h"
#include "FaceNeighbors.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace nephoscope
{
namespace
{
/**
 * How a face is on record where values jump, until the faces are numbered: the tetrahedron across.
 * The function is its own inverse.
 */
constexpr std::int32_t JumpTo(std::int32_t tetrahedron)
{
  return TetrahedronNeighbors::Jump - tetrahedron;
}

/** Position of a vertex among all four in ascending order. */
std::int32_t RankOf(const Tetrahedron& t, int vertex)
{
  return std::int32_t(
    std::count_if(t.begin(), t.end(), [&](std::int32_t v) { return v < t[std::size_t(vertex)]; }));
}

struct JumpFace
{
  BoundaryFace Face;
  std::int32_t To;   // the tetrahedron across
  std::size_t Place; // in the list of neighbours
};

/**
 * The same face seen from the other tetrahedron, if it is one for sure. `jumps` are in the order of
 * their tetrahedra.
 */
const JumpFace* FindPartner(const std::vector<JumpFace>& jumps, const JumpFace& jump)
{
  const auto isBefore = [](const JumpFace& j, std::int32_t tetrahedron) {
    return j.Face[3] < tetrahedron;
  };
  const JumpFace* found = nullptr;
  for (auto i = std::lower_bound(jumps.begin(), jumps.end(), jump.To, isBefore);
       i != jumps.end() && i->Face[3] == jump.To; ++i)
  {
    if (i->To == jump.Face[3])
    {
      if (found)
      {
        return nullptr;
      }
      found = &*i;
    }
  }
  return found;
}
}

void TetrahedronNeighbors::Clear()
{
  *this = TetrahedronNeighbors();
}

void TetrahedronNeighbors::Build(
  const CellGeometry& geometry, const FaceNeighbors& faces, const std::vector<float>& third)
{
  this->MergePoints(geometry, faces.GetPlaces(), third);
  this->Places = this->MergedPoints.empty() ? std::vector<std::int32_t>() : faces.GetPlaces();
  this->FindNeighbors(geometry, faces);
  this->ListBoundary(geometry);
}

void TetrahedronNeighbors::MergePlaces(const std::vector<std::int32_t>& places)
{
  std::int32_t point = 0;
  const bool apart = std::all_of(
    places.begin(), places.end(), [&point](std::int32_t place) { return place == point++; });
  this->MergedPoints = apart ? std::vector<std::int32_t>() : places;
}

void TetrahedronNeighbors::MergePoints(const CellGeometry& geometry,
  const std::vector<std::int32_t>& places, const std::vector<float>& third)
{
  this->MergePlaces(places);
  if (this->MergedPoints.empty())
  {
    return;
  }
  std::iota(this->MergedPoints.begin(), this->MergedPoints.end(), 0);
  std::vector<std::int32_t> coincident; // all but the first of each place
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] != std::int32_t(i))
    {
      coincident.push_back(std::int32_t(i));
    }
  }
  this->DependOnValues = true;
  const bool second = geometry.HasOpacityScalars && !geometry.OpacityOnCells;
  const auto values = [&](std::int32_t p) {
    const float scalar =
      geometry.CellScalars.empty() ? geometry.Points[std::size_t(p)].Scalar : 0.0f;
    return std::make_tuple(scalar, second ? geometry.OpacityScalars[std::size_t(p)] : 0.0f,
      third.empty() ? 0.0f : third[std::size_t(p)]);
  };
  const auto key = [&](std::int32_t p) {
    return std::tuple_cat(std::make_tuple(places[std::size_t(p)]), values(p));
  };
  // Points with values that are not finite belong to no tetrahedron, and would break the order.
  coincident.erase(std::remove_if(coincident.begin(), coincident.end(),
                     [&](std::int32_t p) {
                       return !std::isfinite(std::get<0>(values(p))) ||
                         !std::isfinite(std::get<1>(values(p))) ||
                         !std::isfinite(std::get<2>(values(p)));
                     }),
    coincident.end());
  vtkSMPTools::Sort(coincident.begin(), coincident.end(), [&](std::int32_t a, std::int32_t b) {
    return std::tuple_cat(key(a), std::tie(a)) < std::tuple_cat(key(b), std::tie(b));
  });
  for (std::size_t i = 0; i < coincident.size(); ++i)
  {
    const std::int32_t p = coincident[i];
    const std::int32_t first = places[std::size_t(p)];
    this->MergedPoints[std::size_t(p)] = values(p) == values(first) ? first
      : i > 0 && key(p) == key(coincident[i - 1])
      ? this->MergedPoints[std::size_t(coincident[i - 1])]
      : p;
  }
}

Tetrahedron TetrahedronNeighbors::MergedVertices(
  const CellGeometry& geometry, std::size_t tetrahedron) const
{
  Tetrahedron t = geometry.Tetrahedra[tetrahedron];
  std::transform(t.begin(), t.end(), t.begin(), [this](std::int32_t p) { return this->Merged(p); });
  return t;
}

// A tetrahedron across the face opposite vertex `face`; JumpTo it where it has other vertices
// there.
std::int32_t TetrahedronNeighbors::Linked(
  const CellGeometry& geometry, const Tetrahedron& vertices, std::int32_t neighbor, int face) const
{
  if (neighbor < 0)
  {
    return None;
  }
  const Tetrahedron other = this->MergedVertices(geometry, std::size_t(neighbor));
  for (int k = 0; k < 4; ++k)
  {
    if (k != face && std::find(other.begin(), other.end(), vertices[std::size_t(k)]) == other.end())
    {
      return JumpTo(neighbor);
    }
  }
  return neighbor;
}

void TetrahedronNeighbors::FindNeighbors(const CellGeometry& geometry, const FaceNeighbors& faces)
{
  const std::size_t n = geometry.Tetrahedra.size();
  this->Neighbors.assign(4 * n, None);
  this->VertexSums.assign(n, 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i)
    {
      const Tetrahedron t = this->MergedVertices(geometry, i);
      for (int face = 0; face < 4; ++face)
      {
        this->Neighbors[4 * i + std::size_t(RankOf(t, face))] =
          this->Linked(geometry, t, faces.Get(i, face), face);
        this->VertexSums[i] ^= t[std::size_t(face)];
      }
    }
  });
}

std::vector<std::array<std::int32_t, 4>> TetrahedronNeighbors::Links(
  const CellGeometry& geometry) const
{
  std::vector<std::array<std::int32_t, 4>> result(this->VertexSums.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(result.size()), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i)
    {
      Tetrahedron t = this->MergedVertices(geometry, i);
      std::sort(t.begin(), t.end());
      std::array<std::int32_t, 4> n;
      for (int k = 0; k < 4; ++k)
      {
        n[std::size_t(k)] = this->Packed(geometry, t, k, this->Neighbors[4 * i + std::size_t(k)]);
      }
      result[i] = { { this->VertexSums[i], n[0] ^ n[3], n[1] ^ n[3], n[2] ^ n[3] } };
    }
  });
  return result;
}

// A neighbour as NeighborTopology.glsl has it; `vertex`: the one across from it.
std::int32_t TetrahedronNeighbors::Packed(
  const CellGeometry& geometry, const Tetrahedron& t, int vertex, std::int32_t neighbor) const
{
  if (neighbor < 0)
  {
    return 4 * neighbor;
  }
  const Tetrahedron other = this->MergedVertices(geometry, std::size_t(neighbor));
  std::int32_t ahead = 0;
  for (int k = 0; k < 4; ++k)
  {
    ahead ^= other[std::size_t(k)] ^ (k == vertex ? 0 : t[std::size_t(k)]);
  }
  std::int32_t rank = 0;
  for (int k = 0; k < 4; ++k)
  {
    rank += k != vertex && t[std::size_t(k)] < ahead;
  }
  return 4 * neighbor + rank;
}

void TetrahedronNeighbors::ReleaseNeighbors()
{
  for (std::vector<std::int32_t>* list : { &this->Neighbors, &this->VertexSums })
  {
    std::vector<std::int32_t>().swap(*list); // clear() and = {} keep the memory
  }
}

std::vector<std::array<std::int32_t, 2>> TetrahedronNeighbors::FindOneNeighbor(
  const CellGeometry& geometry, const std::vector<std::size_t>& tetrahedra) const
{
  constexpr int face = 0;
  const auto across = FindNeighborsAcross(geometry, this->Places, tetrahedra, face);
  std::vector<std::array<std::int32_t, 2>> result;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    const Tetrahedron t = this->MergedVertices(geometry, tetrahedra[i]);
    const std::int32_t link = this->Linked(geometry, t, across[i], face);
    const bool jumps = link <= Jump;
    const std::int32_t neighbor =
      jumps ? this->FindJump(t, std::int32_t(tetrahedra[i]), face) : link;
    result.push_back({ { this->Packed(geometry, t, face, neighbor), RankOf(t, face) } });
  }
  return result;
}

// What the neighbours have on record where values jump in the face across from a vertex.
std::int32_t TetrahedronNeighbors::FindJump(
  const Tetrahedron& t, std::int32_t tetrahedron, int face) const
{
  const std::size_t entries = this->BoundaryFaces.size() - this->NumberOfJumps;
  for (std::size_t i = entries; i < this->BoundaryFaces.size(); ++i)
  {
    const BoundaryFace& jump = this->BoundaryFaces[i];
    if (jump[3] == tetrahedron &&
      std::find(jump.begin(), jump.begin() + 3, t[std::size_t(face)]) == jump.begin() + 3)
    {
      return Jump - std::int32_t(i - (i - entries) % 2);
    }
  }
  return None;
}

void TetrahedronNeighbors::ListBoundary(const CellGeometry& geometry)
{
  std::vector<JumpFace> jumps;
  this->BoundaryFaces.clear();
  const auto addEntry = [&](const BoundaryFace& face) {
    if (HasExtent(geometry, face))
    {
      this->BoundaryFaces.push_back(face);
    }
  };
  for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
  {
    const std::int32_t* neighbors = &this->Neighbors[4 * i];
    if (std::min({ neighbors[0], neighbors[1], neighbors[2], neighbors[3] }) >= 0)
    {
      continue;
    }
    Tetrahedron t = this->MergedVertices(geometry, i);
    std::sort(t.begin(), t.end());
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (neighbors[k] < 0)
      {
        BoundaryFace face = { { t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4], t[k] } };
        TurnOutwards(geometry, face);
        face[3] = std::int32_t(i);
        neighbors[k] == None ? addEntry(face)
                             : jumps.push_back({ face, JumpTo(neighbors[k]), 4 * i + k });
      }
    }
  }
  // Those that do not find each other are boundary as all others.
  std::vector<const JumpFace*> partners(jumps.size());
  for (std::size_t i = 0; i < jumps.size(); ++i)
  {
    this->Neighbors[jumps[i].Place] = None;
    partners[i] = FindPartner(jumps, jumps[i]);
  }
  const auto isPaired = [&](std::size_t i) {
    return partners[i] && partners[std::size_t(partners[i] - jumps.data())] == &jumps[i];
  };
  for (std::size_t i = 0; i < jumps.size(); ++i)
  {
    if (!isPaired(i))
    {
      addEntry(jumps[i].Face);
    }
  }
  const std::size_t entries = this->BoundaryFaces.size();
  for (std::size_t i = 0; i < jumps.size(); ++i)
  {
    if (isPaired(i) && partners[i] > &jumps[i]) // both sides at once
    {
      const std::int32_t link = Jump - std::int32_t(this->BoundaryFaces.size());
      for (const JumpFace* side : { static_cast<const JumpFace*>(&jumps[i]), partners[i] })
      {
        this->Neighbors[side->Place] = link;
        this->BoundaryFaces.push_back(side->Face);
      }
    }
  }
  this->NumberOfJumps = this->BoundaryFaces.size() - entries;
}

} // namespace nephoscope
