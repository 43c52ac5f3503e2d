// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankDivisions.h"

#include "ChessboardDivision.h"
#include "RankExchange.h"
#include "RankPlaces.h"
#include "TetrahedronSource.h"
#include "VolumetricCells.h"

#include "vtkMultiProcessController.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace nephoscope
{
namespace
{
/**
 * A point that several ranks have, rounded. Its code is twice the number of its whole among those
 * of all ranks, and 1 more where it is odd.
 */
struct SharedPoint
{
  Vector3 Place;
  std::int32_t Code;
};

// Two wholes that have a point in common, and 1 where it is odd in one of them alone.
using Bond = std::array<std::int32_t, 3>;

bool IsMisnumbered(vtkUnstructuredGrid* cells)
{
  TetrahedronSource source(cells);
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    if (!source.IsHidden(cell) && source.PutInOrder(cell) == CellShape::Misnumbered)
    {
      return true;
    }
  }
  return false;
}

// The wholes of the ranks before this one, and of all.
std::pair<int, int> CountWholes(vtkMultiProcessController* controller, int mine)
{
  std::vector<int> counts(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(&mine, counts.data(), 1);
  const auto own = counts.begin() + controller->GetLocalProcessId();
  return { std::accumulate(counts.begin(), own, 0),
    std::accumulate(counts.begin(), counts.end(), 0) };
}

// Those of this rank, for each rank that has them too.
std::vector<std::vector<SharedPoint>> SharedPoints(
  vtkUnstructuredGrid* cells, ChessboardColors& colors, int firstWhole, int ranks)
{
  std::vector<Vector3> places;
  std::vector<std::int32_t> codes;
  for (const vtkIdType number : PointsOfSurface(cells))
  {
    const auto color = colors.ColorOf(number);
    Vector3 x;
    cells->GetPoint(number, x.data());
    if (color.first >= 0 && std::isfinite(x[0] + x[1] + x[2]))
    {
      places.push_back(x);
      codes.push_back(2 * (firstWhole + color.first) + color.second);
    }
  }
  std::vector<std::vector<SharedPoint>> points(static_cast<std::size_t>(ranks));
  for (const SharedPlace& shared : PlacesOfSeveralRanks(places))
  {
    points[static_cast<std::size_t>(shared.Rank)].push_back(
      { shared.Rounded, codes[shared.Index] });
  }
  return points;
}

// Each once. A rank gets the points of all others at each of its places.
std::vector<Bond> BondsAtPoints(
  vtkMultiProcessController* controller, const std::vector<std::vector<SharedPoint>>& own)
{
  std::vector<SharedPoint> points;
  for (const auto& ofRanks : { own, TradeRecords(controller, own) })
  {
    for (const auto& some : ofRanks)
    {
      points.insert(points.end(), some.begin(), some.end());
    }
  }
  std::sort(points.begin(), points.end(), [](const SharedPoint& a, const SharedPoint& b) {
    return std::tie(a.Place, a.Code) < std::tie(b.Place, b.Code);
  });
  std::vector<Bond> bonds;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const std::int32_t a = points[i - 1].Code, b = points[i].Code;
    if (points[i - 1].Place == points[i].Place && a / 2 != b / 2)
    {
      bonds.push_back({ { a / 2, b / 2, (a ^ b) & 1 } });
    }
  }
  std::sort(bonds.begin(), bonds.end());
  bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
  return bonds;
}

std::vector<Bond> BondsOfAll(vtkMultiProcessController* controller, const std::vector<Bond>& mine)
{
  vtkNew<vtkTypeInt32Array> own, all;
  for (const Bond& bond : mine)
  {
    std::for_each(
      bond.begin(), bond.end(), [&own](std::int32_t value) { own->InsertNextValue(value); });
  }
  controller->AllGatherV(own, all);
  std::vector<Bond> bonds(static_cast<std::size_t>(all->GetNumberOfValues() / 3));
  std::copy(all->Begin(), all->End(), bonds.empty() ? nullptr : bonds.front().data());
  return bonds;
}

// The first whole of those that belong together is even.
std::vector<unsigned char> ParitiesOfWholes(ColoredParts& wholes, int first, std::size_t count)
{
  std::vector<int> flips(wholes.Count(), -1);
  std::vector<unsigned char> odd(count);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(wholes.Count()); ++i)
  {
    const auto found = wholes.Find(i);
    int& flip = flips[static_cast<std::size_t>(found.first)];
    flip = flip < 0 ? found.second : flip;
    if (i >= first && i < first + static_cast<std::int32_t>(count))
    {
      odd[static_cast<std::size_t>(i - first)] = static_cast<unsigned char>(found.second ^ flip);
    }
  }
  return odd;
}

vtkSmartPointer<vtkUnsignedCharArray> NoDivisions(vtkUnstructuredGrid* cells)
{
  auto divisions = vtkSmartPointer<vtkUnsignedCharArray>::New();
  divisions->SetName(divisionName);
  divisions->SetNumberOfValues(cells->GetNumberOfCells());
  divisions->FillValue(0);
  return divisions;
}

vtkSmartPointer<vtkUnsignedCharArray> RankDivisions(
  vtkMultiProcessController* controller, vtkUnstructuredGrid* cells)
{
  ChessboardColors colors(cells);
  int fits = colors.Find() && !IsMisnumbered(cells), all = 0;
  controller->AllReduce(&fits, &all, 1, vtkCommunicator::MIN_OP);
  if (!all)
  {
    return NoDivisions(cells);
  }
  const auto counts = CountWholes(controller, static_cast<int>(colors.CountWholes()));
  ColoredParts wholes;
  for (int i = 0; i < counts.second; ++i)
  {
    wholes.Add();
  }
  const auto points = SharedPoints(cells, colors, counts.first, controller->GetNumberOfProcesses());
  const std::vector<Bond> bonds = BondsOfAll(controller, BondsAtPoints(controller, points));
  // Else a point would have to have both colours.
  const bool areConsistent = std::all_of(bonds.begin(), bonds.end(),
    [&wholes](const Bond& bond) { return wholes.Join(bond[0], bond[1], bond[2]); });
  return areConsistent
    ? colors.MakeDivisions(ParitiesOfWholes(wholes, counts.first, colors.CountWholes()))
    : NoDivisions(cells);
}
}

void StoreRankDivisions(vtkUnstructuredGrid* cells)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  // An empty piece goes with either.
  const int own = cells->GetNumberOfCells() == 0 || cells->GetCellData()->HasArray(divisionName);
  int all = own;
  controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  if (!all)
  {
    const auto divisions = RankDivisions(controller, cells);
    if (!cells->GetCellData()->HasArray(divisionName))
    {
      cells->GetCellData()->AddArray(divisions);
    }
  }
}

} // namespace nephoscope
