// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Small datasets whose volume, scalars and topology are known. */
#ifndef nephoscope_TestGrids_h
#define nephoscope_TestGrids_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace nephoscope_test
{

using Place = std::function<void(double i, double j, double k, double x[3])>;

/**
 * A structured grid of n0 x n1 x n2 cells, double coordinates, whose point (i, j, k) `place` puts
 * somewhere.
 */
inline vtkSmartPointer<vtkStructuredGrid> MakeStructuredGrid(
  int n0, int n1, int n2, const Place& place)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k <= n2; ++k)
  {
    for (int j = 0; j <= n1; ++j)
    {
      for (int i = 0; i <= n0; ++i)
      {
        double x[3];
        place(i, j, k, x);
        points->InsertNextPoint(x);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(n0 + 1, n1 + 1, n2 + 1);
  grid->SetPoints(points);
  return grid;
}

inline vtkSmartPointer<vtkStructuredGrid> MakeLattice(int n)
{
  return MakeStructuredGrid(n, n, n, [](double i, double j, double k, double x[3]) {
    x[0] = i;
    x[1] = j;
    x[2] = k;
  });
}

/**
 * A shell around the origin in longitude, latitude (degrees) and radius; the first and last
 * meridian coincide exactly.
 */
inline vtkSmartPointer<vtkStructuredGrid> MakeShell(
  int longitudes, int latitudes, int layers, double largestLatitude, double inner, double outer)
{
  const double pi = std::acos(-1.0);
  return MakeStructuredGrid(
    longitudes, latitudes, layers, [=](double i, double j, double k, double x[3]) {
      const double lambda = 2 * pi * std::fmod(i, longitudes) / longitudes;
      const double phi = largestLatitude * pi / 180 * (2 * j / latitudes - 1);
      const double r = inner + (outer - inner) * k / layers;
      x[0] = r * std::cos(phi) * std::cos(lambda);
      x[1] = r * std::cos(phi) * std::sin(lambda);
      x[2] = r * std::sin(phi);
    });
}

inline vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(
  const std::vector<std::array<double, 3>>& places,
  const std::vector<std::pair<int, std::vector<vtkIdType>>>& cells)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& x : places)
  {
    points->InsertNextPoint(x.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  for (const auto& [type, ids] : cells)
  {
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return grid;
}

/** Adds a named array with one component per function of the point (or cell number). */
inline vtkDataArray* AddScalars(
  vtkDataSet* data, bool onCells, const std::function<double(vtkIdType)>& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("scalar");
  const vtkIdType n = onCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  array->SetNumberOfTuples(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    array->SetValue(i, value(i));
  }
  onCells ? data->GetCellData()->SetScalars(array) : data->GetPointData()->SetScalars(array);
  return array;
}

inline vtkDataArray* AddPointNumbers(vtkDataSet* data)
{
  return AddScalars(data, false, [](vtkIdType i) { return static_cast<double>(i); });
}

} // namespace nephoscope_test

#endif
