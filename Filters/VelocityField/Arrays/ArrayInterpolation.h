// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// All arrays of a point data at many positions at once.
#ifndef nephoscope_ArrayInterpolation_h
#define nephoscope_ArrayInterpolation_h

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkDataArray;
class vtkPointData;

namespace nephoscope
{
// The points and weights that make the value at each of some positions; none where it is outside.
class Stencils
{
public:
  void Clear()
  {
    this->Ids.clear();
    this->Weights.clear();
    this->Ends.clear();
  }

  void Add(vtkIdType id, double weight)
  {
    this->Ids.push_back(id);
    this->Weights.push_back(weight);
  }

  void End() { this->Ends.push_back(this->Ids.size()); }

  std::size_t Count() const { return this->Ends.size(); }
  std::size_t BeginOf(std::size_t i) const { return i == 0 ? 0 : this->Ends[i - 1]; }
  std::size_t EndOf(std::size_t i) const { return this->Ends[i]; }

  std::vector<vtkIdType> Ids;
  std::vector<double> Weights;

private:
  std::vector<std::size_t> Ends;
};

// Whether an array of a point data is interpolated: it holds numbers that are neither ids nor ghost
// flags.
bool IsInterpolated(vtkPointData* data, int array);

// NaN in every component of a tuple, 0 where the type has no NaN.
void SetOutside(vtkDataArray* array, vtkIdType tuple);

// Makes every interpolated array of the input in the output, with `count` tuples. `fill(begin, end,
// stencils)` adds the stencils of the positions from begin to end; it is called by several threads.
// Integers are rounded to the nearest.
void InterpolateArrays(vtkPointData* input, std::size_t count, vtkPointData* output,
  const std::function<void(std::size_t, std::size_t, Stencils&)>& fill);
}

#endif
