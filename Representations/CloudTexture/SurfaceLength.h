// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The length of one unit of texture where coordinates are positions: of a surface, or of the parts of one together. */
#ifndef SurfaceLength_h
#define SurfaceLength_h

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{

struct SurfaceLength
{
  double Low[3] = { 1e300, 1e300, 1e300 };
  double High[3] = { -1e300, -1e300, -1e300 };
  double SmallestRadius = std::numeric_limits<double>::max();
  double LargestRadius = 0;

  void Add(vtkPolyData* data)
  {
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      data->GetPoint(i, p);
      for (int c = 0; c < 3; ++c)
      {
        this->Low[c] = std::min(this->Low[c], p[c]);
        this->High[c] = std::max(this->High[c], p[c]);
      }
      const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      this->SmallestRadius = std::min(this->SmallestRadius, r);
      this->LargestRadius = std::max(this->LargestRadius, r);
    }
  }

  /** About the origin with radii that differ little: a globe. Its length is the equator; that of any other surface its longest side. */
  double Get() const
  {
    double longest = 0;
    for (int c = 0; c < 3; ++c)
    {
      longest = std::max(longest, this->High[c] - this->Low[c]);
    }
    const bool isGlobe = this->SmallestRadius > 0.5 * this->LargestRadius && longest > this->SmallestRadius;
    return isGlobe ? 2 * 3.14159265358979 * this->SmallestRadius : longest > 0 ? longest : 1;
  }
};

} // namespace nephoscope

#endif
