// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shapes of the samples of unstructured cells. A point stands for its share of the cells around it,
 * a cell's centre for the cell: an ellipsoid of that volume, as long in every direction as the
 * edges are in the mean. On the boundary cells lie on one side of a point; its shape is as large as
 * if they were on the other too, and it has that part of it that they fill. On hexahedra that are
 * those of a structured grid it is the same as there.
 */
#ifndef nephoscope_CellSamples_h
#define nephoscope_CellSamples_h

#include "CellShares.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <vector>

class vtkDataSet;

namespace nephoscope
{

class CellSamples
{
public:
  /** Looks at every cell once. Hidden cells and lines do not count. */
  void Find(vtkDataSet* data, bool onCells);

  bool IsEmpty() const { return this->Shapes.empty(); }
  /** Every sample that is shown has a shape. */
  bool IsComplete() const
  {
    const auto hasShape = [](const std::array<float, 9>& shape) { return shape[0] != 0; };
    return !this->IsEmpty() && std::all_of(this->Shapes.begin(), this->Shapes.end(), hasShape);
  }
  /**
   * A point in the place of another that stands for both: at a seam, a pole, or where every cell
   * has points of its own.
   */
  bool IsRepeated(vtkIdType id) const
  {
    return !this->Places.empty() && this->Places[static_cast<std::size_t>(id)] != id;
  }
  /**
   * A cell without an extent, as filters leave where they cut a mesh in its corners, or a point of
   * nothing but such cells.
   */
  bool IsNothing(vtkIdType id) const { return this->Share(id) == 0.0; }
  /** False where there are no cells around a point. */
  bool Get(vtkIdType id, SplatMatrix& jacobian) const;
  /**
   * The part of that shape's volume that the cells fill: less than 1 on the boundary, 0 if they
   * have none.
   */
  double Share(vtkIdType id) const
  {
    return this->Parts.empty() ? 1.0 : double(this->Parts[static_cast<std::size_t>(id)]);
  }

private:
  void FillIn(vtkDataSet* data, const CellShares& found, bool onCells);
  bool FillInAxes(vtkDataSet* data, const CellShares& found, std::size_t i);
  void SetShape(std::size_t i, const SplatMatrix& jacobian);
  void Blur(const CellShares& found);

  std::vector<std::array<float, 9>> Shapes; // empty if the data have no cells
  std::vector<float> Parts;                 // of their volumes; empty if the data have no cells
  std::vector<bool> OfGrid;                 // points with the axes of a grid; empty: none
  std::vector<vtkIdType> Places; // of each point the first one in its place; empty: all are apart
};

} // namespace nephoscope

#endif
