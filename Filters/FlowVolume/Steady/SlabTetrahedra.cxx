// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabTetrahedra.h"

#include "HalvedEdges.h"
#include "SmokeGeometry.h"

#include <limits>

namespace nephoscope
{
namespace
{
// A prism of the slab: its ids and its corners.
struct Prism
{
  PrismPoints Ids;
  std::array<const Vector3*, 6> Corners;
  double Volume = 0.0;
};

Prism MakePrism(const Slab& slab, const TrianglePoints& triangle)
{
  Prism prism;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto below = static_cast<std::size_t>(triangle[i]);
    const auto above = static_cast<std::size_t>(slab.TopOf[below]);
    prism.Ids[i] = slab.Below->Ids[below];
    prism.Ids[3 + i] = slab.Above->Ids[above];
    prism.Corners[i] = &slab.Below->Positions[below];
    prism.Corners[3 + i] = &slab.Above->Positions[above];
  }
  const auto& p = prism.Corners;
  prism.Volume = PrismVolume(*p[0], *p[1], *p[2], *p[3], *p[4], *p[5]);
  return prism;
}

// The merging of an edge makes a patch of triangles one: its smoke has one density.
std::vector<double> PatchDensities(
  const Slab& slab, const std::vector<FrontTriangle>& triangles, const std::vector<Prism>& prisms)
{
  const auto count = static_cast<std::size_t>(slab.NumberOfPatches);
  std::vector<double> densities(count, 0.0), volumes(count, 0.0);
  for (std::size_t t = 0; count > 0 && t < triangles.size(); ++t)
  {
    if (slab.Patches[t] >= 0)
    {
      densities[static_cast<std::size_t>(slab.Patches[t])] += triangles[t].Mass * slab.Step;
      volumes[static_cast<std::size_t>(slab.Patches[t])] += prisms[t].Volume;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    densities[i] /= volumes[i];
  }
  return densities;
}

bool HasRepeatedPoint(const TetrahedronPoints& t)
{
  return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
    t[2] == t[3];
}

struct PrismPart
{
  TetrahedronPoints Ids;
  double Volume;
};

PrismPart MakePart(const Prism& prism, const std::array<std::uint8_t, 4>& corners)
{
  const auto& p = prism.Corners;
  return { { { prism.Ids[corners[0]], prism.Ids[corners[1]], prism.Ids[corners[2]],
             prism.Ids[corners[3]] } },
    SignedVolume(*p[corners[0]], *p[corners[1]], *p[corners[2]], *p[corners[3]]) };
}

PrismPattern PatternOf(const Prism& prism)
{
  std::array<std::uint64_t, 6> ranks;
  std::transform(prism.Ids.begin(), prism.Ids.end(), ranks.begin(), Rank);
  return MakePrismPattern(ranks);
}

class SlabWriter
{
public:
  SlabWriter(const Slab& slab, SmokeMesh& mesh)
    : Between(slab)
    , Mesh(mesh)
  {
  }

  void AppendTetrahedra(const Prism& prism)
  {
    for (const auto& corners : PatternOf(prism))
    {
      const PrismPart part = MakePart(prism, corners);
      if (HasRepeatedPoint(part.Ids))
      {
        continue;
      }
      if (part.Volume > this->Between.SmallestVolume)
      {
        this->Mesh.Tetrahedra.push_back(part.Ids);
      }
      this->Folded += part.Volume < -this->Between.SmallestVolume;
    }
  }

  void AppendValues(double density)
  {
    const std::size_t count = this->Mesh.Tetrahedra.size();
    this->Mesh.Densities.resize(count, density);
    this->Mesh.EmissionSteps.resize(count, this->Between.EmissionStep);
    this->Mesh.Ages.resize(count, this->Between.Age);
  }

  std::size_t Folded = 0;

private:
  const Slab& Between;
  SmokeMesh& Mesh;
};
}

double SmallestTetrahedron(const Slab& slab, const TrianglePoints& triangle)
{
  const Prism prism = MakePrism(slab, triangle);
  double smallest = std::numeric_limits<double>::max();
  for (const auto& corners : PatternOf(prism))
  {
    const PrismPart part = MakePart(prism, corners);
    if (!HasRepeatedPoint(part.Ids))
    {
      smallest = std::min(smallest, part.Volume);
    }
  }
  return smallest;
}

SlabSums AppendSlab(const Slab& slab, std::vector<FrontTriangle>& above, SmokeMesh& mesh)
{
  std::vector<Prism> prisms(above.size());
  for (std::size_t t = 0; t < above.size(); ++t)
  {
    prisms[t] = MakePrism(slab, above[t].Points);
  }
  const std::vector<double> patches = PatchDensities(slab, above, prisms);
  SlabWriter writer(slab, mesh);
  SlabSums sums;
  for (std::size_t t = 0; t < above.size(); ++t)
  {
    const std::size_t folded = writer.Folded;
    writer.AppendTetrahedra(prisms[t]);
    const double mass = above[t].Mass * slab.Step;
    const bool patched = slab.NumberOfPatches > 0 && slab.Patches[t] >= 0;
    const double density = patched ? patches[static_cast<std::size_t>(slab.Patches[t])]
      : prisms[t].Volume > 0.0     ? mass / prisms[t].Volume
                                   : above[t].Density;
    writer.AppendValues(density);
    sums.Mass += mass;
    if (writer.Folded > folded)
    {
      sums.Folded.push_back(slab.Origins[t]);
    }
    above[t].Density = density;
  }
  return sums;
}

void HalveTetrahedra(const std::vector<std::array<PointId, 2>>& halved, PointId firstMiddle,
  std::size_t first, SmokeMesh& mesh)
{
  HalvedEdges edges(halved, firstMiddle);
  for (std::size_t t = first; t < mesh.Tetrahedra.size();)
  {
    const std::vector<TetrahedronPoints>& pieces = edges.Divide(mesh.Tetrahedra[t]);
    mesh.Tetrahedra[t] = pieces[0];
    for (std::size_t i = 1; i < pieces.size(); ++i)
    {
      mesh.Tetrahedra.push_back(pieces[i]);
      mesh.EmissionSteps.push_back(int(mesh.EmissionSteps[t]));
      mesh.Ages.push_back(double(mesh.Ages[t]));
      mesh.Densities.push_back(double(mesh.Densities[t]));
    }
    t += pieces.size() == 1; // else look again
  }
}
}
