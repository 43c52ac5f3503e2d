// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankDivisions.h"

#include "ChessboardDivision.h"
#include "RankPlaces.h"
#include "TetrahedronSource.h"
#include "VolumetricCells.h"

#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
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
  double X, Y, Z, Code;
};

bool AtOnePlace(const SharedPoint& a, const SharedPoint& b)
{
  return a.X == b.X && a.Y == b.Y && a.Z == b.Z;
}

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

std::vector<SharedPoint> SharedPoints(
  vtkUnstructuredGrid* cells, ChessboardColors& colors, int firstWhole)
{
  std::vector<Vector3> places;
  std::vector<double> codes;
  for (const vtkIdType number : PointsOfSurface(cells))
  {
    const auto color = colors.ColorOf(number);
    Vector3 x;
    cells->GetPoint(number, x.data());
    if (color.first >= 0 && std::isfinite(x[0] + x[1] + x[2]))
    {
      places.push_back(x);
      codes.push_back(2.0 * (firstWhole + color.first) + color.second);
    }
  }
  std::vector<SharedPoint> points;
  for (const SharedPlace& shared : PlacesOfSeveralRanks(places))
  {
    const Vector3& x = shared.Rounded;
    points.push_back({ x[0], x[1], x[2], codes[shared.Index] });
  }
  return points;
}

std::vector<SharedPoint> PointsOfAll(
  vtkMultiProcessController* controller, const std::vector<SharedPoint>& mine)
{
  vtkNew<vtkDoubleArray> own, all;
  own->SetArray(reinterpret_cast<double*>(const_cast<SharedPoint*>(mine.data())),
    static_cast<vtkIdType>(4 * mine.size()), 1);
  controller->AllGatherV(own, all);
  std::vector<SharedPoint> points(static_cast<std::size_t>(all->GetNumberOfValues() / 4));
  std::copy(all->Begin(), all->End(), reinterpret_cast<double*>(points.data()));
  return points;
}

// False where a point would have to have both colours.
bool JoinRanks(std::vector<SharedPoint>& points, ColoredParts& wholes)
{
  std::sort(points.begin(), points.end(), [](const SharedPoint& a, const SharedPoint& b) {
    return std::tie(a.X, a.Y, a.Z, a.Code) < std::tie(b.X, b.Y, b.Z, b.Code);
  });
  bool fits = true;
  for (std::size_t i = 1; i < points.size() && fits; ++i)
  {
    if (AtOnePlace(points[i - 1], points[i]))
    {
      const auto a = static_cast<std::int32_t>(points[i - 1].Code),
                 b = static_cast<std::int32_t>(points[i].Code);
      fits = a / 2 == b / 2 || wholes.Join(a / 2, b / 2, (a ^ b) & 1);
    }
  }
  return fits;
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
  std::vector<SharedPoint> points =
    PointsOfAll(controller, SharedPoints(cells, colors, counts.first));
  return JoinRanks(points, wholes)
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
