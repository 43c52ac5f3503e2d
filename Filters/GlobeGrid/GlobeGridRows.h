// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Common parts of the passes of GlobeGridBuilder: the rows of a piece in parallel, new arrays,
// local frames.
#ifndef nephoscope_GlobeGridRows_h
#define nephoscope_GlobeGridRows_h

#include "Geodesy.h"
#include "OwnThreads.h"

#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <vector>

namespace nephoscope
{
enum HiddenReason : unsigned char
{
  BELOW_GROUND = 1,
  HEIGHT_MISSING = 2,
  WIND_MISSING = 4
};

// One row of the output: indices from 0, and the id of its first point in this piece.
struct OutputRow
{
  int j;
  int k;
  vtkIdType firstId;
};

// Calls function(OutputRow) for every row of the extent, in threads; rows write to their own points
// only.
template <typename Function>
void ForEachRow(const int extent[6], const Function& function)
{
  const vtkIdType columns = extent[1] - extent[0] + 1;
  const vtkIdType rows = extent[3] - extent[2] + 1;
  const vtkIdType levels = extent[5] - extent[4] + 1;
  auto work = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end; ++r)
    {
      function(OutputRow{ extent[2] + static_cast<int>(r % rows),
        extent[4] + static_cast<int>(r / rows), r * columns });
    }
  };
  InParallel(rows * levels, work);
}

template <typename Array>
vtkSmartPointer<Array> NewPointArray(vtkStructuredGrid* output, const char* name, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  output->GetPointData()->AddArray(array);
  return array;
}

inline vtkIdType CountWith(const std::vector<unsigned char>& flags, unsigned char reason)
{
  return std::count_if(
    flags.begin(), flags.end(), [reason](unsigned char flag) { return (flag & reason) != 0; });
}

inline geodesy::Basis BasisAt(const std::array<double, 3>& coordinates)
{
  return geodesy::LocalBasis(
    geodesy::TurnFromDegrees(coordinates[0]), geodesy::TurnFromDegrees(coordinates[1]));
}
}

#endif
