// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EvenChoice.h"

#include "DataSets.h"
#include "FlowVolumeExchange.h"
#include "OwnThreads.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace nephoscope
{
namespace
{
using NumberedMiddle = std::array<double, 4>; // a number, by which they are sorted, and the place

// That of a cell of an image, which takes a tenth of the time.
void MiddleInImage(vtkImageData* image, vtkIdType cell, double* middle)
{
  const int* extent = image->GetExtent();
  double index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = extent[2 * axis + 1] - extent[2 * axis];
    const vtkIdType along = std::max(1, cells);
    index[axis] = extent[2 * axis] + static_cast<double>(cell % along) + (cells > 0 ? 0.5 : 0.0);
    cell /= along;
  }
  image->TransformContinuousIndexToPhysicalPoint(index, middle);
}

// The middle of the corners; false for a cell without corners, or with infinite coordinates.
bool MiddleOf(vtkDataSet* set, vtkIdType cell, vtkIdList* corners, double* middle)
{
  const int type = set->GetDataObjectType();
  if (type == VTK_IMAGE_DATA || type == VTK_UNIFORM_GRID)
  {
    MiddleInImage(static_cast<vtkImageData*>(set), cell, middle);
    return true;
  }
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

// Hash of a position, rounded so that rounding errors do not change it, nor points that are stored
// as float in one kind of data and follow from the spacing in another: 53 bits.
double HashOf(const double* place, const vtkBoundingBox& box)
{
  constexpr double cells = 65536.0,
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

// Adds those of a part of the cells of a set.
void AddMiddles(vtkDataSet* set, vtkIdType begin, vtkIdType end, const vtkBoundingBox& box,
  std::size_t most, std::vector<NumberedMiddle>& middles)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    NumberedMiddle middle{};
    if (MiddleOf(set, cell, corners, &middle[1]))
    {
      middle[0] = HashOf(&middle[1], box);
      middles.push_back(middle);
    }
  }
  if (middles.size() > 16 * most)
  {
    KeepSmallest(middles, most);
  }
}

std::vector<NumberedMiddle> SmallestHashes(
  const std::vector<vtkDataSet*>& sets, const vtkBoundingBox& box, std::size_t most)
{
  constexpr vtkIdType grain = 8192;
  std::vector<NumberedMiddle> middles;
  WithThreads([&]() {
    vtkSMPThreadLocal<std::vector<NumberedMiddle>> parts;
    for (vtkDataSet* set : sets)
    {
      AddMiddles(set, 0, std::min<vtkIdType>(1, set->GetNumberOfCells()), box, most,
        parts.Local()); // so that calls from threads find the set prepared
      vtkSMPTools::For(1, std::max<vtkIdType>(1, set->GetNumberOfCells()), grain,
        [&](vtkIdType begin, vtkIdType end) {
          AddMiddles(set, begin, end, box, most, parts.Local());
        });
    }
    for (const std::vector<NumberedMiddle>& part : parts)
    {
      middles.insert(middles.end(), part.begin(), part.end());
    }
  });
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
}

std::vector<Vector3> EvenlyChosenMiddles(vtkDataObject* data, const vtkBoundingBox& box,
  std::size_t most, const FlowVolumeExchange& exchange)
{
  const auto sets = DataSetsOf(data);
  auto middles = Gathered(SmallestHashes(sets, box, most), exchange);
  KeepSmallest(middles, most);
  std::vector<Vector3> places;
  for (const NumberedMiddle& middle : middles)
  {
    places.push_back({ { middle[1], middle[2], middle[3] } });
  }
  return places;
}
}
