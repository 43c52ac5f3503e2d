// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The surface of one polyhedral cell: its vertices in the order of CellDecomposition.h's rule, its
 * faces wound outward.
 *
 * Files seldom wind the faces of their polyhedra with care, and grids that shrink to a pole have
 * vertices that coincide.
 * Coincident vertices are therefore merged, faces are reversed until neighbours traverse their
 * common edge in opposite directions, and each connected part is oriented as a whole: outer parts
 * have a positive volume, boundaries of cavities a negative one.
 *
 * A vertex's number is its rank by coordinates (x, then y, then z), so "least vertex" is "least
 * number", the same for every cell that has the vertex.
 */
#ifndef nephoscope_PolyhedronSurface_h
#define nephoscope_PolyhedronSurface_h

#include "CellDecomposition.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nephoscope
{

/**
 * Six times the volume of the tetrahedron (apex, a, b, c): positive where (a, b, c) runs outward as
 * seen from the apex.
 */
inline double SixVolumes(const Vector3& apex, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return Dot(Cross(Difference(a, apex), Difference(b, apex)), Difference(c, apex));
}

class PolyhedronSurface
{
public:
  enum class State
  {
    Closed,     ///< every edge belongs to two faces, which can be wound outward
    NotFinite,  ///< a coordinate is not finite
    NotClosed,  ///< an edge belongs to one face, or to more than two
    NotOriented ///< one-sided, as a Moebius strip is
  };

  /** `place(id)` gives the coordinates of the point that `faces` names by id. */
  template <typename Index, typename Place>
  State Build(FaceList<Index> faces, Place place);

  int NumberOfVertices() const { return static_cast<int>(this->Positions.size()); }
  const Vector3& Position(int vertex) const
  {
    return this->Positions[static_cast<std::size_t>(vertex)];
  }
  /** The point id of a vertex; where several coincide, the least of them. */
  long long PointId(int vertex) const { return this->Ids[static_cast<std::size_t>(vertex)]; }
  FaceList<int> Faces() const
  {
    return { this->Flat.data(), this->Flat.data() + this->Flat.size() };
  }
  /** One face (its place in Faces()) of each part that bounds a cavity. */
  const std::vector<int>& CavityFaces() const { return this->Cavities; }
  /** Diagonal of the bounding box. */
  double Size() const { return this->Diagonal; }
  /** Largest absolute coordinate: what rounding of the coordinates is relative to. */
  double Magnitude() const { return this->LargestCoordinate; }

private:
  struct Edge
  {
    int Low, High, Face;
    bool Rising; ///< the face runs from Low to High
    bool operator<(const Edge& o) const { return Low != o.Low ? Low < o.Low : High < o.High; }
  };

  template <typename Index, typename Place>
  bool NumberVertices(FaceList<Index> faces, Place place);
  template <typename Index>
  void CopyFaces(FaceList<Index> faces);
  int* Face(int face) { return &this->Flat[this->Starts[static_cast<std::size_t>(face)]]; }
  int RankOf(long long id) const;
  bool CollectEdges();
  bool Wind();
  void Flip(int face)
  {
    std::reverse(this->Face(face) + 1, this->Face(face) + 1 + *this->Face(face));
  }
  void TurnParts();
  double SixVolumesOfPart(int part);
  bool IsInside(const Vector3& point, int part);

  std::vector<Vector3> Positions;
  std::vector<long long> Ids;
  std::vector<std::pair<long long, int>> Ranks; ///< point id, vertex; sorted
  std::vector<int> Flat;                        ///< size, vertices, size, vertices, ...
  std::vector<std::size_t> Starts;              ///< of each face in Flat
  std::vector<Edge> Edges; ///< pairs: the two faces at an edge follow each other
  std::vector<int> Parts;  ///< the connected part of each face
  int NumberOfParts = 0;
  std::vector<int> Cavities;
  double Diagonal = 0;
  double LargestCoordinate = 0;
};

//------------------------------------------------------------------------------------------------
template <typename Index, typename Place>
PolyhedronSurface::State PolyhedronSurface::Build(FaceList<Index> faces, Place place)
{
  if (!this->NumberVertices(faces, place))
  {
    return State::NotFinite;
  }
  this->CopyFaces(faces);
  if (!this->CollectEdges())
  {
    return State::NotClosed;
  }
  if (!this->Wind())
  {
    return State::NotOriented;
  }
  this->TurnParts();
  return State::Closed;
}

template <typename Index, typename Place>
bool PolyhedronSurface::NumberVertices(FaceList<Index> faces, Place place)
{
  struct Vertex
  {
    Vector3 X;
    long long Id;
    bool operator<(const Vertex& o) const { return X != o.X ? X < o.X : Id < o.Id; }
  };
  std::vector<long long> ids;
  for (const Index* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    ids.insert(ids.end(), face + 1, face + 1 + *face);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<Vertex> vertices;
  this->LargestCoordinate = 0;
  for (const long long id : ids)
  {
    vertices.push_back({ place(static_cast<Index>(id)), id });
    for (const double x : vertices.back().X)
    {
      if (!std::isfinite(x))
      {
        return false;
      }
      this->LargestCoordinate = std::max(this->LargestCoordinate, std::abs(x));
    }
  }
  std::sort(vertices.begin(), vertices.end());
  this->Positions.clear();
  this->Ids.clear();
  this->Ranks.clear();
  for (const Vertex& v : vertices)
  {
    if (this->Positions.empty() || this->Positions.back() != v.X)
    {
      this->Positions.push_back(v.X);
      this->Ids.push_back(v.Id);
    }
    this->Ranks.emplace_back(v.Id, this->NumberOfVertices() - 1);
  }
  std::sort(this->Ranks.begin(), this->Ranks.end());
  return true;
}

inline int PolyhedronSurface::RankOf(long long id) const
{
  return std::lower_bound(this->Ranks.begin(), this->Ranks.end(), std::make_pair(id, 0))->second;
}

// Without vertices that follow themselves, and without faces of fewer than three.
template <typename Index>
void PolyhedronSurface::CopyFaces(FaceList<Index> faces)
{
  this->Flat.clear();
  this->Starts.clear();
  for (const Index* face = faces.Begin; face != faces.End; face += *face + 1)
  {
    const std::size_t start = this->Flat.size();
    this->Flat.push_back(0);
    for (Index k = 1; k <= *face; ++k)
    {
      const int vertex = this->RankOf(face[k]);
      if (this->Flat.size() == start + 1 || this->Flat.back() != vertex)
      {
        this->Flat.push_back(vertex);
      }
    }
    while (this->Flat.size() > start + 2 && this->Flat.back() == this->Flat[start + 1])
    {
      this->Flat.pop_back();
    }
    const std::size_t size = this->Flat.size() - start - 1;
    this->Flat[start] = static_cast<int>(size);
    if (size < 3)
    {
      this->Flat.resize(start);
      continue;
    }
    this->Starts.push_back(start);
  }
  Vector3 low{}, high{};
  if (!this->Positions.empty())
  {
    low = high = this->Positions.front();
  }
  for (const Vector3& x : this->Positions)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], x[axis]);
      high[axis] = std::max(high[axis], x[axis]);
    }
  }
  const Vector3 d = Difference(high, low);
  this->Diagonal = std::sqrt(Dot(d, d));
}

inline bool PolyhedronSurface::CollectEdges()
{
  this->Edges.clear();
  for (int f = 0; f < static_cast<int>(this->Starts.size()); ++f)
  {
    const int* face = this->Face(f);
    for (int k = 0; k < *face; ++k)
    {
      const int a = face[1 + k];
      const int b = face[1 + (k + 1) % *face];
      this->Edges.push_back({ std::min(a, b), std::max(a, b), f, a < b });
    }
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  const std::size_t n = this->Edges.size();
  for (std::size_t i = 0; i < n; i += 2)
  {
    const bool paired = i + 1 < n && !(this->Edges[i] < this->Edges[i + 1]);
    const bool more = i + 2 < n && !(this->Edges[i] < this->Edges[i + 2]);
    if (!paired || more)
    {
      return false;
    }
  }
  return n > 0;
}

// Walks from face to face across edges; false if a face would need both orientations.
inline bool PolyhedronSurface::Wind()
{
  const std::size_t n = this->Starts.size();
  std::vector<std::vector<std::size_t>> edgesOf(n);
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    edgesOf[static_cast<std::size_t>(this->Edges[e].Face)].push_back(e);
  }
  std::vector<char> turned(n, 0);
  this->Parts.assign(n, -1);
  this->NumberOfParts = 0;
  std::vector<int> stack;
  for (std::size_t first = 0; first < n; ++first)
  {
    if (this->Parts[first] >= 0)
    {
      continue;
    }
    const int part = this->NumberOfParts++;
    this->Parts[first] = part;
    stack.push_back(static_cast<int>(first));
    while (!stack.empty())
    {
      const auto face = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      for (const std::size_t e : edgesOf[face])
      {
        const Edge& here = this->Edges[e];
        const Edge& there = this->Edges[e ^ 1];
        const auto other = static_cast<std::size_t>(there.Face);
        const char turn =
          static_cast<char>(turned[face] ^ static_cast<char>(here.Rising == there.Rising));
        if (this->Parts[other] < 0)
        {
          this->Parts[other] = part;
          turned[other] = turn;
          stack.push_back(there.Face);
        }
        else if (turned[other] != turn)
        {
          return false;
        }
      }
    }
  }
  for (std::size_t f = 0; f < n; ++f)
  {
    if (turned[f])
    {
      this->Flip(static_cast<int>(f));
    }
  }
  return true;
}

inline double PolyhedronSurface::SixVolumesOfPart(int part)
{
  double sum = 0;
  const Vector3& origin = this->Positions.front();
  for (std::size_t f = 0; f < this->Starts.size(); ++f)
  {
    const int* face = this->Face(static_cast<int>(f));
    for (int k = 2; this->Parts[f] == part && k < *face; ++k)
    {
      sum += SixVolumes(
        origin, this->Position(face[1]), this->Position(face[k]), this->Position(face[k + 1]));
    }
  }
  return sum;
}

// By the solid angle under which the part is seen: 4 pi from inside, 0 from outside
// (VanOosteromStrackee1983).
inline bool PolyhedronSurface::IsInside(const Vector3& point, int part)
{
  double half = 0;
  for (std::size_t f = 0; f < this->Starts.size(); ++f)
  {
    const int* face = this->Face(static_cast<int>(f));
    for (int k = 2; this->Parts[f] == part && k < *face; ++k)
    {
      const Vector3 a = Difference(this->Position(face[1]), point);
      const Vector3 b = Difference(this->Position(face[k]), point);
      const Vector3 c = Difference(this->Position(face[k + 1]), point);
      const double la = std::sqrt(Dot(a, a)), lb = std::sqrt(Dot(b, b)), lc = std::sqrt(Dot(c, c));
      half += std::atan2(
        Dot(Cross(a, b), c), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
    }
  }
  return std::abs(half) > std::acos(-1.0);
}

// Outward: positive volume for parts inside an even number of others, negative for cavities.
inline void PolyhedronSurface::TurnParts()
{
  this->Cavities.clear();
  for (int part = 0; part < this->NumberOfParts; ++part)
  {
    const auto own = static_cast<int>(
      std::find(this->Parts.begin(), this->Parts.end(), part) - this->Parts.begin());
    const Vector3& point = this->Position(this->Face(own)[1]);
    bool cavity = false;
    for (int other = 0; other < this->NumberOfParts; ++other)
    {
      cavity ^= other != part && this->IsInside(point, other);
    }
    if (cavity)
    {
      this->Cavities.push_back(own);
    }
    if ((this->SixVolumesOfPart(part) < 0) != cavity)
    {
      for (std::size_t f = 0; f < this->Starts.size(); ++f)
      {
        if (this->Parts[f] == part)
        {
          this->Flip(static_cast<int>(f));
        }
      }
    }
  }
}

} // namespace nephoscope

#endif
