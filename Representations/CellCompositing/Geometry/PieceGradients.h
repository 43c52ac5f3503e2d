// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Gradients over a mesh of which each process has a piece: as PointGradients.h finds them where one
 * has it all.
 *
 * Sums over the edges of cells add up. At the places that several pieces have in common, each
 * process sends the sums of its own cells to the others, and adds those that it gets. Ghost cells
 * do not count: another process sends their sums.
 */
#ifndef nephoscope_PieceGradients_h
#define nephoscope_PieceGradients_h

#include "PointGradients.h"

#include "vtkNephoscopeRepresentationsCellCompositingModule.h" // for export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataArray;
class vtkFloatArray;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT PieceGradients
{
public:
  /**
   * `scalars`: of several components the magnitude counts; null in a piece without cells. Its range
   * and the centre of the mesh are those of all pieces together.
   */
  PieceGradients(
    vtkDataSet* piece, vtkDataArray* scalars, const double range[2], const double center[3]);

  /** The first of the points that are where this one is. Sums stand there. */
  vtkIdType PlaceOf(vtkIdType point) const { return this->Places[static_cast<std::size_t>(point)]; }
  GradientSums& SumsAt(vtkIdType place) { return this->Sums[static_cast<std::size_t>(place)]; }

  /** The point array, called storedGradientsName. */
  vtkSmartPointer<vtkFloatArray> Solve() const;

private:
  std::vector<std::int32_t> Places;
  std::vector<GradientSums> Sums;
};

} // namespace nephoscope

#endif
