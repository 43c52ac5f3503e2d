// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The surfaces and the density volume of all ranks, on each of them: what lies along a ray, whoever
 * has it. A client that draws joins the pieces that it has been given (RankPieces.h).
 */
#ifndef nephoscope_RankUnion_h
#define nephoscope_RankUnion_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <string>

class vtkDataObject;
class vtkMultiBlockDataSet;

namespace nephoscope
{

/**
 * The surfaces of all ranks, without ghost cells, in the order of the ranks. Each rank gets those
 * of every other one. Collective.
 */
vtkSmartPointer<vtkMultiBlockDataSet> SurfacesOfRanks(vtkDataObject* own);

/**
 * The grids of all ranks with one array, `name`, or the active scalars where it is empty. The
 * pieces of an image are one image again, which is drawn voxel by voxel as that of one rank is.
 * Collective.
 */
vtkSmartPointer<vtkMultiBlockDataSet> DensitiesOfRanks(vtkDataObject* own, const std::string& name);

/** Exchanges data again only where those of some rank, or the name, are others than before. */
class RankUnion
{
public:
  using Exchange =
    std::function<vtkSmartPointer<vtkMultiBlockDataSet>(vtkDataObject* own, const std::string&)>;

  /** Collective. `own` may be null. */
  vtkMultiBlockDataSet* Of(vtkDataObject* own, const std::string& name, const Exchange& exchange);

private:
  vtkSmartPointer<vtkMultiBlockDataSet> Whole;
  vtkDataObject* From = nullptr; // not to be looked into
  vtkMTimeType Time = 0;
  std::string Name;
};

} // namespace nephoscope

#endif
