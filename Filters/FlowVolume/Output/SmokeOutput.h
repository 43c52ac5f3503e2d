// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh of smoke as VTK's grid.
#ifndef nephoscope_SmokeOutput_h
#define nephoscope_SmokeOutput_h

#include "SmokeMesh.h"

#include <functional>

class vtkPointData;
class vtkUnstructuredGrid;

namespace nephoscope
{
// Interpolates the arrays of the input to the points of a mesh.
using ArraySampler = std::function<void(const SmokeMesh& mesh, vtkPointData* output)>;

// Points, tetrahedra, cell arrays EmissionStep, Age, Density, the densities at points and other
// point arrays. True if the input has a point array Age, which is replaced.
bool PutSmoke(const SmokeMesh& mesh, double initialDensity, const ArraySampler& sampleArrays,
  vtkUnstructuredGrid* output);
}

#endif
