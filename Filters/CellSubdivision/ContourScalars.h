// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The scalar at every point and its code among the contour values.
 *
 * A vertex whose scalar differs from a value by rounding alone would be cut off with a piece too
 * small for double precision: its scalar is set to the value. This is done if the difference is
 * less than 1e-12 of the scalar's range in a cell that is cut there, or if the cut would be nearer
 * to the vertex than 64 times the rounding of its coordinates.
 */
#ifndef nephoscope_ContourScalars_h
#define nephoscope_ContourScalars_h

#include "ContourLevels.h"

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{

class CellTetrahedra;

class ContourScalars
{
public:
  ContourScalars(vtkDataSet* data, vtkDataArray* scalars, const ContourLevels& levels);

  const ContourLevels& Levels() const { return this->Levels_; }
  double Value(vtkIdType point) const { return this->Values[point]; }
  int Code(vtkIdType point) const { return this->Codes[point]; }
  /** The points whose scalar has been set to a value. */
  const std::vector<vtkIdType>& Snapped() const { return this->Snapped_; }

  /**
   * The adjusted scalar of a vertex of a cell; `range`: the range of the scalar in the cell, whose
   * positions are known.
   */
  double Snap(double scalar, double range, const CellTetrahedra& cell) const;

private:
  bool IsNear(double scalar, double range) const;
  void SnapPoints(vtkDataSet* data, const std::vector<unsigned char>& near);
  void FindPointsToSnap(CellTetrahedra& cell, const std::vector<unsigned char>& near,
    std::vector<vtkIdType>& found) const;

  ContourLevels Levels_;
  std::vector<double> Values;
  std::vector<int> Codes;
  std::vector<vtkIdType> Snapped_;
};

} // namespace nephoscope

#endif
