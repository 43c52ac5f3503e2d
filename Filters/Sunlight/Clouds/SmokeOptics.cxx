// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeOptics.h"

#include "SmokeData.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
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

// Over the volume of the tetrahedra, which is all that vtkFlowVolume makes.
double MeanDensity(vtkDataSet* cells, vtkDataArray* density)
{
  double mass = 0, volume = 0, x[4][3];
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
    mass += its * density->GetComponent(c, 0);
    volume += its;
  }
  return volume > 0 ? mass / volume : 0;
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

bool AddSmokeOptics(
  vtkDataSet* data, const std::string& albedoName, const std::string& asymmetryName)
{
  vtkDataArray* density = SmokeDensity(data);
  if (!density)
  {
    return false;
  }
  const double width = DiameterOfSmoke(BoundsOfYoungSmoke(data, LeastSmokeAge(data)));
  const double initial = InitialSmokeDensity(data);
  const double depth = (width > 0 ? width : data->GetLength() / 50) *
    (initial > 0 ? initial : MeanDensity(data, density));
  vtkDataArray* visible = VisibleSmoke(data);
  vtkNew<vtkFloatArray> extinction;
  extinction->SetName(smokeExtinctionName);
  extinction->SetNumberOfTuples(visible->GetNumberOfTuples());
  for (vtkIdType i = 0; i < visible->GetNumberOfTuples(); ++i)
  {
    extinction->SetValue(
      i, static_cast<float>(depth > 0 ? visible->GetComponent(i, 0) / depth : 0));
  }
  const bool onCells = data->GetCellData()->GetArray(visible->GetName()) == visible;
  AddArray(data, onCells ? vtkDataObject::CELL : vtkDataObject::POINT, extinction);
  AddOnPoints(data, albedoName, smokeAlbedo);
  AddOnPoints(data, asymmetryName, smokeAsymmetry);
  return true;
}
}
