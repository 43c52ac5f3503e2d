// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatOwners.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nephoscope
{
namespace
{
std::vector<vtkBoundingBox> boundsOfRanks(
  vtkMultiProcessController* controller, const std::vector<Vector3>& places)
{
  vtkBoundingBox box;
  for (const Vector3& place : places)
  {
    box.AddPoint(place[0], place[1], place[2]);
  }
  double mine[6];
  box.GetBounds(mine);
  std::vector<double> all(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(mine, all.data(), 6);
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t i = 0; i < all.size(); i += 6)
  {
    boxes.emplace_back(&all[i]);
  }
  return boxes;
}

// A rounded place and the rank that has it.
using PlaceOnRank = std::pair<Vector3, int>;

// Sorted places of other ranks that may be ours too.
std::vector<PlaceOnRank> placesOfOtherRanks(
  vtkMultiProcessController* controller, const std::vector<Vector3>& shared)
{
  const auto ranks = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const vtkIdType length = 3 * static_cast<vtkIdType>(shared.size());
  std::vector<vtkIdType> lengths(ranks), offsets(ranks + 1, 0);
  controller->AllGather(&length, lengths.data(), 1);
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    offsets[rank + 1] = offsets[rank] + lengths[rank];
  }
  std::vector<double> mine, all(static_cast<std::size_t>(offsets[ranks]) + 1);
  mine.reserve(static_cast<std::size_t>(length) + 1);
  for (const Vector3& place : shared)
  {
    mine.insert(mine.end(), place.begin(), place.end());
  }
  controller->AllGatherV(mine.data(), all.data(), length, lengths.data(), offsets.data());
  std::vector<PlaceOnRank> others;
  for (int rank = 0; rank < static_cast<int>(ranks); ++rank)
  {
    const auto at = static_cast<std::size_t>(rank);
    for (auto i = static_cast<std::size_t>(offsets[at]);
         rank != controller->GetLocalProcessId() && i < static_cast<std::size_t>(offsets[at + 1]);
         i += 3)
    {
      others.push_back({ { { all[i], all[i + 1], all[i + 2] } }, rank });
    }
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return others;
}

// Places rounded, such that ranks that computed one of them in different ways have the same.
class RoundedPlaces
{
public:
  explicit RoundedPlaces(const std::vector<vtkBoundingBox>& boxes)
  {
    vtkBoundingBox all;
    for (const vtkBoundingBox& box : boxes)
    {
      all.AddBox(box);
    }
    const double diagonal = all.IsValid() ? all.GetDiagonalLength() : 0.0;
    this->Step = diagonal > 0.0 ? 1e-12 * diagonal : 1.0;
  }

  Vector3 Round(const Vector3& place) const
  {
    constexpr double offset = 0.382; // so that round numbers are not between two steps
    Vector3 rounded;
    std::transform(place.begin(), place.end(), rounded.begin(),
      [&](double x) { return std::floor(x / this->Step + offset); });
    return rounded;
  }

  double GetStep() const { return this->Step; }

private:
  double Step;
};

bool hasDuplicateCells(vtkDataSet* piece)
{
  vtkUnsignedCharArray* flags = piece ? piece->GetCellGhostArray() : nullptr;
  const unsigned char* begin = flags ? flags->GetPointer(0) : nullptr;
  return flags && std::any_of(begin, begin + flags->GetNumberOfValues(), [](unsigned char flag) {
    return (flag & vtkDataSetAttributes::DUPLICATECELL) != 0;
  });
}

// Marks the points whose cells are all duplicates, and no others; points without cells stay as they are.
void flagAsCells(vtkDataSet* piece, vtkUnsignedCharArray* points)
{
  vtkUnsignedCharArray* flags = piece->GetCellGhostArray();
  const auto count = static_cast<std::size_t>(piece->GetNumberOfPoints());
  std::vector<bool> ofOwn(count, false), ofDuplicates(count, false);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
  {
    const bool duplicate =
      flags && (flags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
    piece->GetCellPoints(cell, corners);
    for (const vtkIdType point : *corners)
    {
      (duplicate ? ofDuplicates : ofOwn)[static_cast<std::size_t>(point)] = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const int flag = points->GetValue(id), duplicate = vtkDataSetAttributes::DUPLICATEPOINT;
    if (ofOwn[i] || ofDuplicates[i])
    {
      points->SetValue(
        id, static_cast<unsigned char>(ofOwn[i] ? flag & ~duplicate : flag | duplicate));
    }
  }
}

// The extent of the points that are no duplicates: without the layers of neighbours.
void leaveOutNeighbors(vtkDataSet* piece, int extent[6])
{
  vtkUnsignedCharArray* ghosts = piece ? piece->GetPointGhostArray() : nullptr;
  if (!ghosts)
  {
    return;
  }
  int own[6] = { VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN };
  vtkIdType id = 0;
  int index[3];
  for (index[2] = extent[4]; index[2] <= extent[5]; ++index[2])
  {
    for (index[1] = extent[2]; index[1] <= extent[3]; ++index[1])
    {
      for (index[0] = extent[0]; index[0] <= extent[1]; ++index[0], ++id)
      {
        for (int axis = 0;
             axis < 3 && !(ghosts->GetValue(id) & vtkDataSetAttributes::DUPLICATEPOINT); ++axis)
        {
          own[2 * axis] = std::min(own[2 * axis], index[axis]);
          own[2 * axis + 1] = std::max(own[2 * axis + 1], index[axis]);
        }
      }
    }
  }
  std::copy_n(own, 6, extent);
}
} // namespace

std::vector<SharedPlace> placesOfSeveralRanks(const std::vector<Vector3>& places)
{
  std::vector<SharedPlace> found;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return found;
  }
  std::vector<vtkBoundingBox> boxes = boundsOfRanks(controller, places);
  const RoundedPlaces rounded(boxes);
  for (vtkBoundingBox& box : boxes)
  {
    box.Inflate(box.IsValid() ? rounded.GetStep() : 0.0);
  }
  std::vector<Vector3> shared;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t rank = 0; rank < boxes.size(); ++rank)
    {
      if (static_cast<int>(rank) != controller->GetLocalProcessId() && boxes[rank].IsValid() &&
        boxes[rank].ContainsPoint(places[i].data()))
      {
        shared.push_back(rounded.Round(places[i]));
        indices.push_back(i);
        break;
      }
    }
  }
  const std::vector<PlaceOnRank> others = placesOfOtherRanks(controller, shared);
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    auto other = std::lower_bound(others.begin(), others.end(), PlaceOnRank{ shared[i], 0 });
    for (; other != others.end() && other->first == shared[i]; ++other)
    {
      found.push_back({ indices[i], other->second });
    }
  }
  return found;
}

std::vector<bool> ownedByThisRank(const std::vector<Vector3>& places)
{
  std::vector<bool> owned(places.size(), true);
  for (const SharedPlace& shared : placesOfSeveralRanks(places))
  {
    const int mine = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
    owned[shared.Index] = owned[shared.Index] && mine < shared.Rank;
  }
  return owned;
}

vtkSmartPointer<vtkDataSet> withPointFlagsOfCells(vtkDataSet* piece)
{
  const int mine = hasDuplicateCells(piece) ? 1 : 0;
  int any = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &mine, &any, 1, vtkCommunicator::MAX_OP);
  vtkUnsignedCharArray* old = piece ? piece->GetPointGhostArray() : nullptr;
  if (any == 0 || !old)
  {
    return piece;
  }
  vtkNew<vtkUnsignedCharArray> flags;
  flags->DeepCopy(old);
  flagAsCells(piece, flags);
  auto copy = vtk::TakeSmartPointer(piece->NewInstance());
  copy->ShallowCopy(piece);
  copy->GetPointData()->AddArray(flags);
  return copy;
}

bool extentOf(vtkDataSet* piece, int extent[6])
{
  if (auto* image = vtkImageData::SafeDownCast(piece))
  {
    image->GetExtent(extent);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(piece))
  {
    rectilinear->GetExtent(extent);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(piece))
  {
    structured->GetExtent(extent);
  }
  else
  {
    return false;
  }
  return true;
}

bool findExtentsOfRanks(vtkDataSet* piece, std::vector<int>& extents)
{
  int mine[7] = { 0, -1, 0, -1, 0, -1, 1 }; // and whether there is nothing but a grid
  if (extentOf(piece, mine))
  {
    leaveOutNeighbors(piece, mine);
  }
  else
  {
    mine[6] = piece && piece->GetNumberOfPoints() > 0 ? 0 : 1;
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const auto ranks = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  std::vector<int> all(7 * ranks);
  controller->AllGather(mine, all.data(), 7);
  extents.clear();
  bool structured = true;
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    extents.insert(extents.end(), &all[7 * rank], &all[7 * rank] + 6);
    structured = structured && all[7 * rank + 6] != 0;
  }
  return structured;
}

int ownerOfPoint(const std::vector<int>& extents, int i, int j, int k)
{
  for (std::size_t at = 0; at < extents.size(); at += 6)
  {
    const int* e = &extents[at];
    if (e[0] <= i && i <= e[1] && e[2] <= j && j <= e[3] && e[4] <= k && k <= e[5])
    {
      return static_cast<int>(at / 6);
    }
  }
  return -1;
}

} // namespace nephoscope
