// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays that do not have a value for every point or cell: a reader that fails midway leaves such
// ones behind.
#ifndef nephoscope_ArrayLengths_h
#define nephoscope_ArrayLengths_h

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"

#include <string>

namespace nephoscope
{
inline std::string LengthProblem(
  vtkAbstractArray* array, const std::string& what, vtkIdType expected, const char* ofWhat)
{
  const vtkIdType found = array ? array->GetNumberOfTuples() : 0;
  return found == expected ? std::string()
                           : what + " has " + std::to_string(found) + " values for " +
      std::to_string(expected) + " " + ofWhat +
      ": the input has not been read whole. Check the reader's file and the time asked for.";
}

inline std::string LengthProblem(
  vtkDataSetAttributes* arrays, vtkIdType expected, const char* ofWhat)
{
  std::string problem;
  for (int a = 0; a < arrays->GetNumberOfArrays() && problem.empty(); ++a)
  {
    const char* name = arrays->GetArrayName(a);
    problem = LengthProblem(arrays->GetAbstractArray(a),
      "The array '" + std::string(name ? name : "") + "'", expected, ofWhat);
  }
  return problem;
}

// A sentence about the first array, or axis of a rectilinear grid, of a wrong length; empty if all
// are right.
inline std::string ArrayLengthProblem(vtkDataSet* grid)
{
  std::string problem = LengthProblem(grid->GetPointData(), grid->GetNumberOfPoints(), "points");
  if (problem.empty())
  {
    problem = LengthProblem(grid->GetCellData(), grid->GetNumberOfCells(), "cells");
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    vtkDataArray* const axes[3] = { rectilinear->GetXCoordinates(), rectilinear->GetYCoordinates(),
      rectilinear->GetZCoordinates() };
    const char* const names[3] = { "The longitude axis", "The latitude axis", "The level axis" };
    int extent[6];
    rectilinear->GetExtent(extent);
    for (int axis = 0; axis < 3 && problem.empty(); ++axis)
    {
      problem = LengthProblem(
        axes[axis], names[axis], extent[2 * axis + 1] - extent[2 * axis] + 1, "places");
    }
  }
  if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
  {
    const vtkIdType expected = vtkStructuredData::GetNumberOfPoints(structured->GetExtent());
    vtkPoints* points = structured->GetPoints();
    problem = problem.empty() && points
      ? LengthProblem(points->GetData(), "The grid", expected, "points")
      : problem;
  }
  return problem;
}
}

#endif
