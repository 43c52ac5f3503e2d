// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSamples.h"

#include "CellMoments.h"
#include "CellShares.h"
#include "CellTaper.h"
#include "HiddenSamples.h"
#include "PointPlaces.h"
#include "SplatNeedles.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nephoscope
{
namespace
{
using Shares = std::vector<CellShare>;

// The square of the shape of a sample, wider where cells taper to an apex, and that of a cell with
// the covariance of the cell.
SplatMatrix Blurred(const CellShares& shares, std::size_t i, SplatMatrix square)
{
  const CellShare& share = shares.Shares[i];
  if (!shares.Tapers.empty())
  {
    const TaperNeed need{ SymmetricMatrix(shares.Tapers[i]), shares.Tapers[i][6] };
    need.Widen(square, share.MeanAngle > 0 ? share.MeanAngle : 1);
  }
  if (shares.Covariances.empty() || share.Dimension < 3)
  {
    return square;
  }
  SplatMatrix sum{};
  AddWeighted(sum, square, blurOfSquare);
  AddWeighted(sum, SymmetricMatrix(shares.Covariances[i]), 1 / varianceOfKernel);
  return sum;
}

// One-sided points take the shape of the others of their cells.
void ShareShapes(vtkDataSet* data, Shares& shares, const std::vector<vtkIdType>& places)
{
  const auto isOneSided = [](const CellShare& share) { return share.IsOneSided(); };
  if (std::none_of(shares.begin(), shares.end(), isOneSided))
  {
    return;
  }
  std::map<vtkIdType, std::pair<SplatMatrix, int>> shapes; // sums
  vtkNew<vtkIdList> points;
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    data->GetCellPoints(id, points);
    for (const vtkIdType first : *points)
    {
      const vtkIdType a = PlaceOfPoint(places, first);
      for (const vtkIdType second : *points)
      {
        const vtkIdType b = PlaceOfPoint(places, second);
        const CellShare& other = shares[static_cast<std::size_t>(b)];
        if (shares[static_cast<std::size_t>(a)].IsOneSided() && other.Dimension == 3 &&
          !other.IsOneSided())
        {
          AddWeighted(shapes[a].first, other.Edges, 1 / other.MeanAngle);
          ++shapes[a].second;
        }
      }
    }
  }
  for (const auto& shape : shapes)
  {
    CellShare& share = shares[static_cast<std::size_t>(shape.first)];
    share.Edges = {};
    AddWeighted(share.Edges, shape.second.first, share.MeanAngle / shape.second.second);
  }
}
}

void CellSamples::Find(vtkDataSet* data, bool onCells)
{
  const std::vector<vtkIdType> places = FindPlaces(data);
  this->Places = onCells ? std::vector<vtkIdType>() : places;
  const std::vector<unsigned char> hidden = FindHiddenCells(data);
  CellShares found = FindCellShares(data, onCells, places, hidden);
  Shares& shares = found.Shares;
  if (!onCells)
  {
    ShareShapes(data, shares, places);
  }
  for (CellShare& share : shares)
  {
    share.Angle = onCells && share.Dimension > 0 ? 1 : share.Angle; // nothing around it counts
  }
  this->FillIn(data, found, onCells);
  if (!this->Shapes.empty())
  {
    WidenNeedles(data, onCells, places, hidden, { this->Shapes, this->Parts, this->OfGrid });
    this->Blur(found);
  }
}

void CellSamples::FillIn(vtkDataSet* data, const CellShares& found, bool onCells)
{
  const Shares& shares = found.Shares;
  this->Shapes.clear();
  this->Parts.clear();
  this->OfGrid.clear();
  const auto hasExtent = [](const CellShare& share) {
    return share.EdgeLength() > 0 && std::isfinite(share.EdgeLength());
  };
  if (std::none_of(shares.begin(), shares.end(), hasExtent))
  {
    return;
  }
  this->Shapes.resize(shares.size(), std::array<float, 9>{});
  this->Parts.resize(shares.size(), 1.0f);
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const CellShare& share = shares[i];
    if (!hasExtent(share))
    {
      const bool isNothing = share.Dimension > 0 && std::isfinite(share.EdgeLength());
      this->Parts[i] = isNothing ? 0.0f : 1.0f;
      continue;
    }
    if (this->FillInAxes(data, found, i))
    {
      this->OfGrid.resize(shares.size(), false);
      this->OfGrid[i] = true;
    }
    else
    {
      this->Parts[i] = static_cast<float>((onCells ? 1.0 : share.Around()) * share.Fill());
      this->SetShape(i, share.Jacobian());
    }
  }
}

// A point whose hexahedra are as in a grid has the shape that it has there.
bool CellSamples::FillInAxes(vtkDataSet* data, const CellShares& found, std::size_t i)
{
  constexpr double likest = 0.5; // the volumes of the axes and of the share
  const auto placeOf = [&](int point) {
    Vector3 x;
    data->GetPoint(point, x.data());
    return x;
  };
  SplatMatrix axes{};
  if (found.Rings.empty() || !found.Rings[i].FindAxes(placeOf(static_cast<int>(i)), placeOf, axes))
  {
    return false;
  }
  const CellShare& share = found.Shares[i];
  const double spanned = std::abs(Determinant(axes)), size = std::pow(share.EdgeLength(), 3);
  if (!(size > likest * spanned && spanned > likest * size))
  {
    return false;
  }
  // A first number that is 0 is none.
  std::iter_swap(axes.begin(),
    std::max_element(axes.begin(), axes.end(),
      [](const Vector3& a, const Vector3& b) { return std::abs(a[0]) < std::abs(b[0]); }));
  this->Parts[i] = static_cast<float>(share.Around() * size / spanned);
  this->SetShape(i, axes);
  return true;
}

void CellSamples::SetShape(std::size_t i, const SplatMatrix& jacobian)
{
  for (std::size_t c = 0; c < 9; ++c)
  {
    this->Shapes[i][c] = static_cast<float>(jacobian[c / 3][c % 3]);
  }
}

void CellSamples::Blur(const CellShares& found)
{
  if (found.Covariances.empty() && found.Tapers.empty())
  {
    return;
  }
  for (std::size_t i = 0; i < this->Shapes.size(); ++i)
  {
    const SplatMatrix before = MatrixOfShape(this->Shapes[i]);
    const SplatMatrix after = TriangularRoot(Blurred(found, i, SquareOfShape(this->Shapes[i])));
    const double volume = Determinant(after);
    if (before[0][0] != 0 && volume > 0 && std::isfinite(volume))
    {
      this->Parts[i] *= static_cast<float>(std::abs(Determinant(before)) / volume);
      this->SetShape(i, after);
    }
  }
}

bool CellSamples::Get(vtkIdType id, SplatMatrix& jacobian) const
{
  const auto i = static_cast<std::size_t>(id);
  if (this->Shapes.empty() || this->Shapes[i][0] == 0)
  {
    return false;
  }
  jacobian = MatrixOfShape(this->Shapes[i]);
  return true;
}

} // namespace nephoscope
