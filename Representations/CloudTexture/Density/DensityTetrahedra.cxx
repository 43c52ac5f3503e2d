// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DensityTetrahedra.h"

#include "ChessboardDivision.h"
#include "DensityVolume.h"
#include "TetrahedronSource.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
using Point = std::array<float, 4>;

/** Six times the volume. */
double SixVolumes(const Point& a, const Point& b, const Point& c, const Point& d)
{
  double edges[3][3];
  const Point* others[3] = { &b, &c, &d };
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      edges[i][axis] = double((*others[i])[axis]) - a[axis];
    }
  }
  const auto& e = edges;
  return std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
    e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
}

/** The cells of a block one by one, with the densities at their points. */
class DensityWalker
{
public:
  explicit DensityWalker(const DensityBlock& block)
    : Block(block)
    , Divisions(ChessboardDivision(block.Data))
    , Source(block.Data, this->Divisions)
  {
  }

  enum class Kind
  {
    Hidden,
    NotFinite,
    Empty, ///< no density
    Cloud
  };

  Kind Look(vtkIdType cell)
  {
    if (this->Source.IsHidden(cell))
    {
      return Kind::Hidden;
    }
    if (this->Block.OnCells)
    {
      const double density = this->Block.Densities->GetComponent(cell, 0);
      return !std::isfinite(density) || !this->HasFinitePlaces() ? Kind::NotFinite
        : density > 0                                            ? Kind::Cloud
                                                                 : Kind::Empty;
    }
    bool isFinite = this->HasFinitePlaces(), isCloud = false;
    for (const vtkIdType point : *this->Source.GetPoints())
    {
      const double density = this->Block.Densities->GetComponent(point, 0);
      isFinite = isFinite && std::isfinite(density);
      isCloud = isCloud || density > 0;
    }
    return !isFinite ? Kind::NotFinite : isCloud ? Kind::Cloud : Kind::Empty;
  }

  TetrahedronSource& GetSource() { return this->Source; }

private:
  bool HasFinitePlaces()
  {
    double x[3];
    return std::all_of(
      this->Source.GetPoints()->begin(), this->Source.GetPoints()->end(), [&](vtkIdType point) {
        this->Block.Data->GetPoint(point, x);
        return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
      });
  }

  const DensityBlock& Block;
  vtkSmartPointer<vtkUnsignedCharArray> Divisions; // as in a grid, so that storage does not matter
  TetrahedronSource Source;
};
}

std::string DensityTetrahedra::Take(const std::vector<DensityBlock>& blocks)
{
  this->FindCenter(blocks);
  const bool onCells = std::any_of(
    blocks.begin(), blocks.end(), [](const DensityBlock& block) { return block.OnCells; });
  Counts counts;
  for (const DensityBlock& block : blocks)
  {
    this->TakeBlock(block, onCells, counts);
    if (this->Tetrahedra.size() > std::size_t(std::numeric_limits<std::int32_t>::max() / 8))
    {
      return "has more than 268 million tetrahedra with density: extract a part of it, or resample it to an image";
    }
  }
  return this->Judge(counts);
}

void DensityTetrahedra::FindCenter(const std::vector<DensityBlock>& blocks)
{
  vtkBoundingBox box;
  for (const DensityBlock& block : blocks)
  {
    double bounds[6];
    block.Data->GetBounds(bounds);
    if (std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); }))
    {
      box.AddBounds(bounds);
    }
  }
  if (box.IsValid())
  {
    box.GetCenter(this->Center);
  }
}

void DensityTetrahedra::TakeBlock(const DensityBlock& block, bool onCells, Counts& counts)
{
  DensityWalker walker(block);
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(block.Data->GetNumberOfPoints()), -1);
  const auto densityAt = [&](vtkIdType id) {
    const double density = block.Densities->GetComponent(id, 0);
    return IsDensity(density) ? static_cast<float>(density) : 0.0f;
  };
  const auto numberOf = [&](vtkIdType id) {
    std::int32_t& number = numbers[static_cast<std::size_t>(id)];
    if (number < 0)
    {
      double x[3];
      block.Data->GetPoint(id, x);
      number = static_cast<std::int32_t>(this->Points.size());
      this->Points.push_back({ { float(x[0] - this->Center[0]), float(x[1] - this->Center[1]),
        float(x[2] - this->Center[2]), block.OnCells ? 0.0f : densityAt(id) } });
    }
    return number;
  };
  for (vtkIdType tuple = 0; tuple < block.Densities->GetNumberOfTuples(); ++tuple)
  {
    const double density = block.Densities->GetComponent(tuple, 0);
    counts.Wrong += std::isfinite(density) && !IsDensity(density);
  }
  for (vtkIdType cell = 0; cell < block.Data->GetNumberOfCells(); ++cell)
  {
    const DensityWalker::Kind kind = walker.Look(cell);
    counts.NotFinite += kind == DensityWalker::Kind::NotFinite;
    counts.Solid += kind == DensityWalker::Kind::Empty;
    if (kind != DensityWalker::Kind::Cloud)
    {
      continue;
    }
    const bool isSolid =
      walker.GetSource().EmitTetrahedra(cell, [&](const std::array<vtkIdType, 4>& ids) {
        Corners corners;
        std::transform(ids.begin(), ids.end(), corners.begin(), numberOf);
        const auto& p = this->Points;
        const double density = block.OnCells
          ? densityAt(cell)
          : 0.25 * (p[corners[0]][3] + p[corners[1]][3] + p[corners[2]][3] + p[corners[3]][3]);
        this->Add(corners, density, onCells, counts);
      });
    counts.Solid += isSolid;
    counts.NotConvex += isSolid && !walker.GetSource().TetrahedraFillCell();
  }
}

void DensityTetrahedra::Add(Corners corners, double density, bool onCells, Counts& counts)
{
  const auto& p = this->Points;
  const double volume = SixVolumes(p[corners[0]], p[corners[1]], p[corners[2]], p[corners[3]]);
  if (!(volume > 0) || !(density > 0))
  {
    return;
  }
  std::sort(corners.begin(), corners.end(), [&](std::int32_t a, std::int32_t b) {
    return std::make_tuple(p[a][0], p[a][1], p[a][2]) < std::make_tuple(p[b][0], p[b][1], p[b][2]);
  });
  this->Tetrahedra.push_back(corners);
  counts.Volume += volume;
  counts.Mass += volume * density;
  if (onCells)
  {
    this->CellDensities.push_back(static_cast<float>(density));
  }
}

std::string DensityTetrahedra::Judge(const Counts& counts)
{
  if (counts.Solid == 0 && counts.NotFinite == 0)
  {
    return "has no three-dimensional cells";
  }
  this->MeanDensity = counts.Mass > 0 ? counts.Mass / counts.Volume : 1;
  this->MeanBoxVolume =
    this->Tetrahedra.empty() ? 0 : counts.Volume / static_cast<double>(this->Tetrahedra.size());
  const auto tell = [this](std::size_t count, const char* what) {
    this->Warning +=
      count == 0 ? "" : (this->Warning.empty() ? "has " : "; has ") + std::to_string(count) + what;
  };
  tell(counts.Wrong, " values that are not a density, >= 0 and finite: they count as 0");
  tell(counts.NotFinite,
    " cells with a coordinate or a density that is not finite: they are left out");
  tell(counts.NotConvex,
    " polyhedra that are not convex, where density is wrong: run vtkPolyhedronToTetrahedra first");
  return std::string();
}

} // namespace nephoscope
