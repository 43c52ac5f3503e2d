// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of the output with their arrays: the input's in their order, the centres of cells, the
 * cuts.
 *
 * A cut lies between two points at t = (value - scalar) / (scalar - scalar), counted from the end
 * with the lower scalar, so that it comes out the same wherever the edge is met again.
 */
#ifndef nephoscope_SplitPoints_h
#define nephoscope_SplitPoints_h

#include "ContourScalars.h"
#include "SplitBatch.h"

#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;
class vtkDataSetAttributes;
class vtkPoints;

namespace nephoscope
{

class SplitPoints
{
public:
  SplitPoints(vtkDataSet* input, vtkDataArray* scalars, const ContourScalars& values,
    const std::vector<SplitBatch>& batches, const std::vector<PointCut>& cuts);

  /** Output point of the centre of an input cell. */
  vtkIdType CentreNumber(vtkIdType cell) const;
  /** Output point of the first cut; the others follow. */
  vtkIdType FirstCut() const;

  void Place(vtkPoints* points) const;
  void CarryArrays(vtkDataSetAttributes* output) const;

private:
  struct Edge
  {
    vtkIdType Low;
    vtkIdType High;
    double Parameter; // from Low to High
    int Level;
  };

  double ScalarAt(vtkIdType outputPoint) const;
  Edge MakeEdge(const PointCut& cut) const;
  void CarryArray(vtkAbstractArray* from, vtkAbstractArray* to, bool areIds) const;
  void Interpolate(vtkDataArray* from, vtkDataArray* to) const;
  void CopyNearest(vtkAbstractArray* from, vtkAbstractArray* to) const;
  void MarkAsNew(vtkAbstractArray* from, vtkAbstractArray* to) const;
  void CombineGhosts(vtkAbstractArray* from, vtkAbstractArray* to) const;
  void WriteScalars(vtkDataArray* to) const;

  vtkDataSet* Input;
  vtkDataArray* Scalars;
  const ContourScalars& Values;
  vtkIdType NumberOfPoints;
  std::vector<CellCentre> Centres; // in the order of cells
  std::vector<Edge> Edges;
};

} // namespace nephoscope

#endif
