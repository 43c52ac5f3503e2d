// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatOwners.h"

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

namespace nephoscope
{
namespace
{
bool HasDuplicateCells(vtkDataSet* piece)
{
  vtkUnsignedCharArray* flags = piece ? piece->GetCellGhostArray() : nullptr;
  const unsigned char* begin = flags ? flags->GetPointer(0) : nullptr;
  return flags && std::any_of(begin, begin + flags->GetNumberOfValues(), [](unsigned char flag) {
    return (flag & vtkDataSetAttributes::DUPLICATECELL) != 0;
  });
}

// Marks the points whose cells are all duplicates, and no others; points without cells stay as they
// are.
void FlagAsCells(vtkDataSet* piece, vtkUnsignedCharArray* points)
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
void LeaveOutNeighbors(vtkDataSet* piece, int extent[6])
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

std::vector<bool> OwnedByThisRank(const std::vector<Vector3>& places)
{
  std::vector<bool> owned(places.size(), true);
  for (const SharedPlace& shared : PlacesOfSeveralRanks(places))
  {
    const int mine = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
    owned[shared.Index] = owned[shared.Index] && mine < shared.Rank;
  }
  return owned;
}

vtkSmartPointer<vtkDataSet> WithPointFlagsOfCells(vtkDataSet* piece)
{
  const int mine = HasDuplicateCells(piece) ? 1 : 0;
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
  FlagAsCells(piece, flags);
  auto copy = vtk::TakeSmartPointer(piece->NewInstance());
  copy->ShallowCopy(piece);
  copy->GetPointData()->AddArray(flags);
  return copy;
}

bool ExtentOf(vtkDataSet* piece, int extent[6])
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

bool FindExtentsOfRanks(vtkDataSet* piece, std::vector<int>& extents)
{
  int mine[7] = { 0, -1, 0, -1, 0, -1, 1 }; // and whether there is nothing but a grid
  if (ExtentOf(piece, mine))
  {
    LeaveOutNeighbors(piece, mine);
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

int OwnerOfPoint(const std::vector<int>& extents, int i, int j, int k)
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
