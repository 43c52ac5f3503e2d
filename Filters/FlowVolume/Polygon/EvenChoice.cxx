// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EvenChoice.h"

#include "DataSets.h"
#include "FlowVolumeExchange.h"

#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace nephoscope
{
namespace
{
using Extent = std::array<int, 6>;
using NumberedMiddle = std::array<double, 4>; // a number, by which they are sorted, and the place

// The middle of the corners; false for a cell without corners, or with infinite coordinates.
bool MiddleOf(vtkDataSet* set, vtkIdType cell, vtkIdList* corners, double* middle)
{
  set->GetCellPoints(cell, corners);
  const auto count = static_cast<double>(corners->GetNumberOfIds());
  std::fill_n(middle, 3, 0.0);
  for (vtkIdType c = 0; c < corners->GetNumberOfIds(); ++c)
  {
    double x[3];
    set->GetPoint(corners->GetId(c), x);
    for (int k = 0; k < 3; ++k)
    {
      middle[k] += x[k] / count;
    }
  }
  return count > 0.0 && std::isfinite(middle[0]) && std::isfinite(middle[1]) &&
    std::isfinite(middle[2]);
}

int CellsAlong(const Extent& extent, std::size_t axis)
{
  return std::max(1, extent[2 * axis + 1] - extent[2 * axis]);
}

std::size_t CellsIn(const Extent& extent)
{
  std::size_t cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cells *= static_cast<std::size_t>(CellsAlong(extent, axis));
  }
  return cells;
}

// The number in a part of the cell that has `number` in the whole; -1 if it is not there.
vtkIdType NumberInPart(const Extent& whole, const Extent& part, std::size_t number)
{
  vtkIdType inPart = 0, stride = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto along = static_cast<std::size_t>(CellsAlong(whole, axis));
    const int i = static_cast<int>(number % along) + whole[2 * axis] - part[2 * axis];
    number /= along;
    if (i < 0 || i >= CellsAlong(part, axis))
    {
      return -1;
    }
    inPart += i * stride;
    stride *= CellsAlong(part, axis);
  }
  return inPart;
}

// Every n-th cell of the whole extent, as far as it is here.
std::vector<NumberedMiddle> EveryNth(
  vtkDataSet* set, const Extent& part, const Extent& whole, std::size_t most)
{
  const auto cells = static_cast<double>(CellsIn(whole));
  const double stride = std::max(1.0, cells / static_cast<double>(most));
  std::vector<NumberedMiddle> middles;
  vtkNew<vtkIdList> corners;
  for (double i = 0.5 * (stride - 1.0); set && i < cells; i += stride)
  {
    const vtkIdType cell = NumberInPart(whole, part, static_cast<std::size_t>(i));
    NumberedMiddle middle = { std::floor(i) };
    if (cell >= 0 && MiddleOf(set, cell, corners, &middle[1]))
    {
      middles.push_back(middle);
    }
  }
  return middles;
}

// Hash of a position, rounded so that rounding errors do not change it: 53 bits.
double HashOf(const double* place, const vtkBoundingBox& box)
{
  constexpr double cells = 1048576.0,
                   shift = 0.381966; // regular places are not at the borders of cells
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double share =
      (place[k] - box.GetMinPoint()[k]) / std::max(box.GetDiagonalLength(), 1e-300);
    hash += static_cast<std::uint64_t>(cells * share + shift) + 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return static_cast<double>(hash >> 11);
}

void KeepSmallest(std::vector<NumberedMiddle>& middles, std::size_t most)
{
  std::sort(middles.begin(), middles.end());
  middles.erase(
    std::unique(middles.begin(), middles.end()), middles.end()); // cells and their ghosts
  middles.resize(std::min(middles.size(), most));
}

std::vector<NumberedMiddle> SmallestHashes(
  const std::vector<vtkDataSet*>& sets, const vtkBoundingBox& box, std::size_t most)
{
  std::vector<NumberedMiddle> middles;
  vtkNew<vtkIdList> corners;
  for (vtkDataSet* set : sets)
  {
    for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
    {
      NumberedMiddle middle{};
      if (MiddleOf(set, cell, corners, &middle[1]))
      {
        middle[0] = HashOf(&middle[1], box);
        middles.push_back(middle);
      }
      if (middles.size() > 16 * most)
      {
        KeepSmallest(middles, most);
      }
    }
  }
  KeepSmallest(middles, most);
  return middles;
}

// The middles of all ranks, in the order of their numbers.
std::vector<NumberedMiddle> Gathered(
  const std::vector<NumberedMiddle>& mine, const FlowVolumeExchange& exchange)
{
  std::vector<double> flat;
  for (const NumberedMiddle& middle : mine)
  {
    flat.insert(flat.end(), middle.begin(), middle.end());
  }
  flat = exchange.Gather(flat);
  std::vector<NumberedMiddle> all(flat.size() / 4);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::copy_n(flat.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, all[i].begin());
  }
  return all;
}

bool HasExtent(vtkDataObject* data)
{
  return data && data->GetExtentType() == VTK_3D_EXTENT &&
    data->GetInformation()->Has(vtkDataObject::DATA_EXTENT());
}

// The extents of all ranks in one.
Extent WholeExtent(const Extent* part, const FlowVolumeExchange& exchange)
{
  const auto all =
    exchange.Gather(part ? std::vector<double>(part->begin(), part->end()) : std::vector<double>());
  Extent whole;
  for (std::size_t k = 0; k < 6; ++k)
  {
    whole[k] = static_cast<int>(all[k]);
    for (std::size_t i = k; i < all.size(); i += 6)
    {
      whole[k] = k % 2 ? std::max(whole[k], static_cast<int>(all[i]))
                       : std::min(whole[k], static_cast<int>(all[i]));
    }
  }
  return whole;
}
}

std::vector<Vector3> EvenlyChosenMiddles(vtkDataObject* data, const vtkBoundingBox& box,
  std::size_t most, const FlowVolumeExchange& exchange)
{
  const auto sets = DataSetsOf(data);
  std::vector<NumberedMiddle> middles;
  if (exchange.AllTrue(sets.empty() || HasExtent(data)))
  {
    Extent part{};
    vtkDataSet* set = sets.empty() ? nullptr : sets.front();
    if (set)
    {
      std::copy_n(data->GetInformation()->Get(vtkDataObject::DATA_EXTENT()), 6, part.begin());
    }
    middles =
      Gathered(EveryNth(set, part, WholeExtent(set ? &part : nullptr, exchange), most), exchange);
    KeepSmallest(middles, middles.size());
  }
  else
  {
    middles = Gathered(SmallestHashes(sets, box, most), exchange);
    KeepSmallest(middles, most);
  }
  std::vector<Vector3> places;
  for (const NumberedMiddle& middle : middles)
  {
    places.push_back({ { middle[1], middle[2], middle[3] } });
  }
  return places;
}
}
