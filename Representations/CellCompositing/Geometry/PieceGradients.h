// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Gradients over a mesh of which each process has a piece: as PointGradients.h finds them where one has it all.
 *
 * Sums over the edges of cells add up. At the places that several pieces have in common, each process therefore sends the sums of its own cells to the others
 * (Send), and adds those that it gets (Add). Ghost cells do not count: another process sends their sums.
 */
#ifndef PieceGradients_h
#define PieceGradients_h

#include "PointGradients.h"

#include "vtkNephoscopeRepresentationsCellCompositingModule.h" // for export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>

class vtkBoundingBox;
class vtkDataArray;
class vtkFloatArray;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT PieceGradients
{
public:
  /** What is sent: a place, and sums. */
  struct SumsAtPlace
  {
    std::array<double, 3> Where;
    GradientSums Sums;
  };

  /** `scalars`: of several components the magnitude counts; null in a piece without cells. Its range and the centre of the mesh are those of all pieces together. */
  PieceGradients(
    vtkDataSet* piece, vtkDataArray* scalars, const double range[2], const double center[3]);

  /** The points with these numbers that lie in one of the boxes of other pieces may be theirs, too. */
  void FindShared(const std::vector<vtkIdType>& points, std::vector<vtkBoundingBox> others);
  std::vector<SumsAtPlace> Send() const;
  void Add(const std::vector<SumsAtPlace>& others);

  /** The point array, called storedGradientsName. */
  vtkSmartPointer<vtkFloatArray> Solve() const;

private:
  vtkDataSet* Piece;
  std::vector<std::int32_t> Places; // of points: the first that is there
  std::vector<std::array<float, 3>> Positions;
  std::vector<GradientSums> Sums;
  std::map<std::array<float, 3>, std::size_t> Shared; // places
};

} // namespace nephoscope

#endif
