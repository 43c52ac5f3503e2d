// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointMasses.h"

#include "vtkSMPTools.h"

namespace nephoscope
{
namespace
{
// Some unit vector across `a`.
Vector3 AnyNormal(const Vector3& a)
{
  const Vector3 axis =
    std::abs(a[0]) <= std::abs(a[1]) ? Vector3{ { 1.0, 0.0, 0.0 } } : Vector3{ { 0.0, 1.0, 0.0 } };
  return Normalized(Cross(a, axis));
}

// Gives the axes of a cell that have one point only the thickness 1, at right angles to the others.
void ThickenFlatAxes(const std::array<bool, 3>& flat, std::array<Vector3, 8>& corners)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!flat[axis])
    {
      continue;
    }
    const int b = 1 << (axis + 1) % 3;
    const int c = 1 << (axis + 2) % 3;
    // Diagonals, so that a face with a side that is one point has a normal too.
    const Vector3 one = corners[b | c] - corners[0];
    const Vector3 two = corners[c] - corners[b];
    Vector3 normal = Normalized(Cross(one, two));
    if (!(Norm(normal) > 0.0))
    {
      normal = AnyNormal(Norm(one) > 0.0 ? one : two);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      if (corner & 1 << axis)
      {
        corners[corner] = corners[corner & ~(1 << axis)] + normal;
      }
    }
  }
}

class OctantSum
{
public:
  OctantSum(const GridTopology& topology, const std::function<Vector3(const GridIndex&)>& position)
    : Topology(topology)
    , Position(position)
    , Masses(static_cast<std::size_t>(topology.Count()), 0.0)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Flat[axis] = topology.Size[axis] == 1;
      const int distinct = topology.Distinct(axis);
      this->Cells[axis] = topology.Ring[axis] ? distinct : std::max(1, distinct - 1);
    }
  }

  // Slabs of cells share planes of points with the next ones only: even slabs at once, then odd
  // ones, and the last slab of a ring, which meets the first, alone. So every sum has the same
  // order, whatever the number of threads.
  std::vector<double> Run()
  {
    const int slabs = this->Cells[2];
    const int apart = this->Topology.Ring[2] ? slabs - 1 : slabs;
    for (int parity = 0; parity < 2; ++parity)
    {
      vtkSMPTools::For(0, (apart - parity + 1) / 2, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType s = begin; s < end; ++s)
        {
          this->AddSlab(2 * static_cast<int>(s) + parity);
        }
      });
    }
    for (int k = apart; k < slabs; ++k)
    {
      this->AddSlab(k);
    }
    return this->Masses;
  }

private:
  void AddSlab(int k)
  {
    for (int j = 0; j < this->Cells[1]; ++j)
    {
      for (int i = 0; i < this->Cells[0]; ++i)
      {
        this->AddCell({ { i, j, k } });
      }
    }
  }

  void AddCell(const GridIndex& cell)
  {
    std::array<Vector3, 8> corners;
    std::array<std::int64_t, 8> ids;
    for (int corner = 0; corner < 8; ++corner)
    {
      GridIndex at = cell;
      for (int axis = 0; axis < 3; ++axis)
      {
        at[axis] += this->Flat[axis] ? 0 : corner >> axis & 1;
      }
      corners[corner] = this->Position(at);
      ids[corner] = this->Topology.Id(this->Topology.Canonical(at));
    }
    ThickenFlatAxes(this->Flat, corners);
    const HexahedronOctants octants(corners);
    double volumes[8];
    double total = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      volumes[corner] = octants.Volume(corner);
      total += volumes[corner];
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Masses[ids[corner]] +=
        total < 0.0 ? -volumes[corner] : volumes[corner]; // left-handed grids
    }
  }

  const GridTopology& Topology;
  const std::function<Vector3(const GridIndex&)>& Position;
  std::vector<double> Masses;
  std::array<bool, 3> Flat;
  GridIndex Cells;
};
}

std::vector<double> ProductMasses(
  const GridTopology& topology, const std::array<std::vector<double>, 3>& widths)
{
  std::vector<double> masses(static_cast<std::size_t>(topology.Count()), 0.0);
  for (int k = 0; k < topology.Distinct(2); ++k)
  {
    for (int j = 0; j < topology.Distinct(1); ++j)
    {
      for (int i = 0; i < topology.Distinct(0); ++i)
      {
        masses[topology.Id({ { i, j, k } })] = widths[0][i] * (widths[1][j] * widths[2][k]);
      }
    }
  }
  return masses;
}

std::vector<double> OctantMasses(
  const GridTopology& topology, const std::function<Vector3(const GridIndex&)>& position)
{
  return OctantSum(topology, position).Run();
}
}
