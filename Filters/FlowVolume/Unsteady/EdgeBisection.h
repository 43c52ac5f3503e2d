// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Long edges of a mesh of tetrahedra halved, the longest first, in all tetrahedra at an edge
// together: no cracks and no hanging points (Rivara1984, without propagation, as no edge needs to
// be the longest of its tetrahedra). Plain C++17.
#ifndef nephoscope_EdgeBisection_h
#define nephoscope_EdgeBisection_h

#include "StreakMesh.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace nephoscope
{
struct BisectionLimits
{
  double MaximumEdgeLength = 0.0;
  std::size_t MaximumNumberOfTetrahedra = 0;
};

// The new point lies in the middle of the edge, in place and in release time;
// both halves of a tetrahedron have half its mass and half its volume. Halved
// edges of the front are noted in it. False if the limit of tetrahedra has been
// reached.
bool BisectLongEdges(StreakMesh& mesh, const BisectionLimits& limits);

// The same once for each edge of the marked tetrahedra that is longer than the limit. Returns how
// many have been halved.
std::size_t BisectMarked(
  StreakMesh& mesh, const BisectionLimits& limits, const std::vector<unsigned char>& marks);

// The parts of a tetrahedron with corners on the front: it is cut as the
// tetrahedra on the other side of the front have been.
class FrontDivision
{
public:
  explicit FrontDivision(const StreakFront& front);

  std::vector<TetrahedronPoints> Divide(const TetrahedronPoints& tetrahedron) const;

private:
  struct Cut
  {
    std::size_t Order = 0;
    PointId Middle = 0;
  };

  using CutMap = std::map<std::pair<PointId, PointId>, Cut>;

  CutMap::const_iterator FirstCut(const TetrahedronPoints& points) const;

  CutMap Cuts;
};
}

#endif
