// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CornerShares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
namespace
{
constexpr double sphere = 12.566370614359172;
constexpr double circle = 6.283185307179586;

// The squares of the edges at each corner; returns their mean.
double AddEdges(const CellKind& kind, const Vector3* x, SplatMatrix* edges)
{
  double squares = 0;
  for (int i = 0; i < kind.Corners; ++i)
  {
    for (const int next : kind.Neighbors[i])
    {
      const Vector3 e = x[next] - x[i];
      AddOuterProduct(edges[i], e);
      squares += Dot(e, e) / kind.Corners;
    }
  }
  return squares;
}

double SolidAngleAt(const CellKind& kind, const Vector3* x, int corner)
{
  const int* next = kind.Neighbors[corner];
  return SolidAngle(x[next[0]] - x[corner], x[next[1]] - x[corner], x[next[2]] - x[corner]);
}
}

double SharesOfSolid(const CellKind& kind, const Vector3* x, double volume, double times,
  const double* weights, CellShare* shares)
{
  SplatMatrix edges[8] = {};
  const double squares = AddEdges(kind, x, edges);
  double angles[8], all = 0;
  for (int i = 0; i < kind.Corners; ++i)
  {
    angles[i] = times * SolidAngleAt(kind, x, i) / sphere;
    all += angles[i];
  }
  for (int i = 0; i < kind.Corners && all > 0; ++i)
  {
    // Corners of tetrahedra have shares by their angles: what falls to a point then depends little
    // on how space is cut into them.
    const double even = all / kind.Corners;
    CellShare& share = shares[i];
    share.Dimension = 3;
    share.Angle = angles[i];
    share.Tetrahedra = kind.Corners == 4;
    share.MeanAngle = kind.Corners == 4 ? angles[i] : even;
    share.LatticeAngle =
      kind.Corners == 6 ? 0.5 * (angles[i] + angles[(i + 3) % 6]) : share.MeanAngle;
    share.Size = volume * (weights ? weights[i] : share.MeanAngle / all);
    AddWeighted(share.Edges, edges[i], share.MeanAngle);
  }
  return squares;
}

double SharesOfQuadraticHexahedron(
  const HexahedronCorners& x, double volume, CellShare (&shares)[20])
{
  SplatMatrix edges[8] = {};
  const double squares = AddEdges(hexahedron, x.data(), edges);
  const auto shareOf = [volume](double part, const SplatMatrix& here) {
    CellShare share;
    share.Dimension = 3;
    share.Angle = share.MeanAngle = share.LatticeAngle = part;
    share.Size = 0.25 * part * volume;
    share.Overlaps = true;
    AddWeighted(share.Edges, here, part);
    return share;
  };
  for (int i = 0; i < 8; ++i)
  {
    shares[i] = shareOf(angleInLattice, edges[i]);
  }
  for (int i = 0; i < 12; ++i)
  {
    SplatMatrix both{};
    AddWeighted(both, edges[hexahedronEdges[i][0]], 0.5);
    AddWeighted(both, edges[hexahedronEdges[i][1]], 0.5);
    shares[8 + i] = shareOf(2 * angleInLattice, both);
  }
  return squares;
}

std::array<double, 8> OctantsOfHexahedron(const HexahedronCorners& x)
{
  constexpr double threes[4] = { 1, 3, 9, 27 };
  double spanned[8], sum = 0;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const int* next = hexahedron.Neighbors[i];
    const auto edge = [&](int k) { return x[static_cast<std::size_t>(next[k])] - x[i]; };
    spanned[i] = std::abs(TripleProduct(edge(0), edge(1), edge(2)));
  }
  std::array<double, 8> weights{};
  for (int i = 0; i < 8; ++i)
  {
    double& weight = weights[static_cast<std::size_t>(i)];
    for (int j = 0; j < 8; ++j)
    {
      // One after the other around each of both ends, so that corners that differ by 2 there are
      // across from each other.
      const int around = (i - j) & 3;
      const int steps = (around == 2 ? 2 : around & 1) + int(i / 4 != j / 4);
      weight += spanned[j] * threes[3 - steps];
    }
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight = sum > 0 && std::isfinite(sum) ? weight / sum : 1.0 / 8;
  }
  return weights;
}

SurfaceExtent SharesOfPolygon(const std::vector<Vector3>& x, std::vector<CellShare>& shares)
{
  const std::size_t count = x.size();
  SurfaceExtent extent;
  for (std::size_t i = 2; i < count; ++i)
  {
    extent.Area += 0.5 * Norm(Cross(x[i - 1] - x[0], x[i] - x[0]));
    extent.Squares = std::max(extent.Squares, Dot(x[i] - x[0], x[i] - x[0]));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3 a = x[(i + 1) % count] - x[i];
    const Vector3 b = x[(i + count - 1) % count] - x[i];
    CellShare& share = shares[i];
    share.Dimension = 2;
    share.Size = extent.Area / static_cast<double>(count);
    share.Angle = std::atan2(Norm(Cross(a, b)), Dot(a, b)) / circle;
    share.MeanAngle = 0.5 * (static_cast<double>(count) - 2) / static_cast<double>(count);
    share.LatticeAngle = count == 3 ? share.Angle : share.MeanAngle;
    SplatMatrix edges{}, normals{};
    AddOuterProduct(edges, a);
    AddOuterProduct(edges, b);
    AddOuterProduct(normals, Normalized(Cross(a, b)));
    AddWeighted(share.Edges, edges, share.MeanAngle);
    AddWeighted(share.Normals, normals, share.Size);
  }
  return extent;
}
}
