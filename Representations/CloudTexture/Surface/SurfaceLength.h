// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The length of one unit of texture where coordinates are positions, and how often it repeats
 * itself: of a surface, or of the parts of one together.
 */
#ifndef nephoscope_SurfaceLength_h
#define nephoscope_SurfaceLength_h

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
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

  /** The length of a surface, or of the whole that it is said to be a part of. */
  static SurfaceLength Of(vtkPolyData* data)
  {
    SurfaceLength result;
    vtkDataArray* told = data->GetFieldData()->GetArray(FieldName());
    if (!told || told->GetNumberOfTuples() < 8)
    {
      result.Add(data);
      return result;
    }
    for (int c = 0; c < 3; ++c)
    {
      result.Low[c] = told->GetComponent(c, 0);
      result.High[c] = told->GetComponent(3 + c, 0);
    }
    result.SmallestRadius = told->GetComponent(6, 0);
    result.LargestRadius = told->GetComponent(7, 0);
    return result;
  }

  /** What Of() reads. The name and the values of a field array. */
  static const char* FieldName() { return "NephoscopeSurfaceLength"; }
  void Tell(vtkFieldData* data) const
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(FieldName());
    for (const double* corner : { this->Low, this->High })
    {
      for (int c = 0; c < 3; ++c)
      {
        array->InsertNextValue(corner[c]);
      }
    }
    array->InsertNextValue(this->SmallestRadius);
    array->InsertNextValue(this->LargestRadius);
    data->AddArray(array);
  }

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

  double Side(int c) const { return std::max(0.0, this->High[c] - this->Low[c]); }
  double Longest() const { return std::max(this->Side(0), std::max(this->Side(1), this->Side(2))); }
  double Shortest() const
  {
    return std::min(this->Side(0), std::min(this->Side(1), this->Side(2)));
  }

  /** About the origin with radii that differ little. */
  bool IsGlobe() const
  {
    return this->SmallestRadius > 0.5 * this->LargestRadius &&
      this->Longest() > this->SmallestRadius;
  }

  /** The equator of a globe, the longest side of any other surface. */
  double Get() const
  {
    const double longest = this->Longest();
    return this->IsGlobe() ? 2 * 3.14159265358979 * this->SmallestRadius
      : longest > 0        ? longest
                           : 1;
  }

  /**
   * The default number of repetitions along this length. Layers have smaller clouds than bodies,
   * the more so the flatter they are.
   */
  double Repetitions() const
  {
    constexpr double ofBodies = 2.5, ofLayers = 4, ofGlobes = 8;
    const double flat = this->Longest() > 0 ? this->Shortest() / this->Longest() : 1;
    return this->IsGlobe() ? ofGlobes : ofLayers + std::min(1.0, 2 * flat) * (ofBodies - ofLayers);
  }
};

} // namespace nephoscope

#endif
