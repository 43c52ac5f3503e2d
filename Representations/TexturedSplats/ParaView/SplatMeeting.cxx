// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatMeeting.h"

#include "RankExchange.h"
#include "SplatPieces.h"
#include "SplatShapes.h"
#include "SplatVectorBounds.h"

#include "vtkAppendFilter.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr int exchangeTag = 5208;
constexpr double infinity = std::numeric_limits<double>::infinity();

vtkMultiProcessController* World()
{
  return vtkMultiProcessController::GetGlobalController();
}

SplatShapes ShapesOf(vtkDataSet* vertices)
{
  return SplatShapes(vertices, { true, 1.0, splatShapeName }); // the size is not used
}

bool FillsBox(const std::vector<vtkBoundingBox>& boxes, const vtkBoundingBox& all)
{
  double lengths[3];
  all.GetLengths(lengths);
  // A flat axis, of which nobody has a share, counts as 1.
  const auto share = [&](const vtkBoundingBox& box) {
    double product = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      product *= lengths[axis] > 0 ? box.GetLength(axis) / lengths[axis] : 1;
    }
    return product;
  };
  const auto overlap = [&](const vtkBoundingBox& a, const vtkBoundingBox& b) {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double from = std::max(a.GetBound(2 * axis), b.GetBound(2 * axis));
      const double to = std::min(a.GetBound(2 * axis + 1), b.GetBound(2 * axis + 1));
      if (lengths[axis] > 0 && to <= from)
      {
        return false;
      }
    }
    return true;
  };
  double sum = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    sum += boxes[i].IsValid() ? share(boxes[i]) : 0;
    for (std::size_t j = 0; j < i; ++j)
    {
      if (boxes[i].IsValid() && boxes[j].IsValid() && overlap(boxes[i], boxes[j]))
      {
        return false;
      }
    }
  }
  return std::abs(sum - 1) < 1e-9;
}

double ReachOf(const SplatReaches& reaches, double stretch)
{
  const double kernel = reaches.KernelRadius * stretch;
  return SplatReachAround(reaches.Vectors
      ? std::max(kernel, VectorReach(reaches.Look, reaches.KernelRadius, stretch))
      : kernel);
}

// For every rank, which of this rank's vertices reach into its region.
std::vector<vtkSmartPointer<vtkIdList>> IdsForRanks(
  vtkDataSet* vertices, const std::vector<SplatRegion>& regions, const SplatReaches& reaches)
{
  std::vector<vtkSmartPointer<vtkIdList>> ids(regions.size());
  std::generate(ids.begin(), ids.end(), []() { return vtkSmartPointer<vtkIdList>::New(); });
  const SplatShapes shapes = ShapesOf(vertices);
  const auto mine = static_cast<std::size_t>(World()->GetLocalProcessId());
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    const Vector3 place = shapes.Place(id);
    const double reach =
      ReachOf(reaches, reaches.RadiusFactor * LargestStretch(shapes.Jacobian(id)));
    for (std::size_t rank = 0; rank < regions.size(); ++rank)
    {
      if (rank != mine && IsRegion(regions[rank]) && Touches(regions[rank], place.data(), reach))
      {
        ids[rank]->InsertNextId(id);
      }
    }
  }
  return ids;
}

void Mark(vtkDataSet* vertices, unsigned char ghost)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(vertices->GetNumberOfCells());
  ghosts->FillValue(ghost);
  vertices->GetCellData()->AddArray(ghosts);
}

std::vector<vtkSmartPointer<vtkDataObject>> TradeWithRanks(
  vtkDataSet* vertices, const std::vector<vtkSmartPointer<vtkIdList>>& ids)
{
  const int ranks = World()->GetNumberOfProcesses();
  const int mine = World()->GetLocalProcessId();
  std::vector<vtkIdType> counts, all(ids.size() * ids.size()); // from row to column
  for (const auto& list : ids)
  {
    counts.push_back(list->GetNumberOfIds());
  }
  World()->AllGather(counts.data(), all.data(), ranks);
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  const auto send = [&](int rank) {
    vtkIdList* list = ids[static_cast<std::size_t>(rank)];
    if (list->GetNumberOfIds() > 0)
    {
      World()->Send(ChosenVertices(vertices, list), rank, exchangeTag);
    }
  };
  const auto receive = [&](int rank) {
    if (all[static_cast<std::size_t>(rank * ranks + mine)] > 0)
    {
      received.push_back(
        vtkSmartPointer<vtkDataObject>::Take(World()->ReceiveDataObject(rank, exchangeTag)));
    }
  };
  MeetOtherRanks(World(), send, receive);
  return received;
}
} // namespace

SpeedCounts SpeedsOfRanks(const SpeedCounts& mine)
{
  const std::vector<double> counts = mine.GetCounts();
  std::vector<double> sums(counts.size());
  const double local = mine.GetGreatest();
  double greatest = 0;
  World()->AllReduce(
    counts.data(), sums.data(), static_cast<vtkIdType>(counts.size()), vtkCommunicator::SUM_OP);
  World()->AllReduce(&local, &greatest, 1, vtkCommunicator::MAX_OP);
  SpeedCounts all;
  all.Set(sums, greatest);
  return all;
}

SplatCommons FindSplatCommons(vtkDataSet* vertices, const std::string& vectors)
{
  const SplatShapes shapes = ShapesOf(vertices);
  vtkBoundingBox mine, all;
  double longest = 0;
  for (vtkIdType id = 0; id < shapes.GetNumberOfIds(); ++id)
  {
    mine.AddPoint(shapes.Place(id).data());
    longest = std::max(longest, LargestStretch(shapes.Jacobian(id)));
  }
  const VectorSums sums = SumVectors(
    shapes, vectors.empty() ? nullptr : vertices->GetCellData()->GetArray(vectors.c_str()));
  const double local[2] = { longest, static_cast<double>(shapes.GetNumberOfIds()) };
  const double localSums[2] = { sums.Cells, sums.Count };
  double greatest[2], sum[2];
  World()->AllReduce(mine, all);
  World()->AllReduce(local, greatest, 2, vtkCommunicator::MAX_OP);
  World()->AllReduce(localSums, sum, 2, vtkCommunicator::SUM_OP);
  SplatCommons commons;
  if (all.IsValid())
  {
    all.GetCenter(commons.Origin);
  }
  commons.LongestEdge = greatest[0];
  commons.MaximumSpeed = SpeedsOfRanks(sums.Speeds).GetFull();
  commons.MostSamples = static_cast<vtkIdType>(greatest[1]);
  commons.MeanCell = sum[1] > 0 && sum[0] > 0 ? sum[0] / sum[1] : 1.0;
  return commons;
}

std::vector<SplatRegion> RegionsOfRanks(const std::vector<vtkBoundingBox>& boxes)
{
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : boxes)
  {
    all.AddBox(box);
  }
  std::vector<SplatRegion> regions;
  if (boxes.size() < 2 || !all.IsValid() || !FillsBox(boxes, all))
  {
    return regions;
  }
  for (const vtkBoundingBox& box : boxes)
  {
    SplatRegion region = WholeSpace; // a rank without a share
    for (std::size_t i = 0; i < 6 && box.IsValid(); ++i)
    {
      const double bound = box.GetBound(static_cast<int>(i));
      const bool outside = bound == all.GetBound(static_cast<int>(i));
      region[i] = !outside ? bound : i % 2 ? infinity : -infinity;
    }
    regions.push_back(region);
  }
  return regions;
}

vtkSmartPointer<vtkDataSet> WithNeighbors(
  vtkDataSet* vertices, const std::vector<SplatRegion>& regions, const SplatReaches& reaches)
{
  const auto received = TradeWithRanks(vertices, IdsForRanks(vertices, regions, reaches));
  vtkNew<vtkUnstructuredGrid> own;
  own->ShallowCopy(vertices);
  Mark(own, 0);
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(own);
  for (const auto& object : received)
  {
    vtkDataSet* foreign = vtkDataSet::SafeDownCast(object);
    Mark(foreign, vtkDataSetAttributes::DUPLICATECELL);
    append->AddInputData(foreign);
  }
  append->Update();
  vtkSmartPointer<vtkDataSet> all = append->GetOutput();
  // A rank without samples of its own has no measures of the data either, which are the same
  // everywhere.
  const bool empty = vertices->GetNumberOfCells() == 0 && !received.empty();
  all->GetFieldData()->ShallowCopy((empty ? received.front().Get() : vertices)->GetFieldData());
  return all;
}

} // namespace nephoscope
