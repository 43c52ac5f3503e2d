// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankContours.h"

#include "DataBlocks.h"
#include "PieceGradients.h"
#include "RankExchange.h"
#include "RankMeasures.h"
#include "RankPlaces.h"
#include "VolumetricCells.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace nephoscope
{
namespace
{
/** What ranks send each other: a place as both have it, and sums. */
struct SumsAtPlace
{
  Vector3 Where;
  GradientSums Sums;
};

bool HoldsOnAll(vtkMultiProcessController* controller, bool mine)
{
  int own = mine ? 1 : 0, all = 0;
  controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  return all != 0;
}

void FindCenter(vtkMultiProcessController* controller, vtkDataSet* piece, double center[3])
{
  vtkBoundingBox mine, all;
  if (piece->GetNumberOfCells() > 0)
  {
    mine.SetBounds(piece->GetBounds());
  }
  controller->AllReduce(mine, all);
  if (all.IsValid())
  {
    all.GetCenter(center);
  }
}

// The places at which cells of other pieces may be.
std::vector<vtkIdType> OuterPlaces(vtkDataSet* piece, const PieceGradients& gradients)
{
  std::vector<vtkIdType> places(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  std::iota(places.begin(), places.end(), 0);
  if (auto* cells = vtkUnstructuredGrid::SafeDownCast(piece))
  {
    places = PointsOfSurface(cells);
  }
  std::transform(places.begin(), places.end(), places.begin(),
    [&](vtkIdType point) { return gradients.PlaceOf(point); });
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

// Adds the sums of the other ranks at the places that this one has too.
void AddThoseOfOthers(
  vtkMultiProcessController* controller, vtkDataSet* piece, PieceGradients& gradients)
{
  const std::vector<vtkIdType> outer = OuterPlaces(piece, gradients);
  std::vector<Vector3> positions(outer.size());
  for (std::size_t i = 0; i < outer.size(); ++i)
  {
    piece->GetPoint(outer[i], positions[i].data());
  }
  std::vector<std::vector<SumsAtPlace>> own(
    static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  std::map<Vector3, vtkIdType> places;
  for (const SharedPlace& shared : PlacesOfSeveralRanks(positions))
  {
    const vtkIdType place = outer[shared.Index];
    places[shared.Rounded] = place;
    own[static_cast<std::size_t>(shared.Rank)].push_back(
      { shared.Rounded, gradients.SumsAt(place) });
  }
  for (const auto& others : TradeRecords(controller, own))
  {
    for (const SumsAtPlace& other : others)
    {
      const auto place = places.find(other.Where);
      if (place != places.end())
      {
        gradients.SumsAt(place->second).Add(other.Sums);
      }
    }
  }
}
}

void StoreRankContours(vtkDataSet* piece, const char* arrayName, bool ofMagnitude, bool gradients)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  vtkDataArray* array = arrayName ? piece->GetPointData()->GetArray(arrayName) : nullptr;
  array = array && (ofMagnitude || array->GetNumberOfComponents() == 1) ? array : nullptr;
  if (!HoldsOnAll(controller, array || piece->GetNumberOfCells() == 0))
  {
    return;
  }
  double range[2] = { 1, 0 };
  if (array)
  {
    array->GetFiniteRange(range, array->GetNumberOfComponents() == 1 ? 0 : -1);
  }
  ReduceRange(range);
  StoreNumbers(piece, storedContourRangeName, { range[0], range[1] });
  if (gradients)
  {
    double center[3] = { 0, 0, 0 };
    FindCenter(controller, piece, center);
    PieceGradients found(piece, array, range, center);
    AddThoseOfOthers(controller, piece, found);
    piece->GetPointData()->AddArray(found.Solve());
  }
}

} // namespace nephoscope
