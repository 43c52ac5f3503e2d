// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeCells.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"

#include <cmath>

namespace nephoscope
{
namespace
{
vtkMultiProcessController* otherRanks()
{
  auto controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

double leastAge(vtkDataArray* ages)
{
  double range[2] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  if (ages && ages->GetNumberOfTuples() > 0)
  {
    ages->GetFiniteRange(range);
  }
  double least = range[0];
  if (auto controller = otherRanks())
  {
    controller->AllReduce(range, &least, 1, vtkCommunicator::MIN_OP);
  }
  return least;
}
} // namespace

vtkDataArray* smokeDensity(vtkDataSet* cells)
{
  vtkCellData* arrays = cells ? cells->GetCellData() : nullptr;
  vtkDataArray* density = arrays ? arrays->GetArray("Density") : nullptr;
  const bool smoke =
    density && density->GetNumberOfComponents() == 1 && arrays->HasArray("EmissionStep");
  return smoke ? density : nullptr;
}

vtkDataArray* visibleSmoke(vtkDataSet* cells)
{
  vtkDataArray* density = smokeDensity(cells);
  vtkDataArray* puffs = density ? cells->GetCellData()->GetArray("SmokeDensity") : nullptr;
  if (density && !puffs)
  {
    puffs = cells->GetPointData()->GetArray("SmokeDensity");
  }
  return puffs ? puffs : density;
}

bool isSmoke(vtkDataSet* cells)
{
  int mine = smokeDensity(cells) ? 1 : 0, any = mine;
  if (auto controller = otherRanks())
  {
    controller->AllReduce(&mine, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any != 0;
}

double smokeThickness(vtkDataSet* cells)
{
  vtkDataArray* ages = cells ? cells->GetPointData()->GetArray("Age") : nullptr;
  const double youngest = leastAge(ages);
  vtkBoundingBox box;
  for (vtkIdType i = 0; ages && i < cells->GetNumberOfPoints(); ++i)
  {
    if (ages->GetComponent(i, 0) <= youngest)
    {
      double x[3];
      cells->GetPoint(i, x);
      box.AddPoint(x);
    }
  }
  if (auto controller = otherRanks())
  {
    const vtkBoundingBox mine = box;
    controller->AllReduce(mine, box);
  }
  return box.IsValid() ? box.GetDiagonalLength() / std::sqrt(2.0) : 0.0;
}

} // namespace nephoscope
