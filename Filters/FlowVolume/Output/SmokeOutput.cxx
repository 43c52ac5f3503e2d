// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmokeOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
template <typename Array, typename Value>
vtkSmartPointer<Array> MakeArray(const char* name, const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Vector3>& positions)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(positions.size()));
  double* next = coordinates->GetPointer(0);
  for (const Vector3& position : positions)
  {
    next = std::copy(position.begin(), position.end(), next);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetData(coordinates);
  return points;
}

vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<TetrahedronPoints>& tetrahedra)
{
  const auto count = static_cast<vtkIdType>(tetrahedra.size());
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 4 * i);
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(4 * count);
  vtkIdType* next = connectivity->GetPointer(0);
  for (const TetrahedronPoints& tetrahedron : tetrahedra)
  {
    next = std::copy(tetrahedron.begin(), tetrahedron.end(), next);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

vtkSmartPointer<vtkDoubleArray> MakeDensities(
  const char* name, const std::vector<double>& relative, double initialDensity)
{
  auto densities = MakeArray<vtkDoubleArray>(name, relative);
  double* values = densities->GetPointer(0);
  std::transform(values, values + relative.size(), values,
    [initialDensity](double density) { return initialDensity * density; });
  return densities;
}

void PutCellArrays(const SmokeMesh& mesh, double initialDensity, vtkCellData* output)
{
  output->AddArray(MakeArray<vtkIntArray>("EmissionStep", mesh.EmissionSteps));
  output->AddArray(MakeArray<vtkDoubleArray>("Age", mesh.Ages));
  output->AddArray(MakeDensities("Density", mesh.Densities, initialDensity));
}
}

bool PutSmoke(const SmokeMesh& mesh, double initialDensity, const ArraySampler& sampleArrays,
  vtkUnstructuredGrid* output)
{
  output->SetPoints(MakePoints(mesh.Points));
  output->SetCells(VTK_TETRA, MakeCells(mesh.Tetrahedra));
  PutCellArrays(mesh, initialDensity, output->GetCellData());
  vtkPointData* pointData = output->GetPointData();
  sampleArrays(mesh, pointData);
  // Marks of the input's points say nothing about points between them.
  pointData->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  const bool replaced = pointData->HasArray("Age");
  pointData->AddArray(MakeArray<vtkDoubleArray>("Age", mesh.PointAges));
  pointData->AddArray(MakeDensities("SmoothDensity", mesh.PointDensities, initialDensity));
  return replaced;
}
}
