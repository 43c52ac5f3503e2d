// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FillValues.h"

#include "MissingValue.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace nephoscope
{
namespace
{
constexpr double fillValues[] = { -999, -9999, -99999, -32767, -32768 };

struct FillValue
{
  double Value = 0;
  vtkIdType Count = 0; // 0: there is none
};

// The least value of an array, if it is a fill value. All others must be positive or 0, or much
// smaller in size.
FillValue FillValueOf(vtkDataArray* array)
{
  double range[2];
  array->GetFiniteRange(range, 0);
  FillValue found;
  found.Value = range[0];
  const auto* end = std::end(fillValues);
  if (std::find(std::begin(fillValues), end, found.Value) == end)
  {
    return found;
  }
  constexpr double muchSmaller = 0.5;
  double least = std::numeric_limits<double>::max(), largest = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (value == found.Value)
    {
      ++found.Count;
    }
    else if (!IsMissing(value))
    {
      least = std::min(least, value);
      largest = std::max(largest, std::abs(value));
    }
  }
  const bool stands = found.Count < array->GetNumberOfTuples() &&
    (least >= 0 || largest < muchSmaller * std::abs(found.Value));
  found.Count = stands ? found.Count : 0;
  return found;
}
}

std::string DescribeFillValues(vtkDataSet* data)
{
  std::ostringstream text;
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* arrays = data->GetAttributes(kind);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i); // null: of something else than numbers
      if (!array || !array->GetName() || array->GetNumberOfComponents() != 1)
      {
        continue;
      }
      const FillValue found = FillValueOf(array);
      if (found.Count > 0)
      {
        text << (text.tellp() > 0 ? ", " : "") << found.Count << " values of '" << array->GetName()
             << "' are " << found.Value;
      }
    }
  }
  const std::string found = text.str();
  return found.empty() ? found
                       : found +
      ", which looks like a fill value for missing data but is drawn as data. Turn on Replace Fill Value With Nan of the NetCDF reader, or replace the values by NaN.";
}

}
