// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointGradients.h"

#include "CellGeometry.h"
#include "CoincidentPoints.h"
#include "HexahedronForm.h"
#include "TetrahedronSource.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
using Edge = std::pair<vtkIdType, vtkIdType>;

/** The edges of the cells that are drawn, one cell after another. */
class EdgesOfCells
{
public:
  explicit EdgesOfCells(vtkDataSet* data)
    : Data(data)
    , Source(data)
  {
  }

  const std::vector<Edge>& Find(vtkIdType cell)
  {
    this->Edges.clear();
    if (this->Source.IsHidden(cell))
    {
      return this->Edges;
    }
    const int type = this->Data->GetCellType(cell);
    const HexahedronForm form = HexahedronFormOf(type);
    if (form.Tetrahedra > 0)
    {
      this->FindOfHexahedron(form.Vertices, type == VTK_HEXAHEDRON || type == VTK_VOXEL);
    }
    else
    {
      this->Source.EmitTetrahedra(cell, [this](const std::array<vtkIdType, 4>& t) {
        for (const auto& ends : { std::array<std::size_t, 2>{ { 0, 1 } }, { { 0, 2 } },
               { { 0, 3 } }, { { 1, 2 } }, { { 1, 3 } }, { { 2, 3 } } })
        {
          this->Edges.emplace_back(t[ends[0]], t[ends[1]]);
        }
      });
    }
    return this->Edges;
  }

private:
  // Vertices of wedges, pyramids and tetrahedra coincide: each of their edges counts once.
  void FindOfHexahedron(const std::array<int, 8>& vertices, bool areApart)
  {
    const vtkIdType* ids = this->Source.GetPoints()->GetPointer(0);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      for (std::size_t bit = 1; bit < 8; bit *= 2)
      {
        const vtkIdType a = ids[vertices[corner]], b = ids[vertices[corner | bit]];
        const Edge edge = std::minmax(a, b);
        if ((corner & bit) == 0 && a != b &&
          (areApart ||
            std::find(this->Edges.begin(), this->Edges.end(), edge) == this->Edges.end()))
        {
          this->Edges.push_back(edge);
        }
      }
    }
  }

  vtkDataSet* Data;
  TetrahedronSource Source;
  std::vector<Edge> Edges;
};
}

void GradientSums::Add(const Vector3& d, double change)
{
  const double weight = 1.0 / Dot(d, d);
  this->XX += weight * d[0] * d[0];
  this->XY += weight * d[0] * d[1];
  this->XZ += weight * d[0] * d[2];
  this->YY += weight * d[1] * d[1];
  this->YZ += weight * d[1] * d[2];
  this->ZZ += weight * d[2] * d[2];
  for (std::size_t c = 0; c < 3; ++c)
  {
    this->Right[c] += weight * d[c] * change;
  }
}

Vector3 GradientSums::Solve() const
{
  const Vector3 x = { { this->XX, this->XY, this->XZ } };
  const Vector3 y = { { this->XY, this->YY, this->YZ } };
  const Vector3 z = { { this->XZ, this->YZ, this->ZZ } };
  const Vector3 yz = Cross(y, z), zx = Cross(z, x), xy = Cross(x, y);
  const double determinant = Dot(x, yz);
  const double trace = this->XX + this->YY + this->ZZ;
  if (!(determinant > 1e-13 * trace * trace * trace))
  {
    return { { 0, 0, 0 } };
  }
  Vector3 g;
  for (std::size_t c = 0; c < 3; ++c)
  {
    g[c] = (this->Right[0] * yz[c] + this->Right[1] * zx[c] + this->Right[2] * xy[c]) / determinant;
  }
  return g;
}

std::vector<GradientSums> SumGradients(vtkDataSet* data, const CellGeometry& geometry,
  const std::vector<float>& scalars, const std::vector<std::int32_t>& places)
{
  std::vector<GradientSums> sums(places.size());
  const auto sumAt = [&](vtkIdType point) -> GradientSums& {
    return sums[static_cast<std::size_t>(places[static_cast<std::size_t>(point)])];
  };
  EdgesOfCells edges(data);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    for (const Edge& edge : edges.Find(cell))
    {
      const Vector3 d = Difference(geometry.Position(static_cast<std::int32_t>(edge.second)),
        geometry.Position(static_cast<std::int32_t>(edge.first)));
      const double change = double(scalars[static_cast<std::size_t>(edge.second)]) -
        double(scalars[static_cast<std::size_t>(edge.first)]);
      const double squared = Dot(d, d);
      if (squared > 0 && std::isfinite(squared) && std::isfinite(change))
      {
        sumAt(edge.first).Add(d, change);
        sumAt(edge.second).Add(d, change);
      }
    }
  }
  return sums;
}

std::vector<std::array<float, 4>> PointGradients(
  vtkDataSet* data, const CellGeometry& geometry, const std::vector<float>& scalars)
{
  const std::vector<std::int32_t> places = FindPlaces(geometry);
  const std::vector<GradientSums> sums = SumGradients(data, geometry, scalars, places);
  std::vector<std::array<float, 4>> gradients(places.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()), [&](vtkIdType begin, vtkIdType end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      const Vector3 g = sums[static_cast<std::size_t>(places[i])].Solve();
      gradients[i] = { { static_cast<float>(g[0]), static_cast<float>(g[1]),
        static_cast<float>(g[2]), 0.0f } };
    }
  });
  return gradients;
}

} // namespace nephoscope
