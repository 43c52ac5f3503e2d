// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeOptics.h"

#include "SmokeData.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTetra.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr float smokeAlbedo = 0.9f, smokeAsymmetry = 0.6f;

struct MassAndVolume
{
  double Mass = 0, Volume = 0;
};

// Mass and volume of the tetrahedra, which are all that vtkFlowVolume makes.
MassAndVolume MassOf(vtkDataSet* cells, vtkDataArray* density)
{
  MassAndVolume sum;
  double x[4][3];
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellPoints(c, ids);
    if (cells->GetCellType(c) != VTK_TETRA || !std::isfinite(density->GetComponent(c, 0)))
    {
      continue;
    }
    for (int i = 0; i < 4; ++i)
    {
      cells->GetPoint(ids->GetId(i), x[i]);
    }
    const double its = std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]));
    sum.Mass += its * density->GetComponent(c, 0);
    sum.Volume += its;
  }
  return sum;
}

// In place of an array of the data that the smoke was made in.
void AddArray(vtkDataSet* data, int association, vtkFloatArray* array)
{
  data->GetPointData()->RemoveArray(array->GetName());
  data->GetCellData()->RemoveArray(array->GetName());
  data->GetAttributes(association)->AddArray(array);
}

void AddOnPoints(vtkDataSet* data, const std::string& name, float value)
{
  if (!name.empty() && name != "None")
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfTuples(data->GetNumberOfPoints());
    array->FillValue(value);
    AddArray(data, vtkDataObject::POINT, array);
  }
}
}

double SmokeColumn(vtkDataSet* data, vtkMultiProcessController* ranks)
{
  vtkDataArray* density = data ? SmokeDensity(data) : nullptr;
  const auto reduced = [&](double mine, int operation) {
    double all = mine;
    ranks ? ranks->AllReduce(&mine, &all, 1, operation) : 0;
    return all;
  };
  const double width = WidthOfSmoke(density ? data : nullptr, ranks);
  const vtkBoundingBox here = density ? vtkBoundingBox(data->GetBounds()) : vtkBoundingBox();
  vtkBoundingBox whole = here;
  if (ranks)
  {
    ranks->AllReduce(here, whole);
  }
  const double initial =
    reduced(density ? InitialSmokeDensity(data) : 0.0, vtkCommunicator::MAX_OP);
  const MassAndVolume mine = density ? MassOf(data, density) : MassAndVolume();
  const double mass = reduced(mine.Mass, vtkCommunicator::SUM_OP),
               volume = reduced(mine.Volume, vtkCommunicator::SUM_OP);
  const double mean = volume > 0 ? mass / volume : 0;
  const double fallback = whole.IsValid() ? whole.GetDiagonalLength() / 50 : 0;
  return (width > 0 ? width : fallback) * (initial > 0 ? initial : mean);
}

bool AddSmokeOptics(
  vtkDataSet* data, const std::string& albedoName, const std::string& asymmetryName, double column)
{
  if (!SmokeDensity(data))
  {
    return false;
  }
  vtkDataArray* visible = VisibleSmoke(data);
  vtkNew<vtkFloatArray> extinction;
  extinction->SetName(smokeExtinctionName);
  extinction->SetNumberOfTuples(visible->GetNumberOfTuples());
  for (vtkIdType i = 0; i < visible->GetNumberOfTuples(); ++i)
  {
    extinction->SetValue(
      i, static_cast<float>(column > 0 ? visible->GetComponent(i, 0) / column : 0));
  }
  const bool onCells = data->GetCellData()->GetArray(visible->GetName()) == visible;
  AddArray(data, onCells ? vtkDataObject::CELL : vtkDataObject::POINT, extinction);
  AddOnPoints(data, albedoName, smokeAlbedo);
  AddOnPoints(data, asymmetryName, smokeAsymmetry);
  return true;
}
}
