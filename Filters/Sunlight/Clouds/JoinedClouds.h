// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds of several datasets, and of several ranks, as one mesh.
#ifndef nephoscope_JoinedClouds_h
#define nephoscope_JoinedClouds_h

#include "LitData.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace nephoscope
{
/** The array of an optical property. `Otherwise` takes its place if there is none. */
struct OpticalArray
{
  std::string Name;
  double Otherwise, Scale;
};
using OpticalArrays = std::array<OpticalArray, 3>; ///< extinction, albedo, asymmetry

/** One of the datasets. */
struct CloudPart
{
  /** Reads the optics of the data. Their extinction may be on points or cells. */
  CloudPart(vtkDataSet* data, const OpticalArrays& arrays);

  vtkWeakPointer<vtkDataSet> Data;
  OpticalFields Optics;       ///< on its points: of the array, or means of the cells around each
  std::vector<float> Weights; ///< numbers of these cells; empty: the array is on points
  vtkIdType Wrong = 0;        ///< values that are negative or missing
  std::vector<std::int32_t> Numbers; ///< of its points in the mesh
};

struct JoinedClouds
{
  std::vector<CloudPart> Parts;              ///< of this rank
  vtkSmartPointer<vtkUnstructuredGrid> Mesh; ///< of all parts; coincident points are one
  OpticalFields Optics;                      ///< on its points, means of coincident ones

  /**
   * Makes the mesh, without ghost cells that another part or rank has. If `ranks` is not null, all
   * of them must call it, and each gets the mesh of all.
   */
  void Join(vtkMultiProcessController* ranks);
};
}

#endif
