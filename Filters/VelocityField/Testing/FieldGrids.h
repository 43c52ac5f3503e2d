// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Datasets of every kind, with velocities that are a function of the position.
#ifndef nephoscope_FieldGrids_h
#define nephoscope_FieldGrids_h

#include "VelocityField.h"

#include "vtkAppendFilter.h"
#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace nephoscope_test
{
using nephoscope::Vector3;

inline Vector3 LinearVelocity(const Vector3& x)
{
  return { 1.0 + 0.5 * x[0] - 0.25 * x[1] + 0.125 * x[2], -2.0 + x[2] - 0.5 * x[0],
    3.0 * x[1] - x[2] };
}

template <typename Array = vtkDoubleArray, typename Function>
void AddPointVectors(vtkDataSet* data, const Function& velocity, const char* name = "velocity")
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Vector3 x;
    data->GetPoint(i, x.data());
    array->SetTuple(i, velocity(x).data());
  }
  data->GetPointData()->AddArray(array);
}

template <typename Function>
void AddCellVectors(vtkDataSet* data, const Function& velocity, const char* name = "velocity")
{
  vtkNew<vtkCellCenters> centers;
  centers->SetInputData(data);
  centers->Update();
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(data->GetNumberOfCells());
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    Vector3 x;
    centers->GetOutput()->GetPoint(i, x.data());
    array->SetTuple(i, velocity(x).data());
  }
  data->GetCellData()->AddArray(array);
}

// 7 x 6 x 5 points in [0, 6] x [0, 5] x [0, 4], from the extent's own corner.
inline vtkSmartPointer<vtkImageData> Image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 9, -2, 3, 10, 14);
  image->SetOrigin(-3, 2, -10);
  return image;
}

inline vtkSmartPointer<vtkImageData> TurnedImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 9, -2, 3, 10, 14);
  image->SetSpacing(0.5, 1.5, 0.25);
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  image->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
  return image;
}

inline vtkSmartPointer<vtkRectilinearGrid> Rectilinear()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(7, 6, 5);
  const auto axis = [](const std::vector<float>& values) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    for (const float value : values)
    {
      array->InsertNextValue(value);
    }
    return array;
  };
  grid->SetXCoordinates(axis({ 0, 0.5, 1, 3, 4, 5.5, 6 }));
  grid->SetYCoordinates(axis({ 0, 1, 2, 2.25, 4, 5 }));
  grid->SetZCoordinates(axis({ 0, 0.125, 2, 3, 4 }));
  return grid;
}

inline vtkSmartPointer<vtkStructuredGrid> Curvilinear(int precision = VTK_DOUBLE)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(7, 6, 5);
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  for (int k = 0; k < 5; ++k)
  {
    for (int j = 0; j < 6; ++j)
    {
      for (int i = 0; i < 7; ++i)
      {
        points->InsertNextPoint(i + 0.2 * std::sin(1.3 * j + k), j + 0.2 * std::cos(i + 0.7 * k),
          k + 0.2 * std::sin(0.9 * i - j));
      }
    }
  }
  grid->SetPoints(points);
  return grid;
}

inline vtkSmartPointer<vtkUnstructuredGrid> Hexahedra()
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(Curvilinear());
  append->Update();
  return append->GetOutput();
}

inline vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra()
{
  vtkNew<vtkDataSetTriangleFilter> split;
  split->SetInputData(Curvilinear());
  split->Update();
  return split->GetOutput();
}

using NamedData = std::pair<std::string, vtkSmartPointer<vtkDataSet>>;

inline std::vector<NamedData> AllGrids()
{
  return { { "image", Image() }, { "turned image", TurnedImage() },
    { "rectilinear", Rectilinear() }, { "curvilinear", Curvilinear() },
    { "curvilinear, float points", Curvilinear(VTK_FLOAT) }, { "hexahedra", Hexahedra() },
    { "tetrahedra", Tetrahedra() } };
}

// Random positions of the dataset: in cells, on faces, on edges and at points; every one is inside.
inline std::vector<Vector3> PositionsInside(vtkDataSet* data, int count, unsigned int seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector3> positions;
  while (static_cast<int>(positions.size()) < count)
  {
    // A weighted mean of the corners of a cell; of few of them on tetrahedra: on faces, edges,
    // corners.
    vtkNew<vtkIdList> ids;
    const auto cell =
      static_cast<vtkIdType>(unit(random) * static_cast<double>(data->GetNumberOfCells()));
    data->GetCellPoints(cell, ids);
    const bool corner = positions.size() % 7 == 0;
    Vector3 sum{};
    double total = 0.0;
    for (const vtkIdType id : *ids)
    {
      const double weight = corner && total > 0.0 ? 0.0 : unit(random);
      Vector3 x;
      data->GetPoint(id, x.data());
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[c] += weight * x[c];
      }
      total += weight;
    }
    for (double& c : sum)
    {
      c /= total;
    }
    positions.push_back(sum);
  }
  return positions;
}
}

#endif
