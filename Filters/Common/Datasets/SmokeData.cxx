// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeData.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr const char* initialDensityName = "InitialDensity";
constexpr const char* boundsToComeName = "BoundsToCome";

// That of the youngest point; VTK_DOUBLE_MAX without ages.
double LeastAge(vtkDataSet* cells)
{
  vtkDataArray* ages = cells ? cells->GetPointData()->GetArray("Age") : nullptr;
  double range[2] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  if (ages && ages->GetNumberOfTuples() > 0)
  {
    ages->GetFiniteRange(range);
  }
  return range[0];
}

// Those of the points that are at most so old.
vtkBoundingBox BoundsOfYoung(vtkDataSet* cells, double age)
{
  vtkDataArray* ages = cells ? cells->GetPointData()->GetArray("Age") : nullptr;
  vtkBoundingBox box;
  for (vtkIdType i = 0; ages && i < cells->GetNumberOfPoints(); ++i)
  {
    if (ages->GetComponent(i, 0) <= age)
    {
      double x[3];
      cells->GetPoint(i, x);
      box.AddPoint(x);
    }
  }
  return box;
}
}

vtkDataArray* SmokeDensity(vtkDataSet* cells)
{
  vtkCellData* arrays = cells ? cells->GetCellData() : nullptr;
  vtkDataArray* density = arrays ? arrays->GetArray("Density") : nullptr;
  const bool smoke =
    density && density->GetNumberOfComponents() == 1 && arrays->HasArray("EmissionStep");
  return smoke ? density : nullptr;
}

vtkDataArray* VisibleSmoke(vtkDataSet* cells)
{
  vtkDataArray* density = SmokeDensity(cells);
  vtkDataArray* puffs = density ? cells->GetCellData()->GetArray("SmokeDensity") : nullptr;
  if (density && !puffs)
  {
    puffs = cells->GetPointData()->GetArray("SmokeDensity");
  }
  if (density && !puffs)
  {
    puffs = cells->GetPointData()->GetArray("SmoothDensity");
  }
  return puffs ? puffs : density;
}

void PutInitialDensity(vtkDataSet* cells, double density)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(initialDensityName);
  array->InsertNextValue(density);
  cells->GetFieldData()->AddArray(array);
}

double InitialSmokeDensity(vtkDataSet* cells)
{
  vtkDataArray* array = cells ? cells->GetFieldData()->GetArray(initialDensityName) : nullptr;
  const double density = array && array->GetNumberOfValues() == 1 ? array->GetComponent(0, 0) : 0.0;
  return density > 0.0 && std::isfinite(density) ? density : 0.0;
}

void PutBoundsToCome(vtkDataSet* smoke, const double bounds[6])
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(boundsToComeName);
  array->SetNumberOfValues(6);
  std::copy_n(bounds, 6, array->GetPointer(0));
  smoke->GetFieldData()->AddArray(array);
}

void FindBoundsToCome(vtkDataObject* smoke, double bounds[6])
{
  vtkDataArray* array = smoke ? smoke->GetFieldData()->GetArray(boundsToComeName) : nullptr;
  for (int i = 0; array && array->GetNumberOfValues() == 6 && i < 6; ++i)
  {
    bounds[i] = array->GetComponent(i, 0);
  }
}

double WidthOfSmoke(vtkDataSet* cells, vtkMultiProcessController* ranks)
{
  const double youngestHere = LeastAge(cells);
  double youngest = youngestHere;
  if (ranks)
  {
    ranks->AllReduce(&youngestHere, &youngest, 1, vtkCommunicator::MIN_OP);
  }
  const vtkBoundingBox here = BoundsOfYoung(cells, youngest);
  vtkBoundingBox layer = here;
  if (ranks)
  {
    ranks->AllReduce(here, layer);
  }
  return layer.IsValid() ? layer.GetDiagonalLength() / std::sqrt(2.0) : 0.0;
}

} // namespace nephoscope
