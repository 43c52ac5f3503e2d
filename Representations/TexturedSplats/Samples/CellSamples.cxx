// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSamples.h"

#include "CellShares.h"
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

// One-sided points take the shape of the others of their cells.
void shareShapes(vtkDataSet* data, Shares& shares, const std::vector<vtkIdType>& places)
{
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
  Shares shares = FindCellShares(data, onCells, places, hidden);
  if (!onCells)
  {
    shareShapes(data, shares, places);
  }
  for (CellShare& share : shares)
  {
    share.Angle = onCells && share.Dimension > 0 ? 1 : share.Angle; // nothing around it counts
  }
  this->FillIn(shares, onCells);
  if (!this->Shapes.empty())
  {
    WidenNeedles(data, onCells, places, hidden, { this->Shapes, this->Parts });
  }
}

void CellSamples::FillIn(const Shares& shares, bool onCells)
{
  this->Shapes.clear();
  this->Parts.clear();
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
    this->Parts[i] = static_cast<float>((onCells ? 1.0 : share.Around()) * share.Fill());
    const SplatMatrix jacobian = share.Jacobian();
    for (std::size_t c = 0; c < 9; ++c)
    {
      this->Shapes[i][c] = static_cast<float>(jacobian[c / 3][c % 3]);
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
  for (std::size_t c = 0; c < 9; ++c)
  {
    jacobian[c / 3][c % 3] = this->Shapes[i][c];
  }
  return true;
}

Vector3 CenterOfCell(vtkDataSet* data, vtkIdType id)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(id, corners);
  std::vector<Vector3> places;
  for (const vtkIdType corner : *corners)
  {
    Vector3 x;
    data->GetPoint(corner, x.data());
    if (std::find(places.begin(), places.end(), x) == places.end())
    {
      places.push_back(x);
    }
  }
  Vector3 sum{};
  for (const Vector3& x : places)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sum[c] += x[c] / static_cast<double>(places.size());
    }
  }
  return sum;
}

} // namespace nephoscope
