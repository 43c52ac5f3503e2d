// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HexahedronNeighbors.h"

#include "BoundaryFaces.h"
#include "Buckets.h"
#include "CoincidentPoints.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nephoscope
{
namespace
{
using Quadrilateral = std::array<std::int32_t, 4>;

/**
 * A face on its way to meeting its partner: all but the lowest of its places, in order, those that
 * coincide once.
 */
struct OpenQuadrilateral
{
  std::array<std::int32_t, 3> Places;
  std::int32_t Cell;
  int Face;

  bool operator<(const OpenQuadrilateral& other) const
  {
    return std::tie(this->Places, this->Cell, this->Face) <
      std::tie(other.Places, other.Cell, other.Face);
  }
};

class HexahedronLinks
{
public:
  HexahedronLinks(const CellGeometry& geometry, const std::vector<std::int32_t>& places,
    TetrahedronNeighbors& neighbors)
    : Geometry(geometry)
    , Places(places)
    , Neighbors(neighbors)
    , Links(neighbors.Neighbors)
  {
  }

  bool Find(const Progress& progress)
  {
    const std::size_t n = this->Geometry.Hexahedra.size();
    this->Links.assign(6 * n, TetrahedronNeighbors::None);
    Buckets<OpenQuadrilateral> buckets; // by lowest place
    return buckets.Fill(n, std::max<std::size_t>(this->Places.size(), 1), progress.Part(0, 0.6),
             [&](std::size_t i, auto add) {
               for (int face = 0; face < 6; ++face)
               {
                 Quadrilateral places = this->PlacesOf(std::int32_t(i), face);
                 std::sort(places.begin(), places.end());
                 auto* end = std::unique(places.data(), places.data() + 4);
                 std::fill(end, places.data() + 4, -1);
                 if (places[2] >= 0)
                 {
                   add(std::size_t(places[0]),
                     { { { places[1], places[2], places[3] } }, std::int32_t(i), face });
                 }
               }
             }) &&
      buckets.ForEach(progress.Part(0.6, 1), [&](OpenQuadrilateral* begin, OpenQuadrilateral* end) {
        std::sort(begin, end);
        for (OpenQuadrilateral* f = begin; end - f >= 2; ++f)
        {
          if (f[0].Places == f[1].Places)
          {
            this->Link(f[0], f[1]);
            ++f; // a third one at the same face overlaps its neighbours
          }
        }
      });
  }

private:
  Quadrilateral PlacesOf(std::int32_t cell, int face) const
  {
    Quadrilateral result;
    const Hexahedron& vertices = this->Geometry.Hexahedra[std::size_t(cell)];
    const auto corners = HexahedronFace(face);
    for (std::size_t k = 0; k < 4; ++k)
    {
      result[k] = this->Places[std::size_t(vertices[corners[k]])];
    }
    return result;
  }

  // As the walk has it.
  std::int32_t PointOf(std::int32_t vertex) const
  {
    return this->Geometry.DividesHexahedra ? this->Neighbors.Merged(vertex) : vertex;
  }

  // How far the middle of a cell is in front of a face, and what of it rounding may be.
  std::array<double, 2> Height(std::int32_t cell, const OpenQuadrilateral& face) const
  {
    const auto at = [&](std::int32_t c, std::size_t k) {
      return this->Geometry.Position(this->Geometry.Hexahedra[std::size_t(c)][k]);
    };
    const auto c = HexahedronFace(face.Face);
    const Vector3 a = at(face.Cell, c[0]);
    const Vector3 ab = Difference(at(face.Cell, c[3]), a);
    const Vector3 normal = Cross(ab, Difference(at(face.Cell, c[2]), at(face.Cell, c[1])));
    Vector3 middle = { 0, 0, 0 }, ofFace = { 0, 0, 0 };
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t k = 0; k < 8; ++k)
      {
        middle[axis] += 0.125 * at(cell, k)[axis];
        largest = std::max(largest, std::abs(at(cell, k)[axis]));
      }
      for (std::size_t k = 0; k < 4; ++k)
      {
        ofFace[axis] += 0.25 * at(face.Cell, c[k])[axis];
      }
    }
    const double rounding = 4.0 * std::numeric_limits<float>::epsilon() * largest;
    return { { Dot(normal, Difference(middle, ofFace)),
      rounding * std::sqrt(Dot(normal, normal)) } };
  }

  // Both cells lie on one side of their face.
  bool IsFolded(const OpenQuadrilateral& f, const OpenQuadrilateral& g) const
  {
    const auto one = this->Height(f.Cell, f), other = this->Height(g.Cell, f);
    return one[0] * other[0] > 0 && std::abs(one[0]) > one[1] && std::abs(other[0]) > other[1];
  }

  void Link(const OpenQuadrilateral& f, const OpenQuadrilateral& g)
  {
    const std::int32_t there = this->LinkFrom(f, g), back = this->LinkFrom(g, f);
    if (there >= 0 && back >= 0 && !this->IsFolded(f, g))
    {
      this->Links[6 * std::size_t(f.Cell) + std::size_t(f.Face)] = there;
      this->Links[6 * std::size_t(g.Cell) + std::size_t(g.Face)] = back;
    }
  }

  // None where the two cells divide the face in different ways.
  std::int32_t LinkFrom(const OpenQuadrilateral& f, const OpenQuadrilateral& g) const
  {
    const Quadrilateral places = this->PlacesOf(f.Cell, f.Face);
    const Hexahedron& own = this->Geometry.Hexahedra[std::size_t(f.Cell)];
    const Hexahedron& other = this->Geometry.Hexahedra[std::size_t(g.Cell)];
    const auto corners = HexahedronFace(f.Face), across = HexahedronFace(g.Face);
    const int first = g.Face < 2 ? 1 : 0, second = g.Face < 4 ? 2 : 1; // axes of the other's face
    for (std::size_t start = 0; start < 4; ++start)
    {
      for (std::size_t turned = 0; turned < 2; ++turned)
      {
        bool fits = true, same = true;
        for (std::size_t k = 0; k < 4; ++k)
        {
          const std::size_t along = turned != 0 ? (k >> 1) | ((k & 1) << 1) : k;
          const std::int32_t vertex = other[across[start ^ along]];
          fits = fits && this->Places[std::size_t(vertex)] == places[k] &&
            (!this->Geometry.DividesHexahedra ||
              IsOddCorner(across[start ^ along]) == IsOddCorner(corners[k]));
          same = same && this->PointOf(vertex) == this->PointOf(own[corners[k]]);
        }
        if (fits)
        {
          const std::array<int, 2> axes = { { turned != 0 ? second : first,
            turned != 0 ? first : second } };
          return this->Geometry.DividesHexahedra
            ? PackedForDivided(g.Cell, f.Face, across[start], axes, !same)
            : Packed(g.Cell, across[start], axes[0], axes[1], !same);
        }
      }
    }
    return this->Geometry.DividesHexahedra ? std::int32_t(TetrahedronNeighbors::None)
                                           : Packed(g.Cell, across[0], first, second, true);
  }

  // As ListedHexahedra.glsl reads it.
  static std::int32_t Packed(
    std::int32_t cell, std::size_t start, int first, int second, bool reload)
  {
    const int order = 2 * first + (second == (first + 1) % 3 ? 0 : 1);
    return ((cell * 6 + order) * 8 + std::int32_t(start)) * 2 + (reload ? 1 : 0);
  }

  // As DividedHexahedra.glsl reads it: into which corner of the other cell each corner of this one
  // is turned (by offset and axes).
  static std::int32_t PackedForDivided(
    std::int32_t cell, int face, std::size_t start, const std::array<int, 2>& axes, bool reload)
  {
    const int across = face >> 1, ahead = 3 - axes[0] - axes[1];
    std::array<int, 3> to;
    to[across == 0 ? 1 : 0] = axes[0];
    to[across == 2 ? 1 : 2] = axes[1];
    to[across] = ahead;
    const int offset = static_cast<int>(start) ^ ((face & 1) != 0 ? 1 << ahead : 0);
    const int turns = 2 * to[0] + (to[1] == (to[0] + 1) % 3 ? 0 : 1);
    return cell << 7 | turns << 4 | offset << 1 | (reload ? 1 : 0);
  }

  const CellGeometry& Geometry;
  const std::vector<std::int32_t>& Places;
  const TetrahedronNeighbors& Neighbors;
  std::vector<std::int32_t>& Links;
};

void MoveToPlaces(CellGeometry& geometry, const std::vector<std::int32_t>& places)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const CellGeometry::Point& first = geometry.Points[std::size_t(places[i])];
    CellGeometry::Point& p = geometry.Points[i];
    p = { first.X, first.Y, first.Z, p.Scalar };
  }
}

Vector3 MiddleOf(const CellGeometry& geometry, const Hexahedron& cell)
{
  Vector3 middle = { 0, 0, 0 };
  for (const std::int32_t vertex : cell)
  {
    const Vector3 p = geometry.Position(vertex);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      middle[axis] += 0.125 * p[axis];
    }
  }
  return middle;
}

// The two triangles of a face; where hexahedra are divided, each begins with an odd vertex.
std::array<std::array<std::size_t, 3>, 2> TrianglesOf(int face, bool divided)
{
  const auto c = HexahedronFace(face);
  if (!divided)
  {
    return { { { { c[0], c[1], c[3] } }, { { c[0], c[3], c[2] } } } };
  }
  return IsOddCorner(c[0]) ? std::array<std::array<std::size_t, 3>, 2>{ { { { c[0], c[1], c[2] } },
                               { { c[3], c[1], c[2] } } } }
                           : std::array<std::array<std::size_t, 3>, 2>{ { { { c[1], c[0], c[3] } },
                               { { c[2], c[0], c[3] } } } };
}

// As DividedHexahedra.glsl reads it.
std::int32_t DividedEntry(std::int32_t cell, std::size_t odd, int face)
{
  return (8 * cell + std::int32_t(odd)) * 4 + (face >> 1);
}

void ListBoundary(const CellGeometry& geometry, TetrahedronNeighbors& neighbors)
{
  neighbors.BoundaryFaces.clear();
  for (std::size_t i = 0; i < geometry.Hexahedra.size(); ++i)
  {
    const Hexahedron& cell = geometry.Hexahedra[i];
    for (int face = 0; face < 6; ++face)
    {
      if (neighbors.Neighbors[6 * i + std::size_t(face)] >= 0)
      {
        continue;
      }
      for (const auto& corners : TrianglesOf(face, geometry.DividesHexahedra))
      {
        BoundaryFace triangle = { { cell[corners[0]], cell[corners[1]], cell[corners[2]],
          geometry.DividesHexahedra ? DividedEntry(std::int32_t(i), corners[0], face)
                                    : std::int32_t(8 * i) + face } };
        TurnOutwards(geometry, triangle, MiddleOf(geometry, cell));
        if (HasExtent(geometry, triangle))
        {
          neighbors.BoundaryFaces.push_back(triangle);
        }
      }
    }
  }
}
}

bool FindHexahedronNeighbors(CellGeometry& geometry, TetrahedronNeighbors& neighbors,
  const std::vector<float>& third, const Progress& progress)
{
  neighbors = TetrahedronNeighbors();
  std::vector<std::int32_t> places = FindPlaces(geometry, progress.Part(0, 0.1));
  if (places.size() != geometry.Points.size() ||
    !WeldPlaces(geometry, places, progress.Part(0.1, 0.3)))
  {
    return false;
  }
  MoveToPlaces(geometry, places);
  if (geometry.DividesHexahedra)
  {
    neighbors.MergePoints(geometry, places, third);
  }
  else
  {
    neighbors.MergePlaces(places);
  }
  if (!HexahedronLinks(geometry, places, neighbors).Find(progress.Part(0.3, 1)))
  {
    return false;
  }
  ListBoundary(geometry, neighbors);
  return progress.Report(1);
}

} // namespace nephoscope
