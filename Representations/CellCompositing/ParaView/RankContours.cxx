// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankContours.h"

#include "DataBlocks.h"
#include "PieceGradients.h"
#include "RankMeasures.h"
#include "VolumetricCells.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>

namespace nephoscope
{
namespace
{
using SumsAtPlace = PieceGradients::SumsAtPlace;
constexpr std::size_t numbersPerPlace = 12;
static_assert(sizeof(SumsAtPlace) == numbersPerPlace * sizeof(double), "sent as numbers");

bool holdsOnAll(vtkMultiProcessController* controller, bool mine)
{
  int own = mine ? 1 : 0, all = 0;
  controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  return all != 0;
}

std::vector<vtkBoundingBox> boxesOfPieces(vtkMultiProcessController* controller, vtkDataSet* piece)
{
  double mine[6];
  vtkBoundingBox().GetBounds(mine);
  if (piece->GetNumberOfCells() > 0)
  {
    piece->GetBounds(mine);
  }
  std::vector<double> all(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(mine, all.data(), 6);
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t first = 0; first < all.size(); first += 6)
  {
    boxes.emplace_back(&all[first]);
  }
  return boxes;
}

void findCenter(const std::vector<vtkBoundingBox>& boxes, double center[3])
{
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : boxes)
  {
    all.AddBox(box);
  }
  if (all.IsValid())
  {
    all.GetCenter(center);
  }
}

// Boxes of images touch in few points; others may lie anywhere.
std::vector<vtkIdType> outerPoints(vtkDataSet* piece)
{
  if (auto* cells = vtkUnstructuredGrid::SafeDownCast(piece))
  {
    return pointsOfSurface(cells);
  }
  std::vector<vtkIdType> all(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void exchange(vtkMultiProcessController* controller, PieceGradients& gradients)
{
  const std::vector<SumsAtPlace> mine = gradients.Send();
  const int self = controller->GetLocalProcessId();
  for (int rank = 0; rank < controller->GetNumberOfProcesses(); ++rank)
  {
    std::vector<SumsAtPlace> sent = rank == self ? mine : std::vector<SumsAtPlace>();
    auto count = static_cast<vtkIdType>(sent.size());
    controller->Broadcast(&count, 1, rank);
    sent.resize(static_cast<std::size_t>(count));
    controller->Broadcast(reinterpret_cast<double*>(sent.data()),
      count * static_cast<vtkIdType>(numbersPerPlace), rank);
    if (rank != self)
    {
      gradients.Add(sent);
    }
  }
}
}

void storeRankContours(vtkDataSet* piece, const char* arrayName, bool ofMagnitude, bool gradients)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  vtkDataArray* array = arrayName ? piece->GetPointData()->GetArray(arrayName) : nullptr;
  array = array && (ofMagnitude || array->GetNumberOfComponents() == 1) ? array : nullptr;
  if (!holdsOnAll(controller, array || piece->GetNumberOfCells() == 0))
  {
    return;
  }
  double range[2] = { 1, 0 };
  if (array)
  {
    array->GetFiniteRange(range, array->GetNumberOfComponents() == 1 ? 0 : -1);
  }
  reduceRange(range);
  storeNumbers(piece, storedContourRangeName, { range[0], range[1] });
  if (gradients)
  {
    const std::vector<vtkBoundingBox> boxes = boxesOfPieces(controller, piece);
    double center[3] = { 0, 0, 0 };
    findCenter(boxes, center);
    PieceGradients found(piece, array, range, center);
    std::vector<vtkBoundingBox> others = boxes;
    others.erase(others.begin() + controller->GetLocalProcessId());
    found.FindShared(outerPoints(piece), others);
    exchange(controller, found);
    piece->GetPointData()->AddArray(found.Solve());
  }
}

} // namespace nephoscope
