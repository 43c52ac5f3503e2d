// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which scalar of a data array is meant, and how its values become numbers from 0 to 1 that float
 * can hold.
 */
#ifndef nephoscope_ScalarSelection_h
#define nephoscope_ScalarSelection_h

#include "ProgressLoop.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nephoscope
{

struct ScalarSelection
{
  vtkDataArray* Array = nullptr;
  bool OnCells = false;
  int Component = -1; ///< -1: the magnitude of a vector
  double Headroom =
    0; ///< above 0: shaders change values, by at most this much upwards, and down to 0
};

inline double ScalarValue(const ScalarSelection& scalars, vtkIdType tuple)
{
  const int components = scalars.Array->GetNumberOfComponents();
  if (components == 1 || scalars.Component >= 0)
  {
    return scalars.Array->GetComponent(
      tuple, std::min(std::max(scalars.Component, 0), components - 1));
  }
  double sum = 0;
  for (int c = 0; c < components; ++c)
  {
    const double value = scalars.Array->GetComponent(tuple, c);
    sum += value * value;
  }
  return std::sqrt(sum);
}

/**
 * Finite minimum and maximum, never equal: the range that becomes [0, 1]. Hidden values do not
 * count: a fill value there would take the precision of all that is drawn. `single` says whether
 * all values are equal. False when stopped.
 */
inline bool FindRange(vtkDataSet* data, const ScalarSelection& scalars, double range[2],
  const Progress& progress = {}, bool* single = nullptr)
{
  vtkUnsignedCharArray* ghosts =
    scalars.OnCells ? data->GetCellGhostArray() : data->GetPointGhostArray();
  const int hidden = scalars.OnCells ? int(vtkDataSetAttributes::HIDDENCELL)
                                     : int(vtkDataSetAttributes::HIDDENPOINT);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const std::size_t n = static_cast<std::size_t>(scalars.Array->GetNumberOfTuples());
  const bool done = ForEachInTurn(n, progress, [&](std::size_t tuple) {
    const vtkIdType i = static_cast<vtkIdType>(tuple);
    const double value = ScalarValue(scalars, i);
    if (std::isfinite(value) && !(ghosts && (ghosts->GetValue(i) & hidden)))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  });
  if (scalars.Headroom > 0 && low <= high)
  {
    low = std::min(low, 0.0);
    high += scalars.Headroom;
  }
  if (single)
  {
    *single = !(low < high);
  }
  range[0] = low <= high ? low : 0.0;
  range[1] = low < high ? high : range[0] + 1.0;
  if (range[1] == range[0]) // so large that 1 more is no difference
  {
    range[1] = std::nextafter(range[0], std::numeric_limits<double>::infinity());
  }
  return done;
}

/** 0 at the low end of the range, 1 at its high end. */
inline double NormalizedValue(double value, const double range[2])
{
  const double width = range[1] - range[0];
  return std::isfinite(width) ? (value - range[0]) / width
                              : (0.5 * value - 0.5 * range[0]) / (0.5 * range[1] - 0.5 * range[0]);
}

inline float Normalized(const ScalarSelection& scalars, vtkIdType tuple, const double range[2])
{
  return static_cast<float>(NormalizedValue(ScalarValue(scalars, tuple), range));
}

/** The values of all tuples; NaN where one is not finite. */
inline std::vector<float> NormalizedScalars(const ScalarSelection& scalars, const double range[2])
{
  std::vector<float> values(static_cast<std::size_t>(scalars.Array->GetNumberOfTuples()));
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const float s = Normalized(scalars, i, range);
      values[static_cast<std::size_t>(i)] =
        std::isfinite(s) ? s : std::numeric_limits<float>::quiet_NaN();
    }
  });
  return values;
}

} // namespace nephoscope

#endif
