// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One polyhedral cell to tetrahedra. One object per thread.
 *
 *   surface ──► convex but for warp, and filled by its cone (PolyhedronConvexity.h)?
 *      │            ──► leave it whole
 *      │
 *   triangles of the faces, the same from both sides (FaceTriangulation.h)
 *      │
 *   1. cone from a vertex that sees all other triangles from well inside: no new point
 *   2. cone from the middle of the kernel (KernelPoint.h): one new point
 *   3. TetGen (TetGenDivision.h): new points inside, where it needs them
 *
 * Cones over the triangles of a closed surface add up, with their signs, to the inside of it: where
 * all are positive they fill the cell without overlap. Steps 1 and 2 are therefore correct whenever
 * their signs are, whatever the shape.
 */
#ifndef nephoscope_PolyhedronDivider_h
#define nephoscope_PolyhedronDivider_h

#include "CellDivision.h"
#include "PolyhedronConvexity.h"
#include "TetGenDivision.h"

#include <string>

namespace nephoscope
{

enum class DivisionOutcome
{
  Whole,       ///< convex: nothing to do
  Divided,     ///< into tetrahedra
  NotFinite,   ///< a coordinate is not finite
  NotClosed,   ///< the faces do not close
  NotOriented, ///< the faces are one-sided
  BadFace,     ///< a face has no area or crosses itself
  NotStar,     ///< no point sees the whole inside: a task for TetGen
  Failed       ///< TetGen has found no division
};

struct DivisionOptions
{
  bool DivideConvex = false;  ///< convex cells too
  double WarpTolerance = 0.1; ///< see IsConvexButForWarp
  bool IsFloat = false;       ///< coordinates are stored in 32 bits
};

class PolyhedronDivider
{
public:
  explicit PolyhedronDivider(const DivisionOptions& options)
    : Options(options)
  {
  }
  PolyhedronDivider(const PolyhedronDivider&) = delete; // a task points into it
  void operator=(const PolyhedronDivider&) = delete;

  /** Everything but TetGen. */
  template <typename Index, typename Place>
  DivisionOutcome Divide(FaceList<Index> faces, Place place)
  {
    const PolyhedronSurface::State state = this->Surface.Build(faces, place);
    return state == PolyhedronSurface::State::Closed ? this->DivideSurface() : OutcomeOf(state);
  }

  /**
   * After NotStar: the input for TetGen, and the check of its result. `reason` says why it is
   * Failed.
   */
  TetGenTask MakeTask() { return { &this->Cut, &this->Division, std::string() }; }
  DivisionOutcome Judge(const TetGenTask& task, std::string& reason);

  /** After Divided. */
  CellDivision& GetDivision() { return this->Division; }

private:
  static DivisionOutcome OutcomeOf(PolyhedronSurface::State state);
  DivisionOutcome DivideSurface();
  bool CutFaces();
  bool WarpedFacesAreFans(double slack);
  bool ConeFromVertex(double smallestHeight);
  bool ConeFromKernel(double smallestHeight);
  void AddCone(int apex);
  double LowestHeight(int apex) const;
  void FinishDivision();

  DivisionOptions Options;
  PolyhedronSurface Surface;
  TriangulatedSurface Cut;
  FaceTriangulation Triangulation;
  CellDivision Division;
};

} // namespace nephoscope

#endif
