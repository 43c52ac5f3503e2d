// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cells of the output, from all batches: pieces in the order of the input's cells, then the
 * polygons of the surfaces.
 */
#ifndef nephoscope_SplitAssembly_h
#define nephoscope_SplitAssembly_h

#include "CutNumbering.h"
#include "SplitBatch.h"
#include "SplitPoints.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace nephoscope
{

class SplitAssembly
{
public:
  SplitAssembly(vtkDataSet* input, const ContourLevels& levels, std::vector<SplitBatch>& batches,
    const CutNumbering& cuts, const SplitPoints& points);

  void AddCells(vtkUnstructuredGrid* output) const;
  void CarryCellArrays(vtkUnstructuredGrid* output) const;
  /** The arrays Layer and ContourIndex. */
  void AddLayers(vtkUnstructuredGrid* output) const;

private:
  // The cells of one batch, or the faces that lie on values, and where they go in the output.
  struct Part
  {
    const SplitCells* Cells;
    const SplitBatch* Batch;                  // of 3-D cells; else null
    const std::vector<vtkIdType>* CutNumbers; // null: there are none
    vtkIdType FirstCell;
    vtkIdType FirstCorner;
  };

  void CollectFacesOnLevels(const std::vector<SplitBatch>& batches);
  void AddPart(
    const SplitCells& cells, const SplitBatch* batch, const std::vector<vtkIdType>* cutNumbers);
  vtkIdType PointOf(vtkIdType corner, const Part& part) const;
  bool HasPolyhedra() const;
  void AddCellArrays(vtkUnstructuredGrid* output) const;
  void InsertOneByOne(vtkUnstructuredGrid* output) const;
  void InsertPart(const Part& part, vtkUnstructuredGrid* output) const;
  template <typename Function>
  void ForEachPart(Function&& function) const;

  vtkDataSet* Input;
  const ContourLevels& Levels;
  const SplitPoints& Points;
  vtkIdType NumberOfInputPoints;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfCorners = 0;
  SplitCells FacesOnLevels;
  std::vector<Part> Parts;
};

} // namespace nephoscope

#endif
