// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Undivided neighbours of divided cells, as polyhedra whose common faces are divided too.
 *
 * A divided cell has triangles where its neighbour, left whole, has a polygon. As a polyhedron the
 * neighbour can have the same triangles, and stay one cell with the points it had.
 */
#ifndef nephoscope_TransitionCells_h
#define nephoscope_TransitionCells_h

#include "SplitBatch.h"

#include <vector>

class vtkDataSet;

namespace nephoscope
{

class TransitionCells
{
public:
  /** Collects the faces of divided cells that their neighbours may have whole. */
  TransitionCells(vtkDataSet* data, const std::vector<SplitBatch>& batches);

  /** Turns the whole cells of all batches that have such a face into polyhedra. */
  void Convert(std::vector<SplitBatch>& batches) const;

private:
  void ConvertBatch(SplitBatch& batch) const;
  bool Touches(const vtkIdType* begin, const vtkIdType* end) const;
  bool MakeFaces(CellTetrahedra& cell, std::vector<vtkIdType>& stream) const;

  vtkDataSet* Data;
  std::vector<FaceKey> Faces;         // sorted
  std::vector<unsigned char> Touched; // points of these faces
};

} // namespace nephoscope

#endif
