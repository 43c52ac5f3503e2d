// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The classes that proxies of the suite make: filters, sources, readers, writers and
// representations. The definitions of the proxies call each vtkX "vtkXWithLabels", for which
// LabelsInMessages.cxx makes a vtkX that says the labels of the panel.
#ifndef nephoscope_ClassesOfSuite_h
#define nephoscope_ClassesOfSuite_h

#include <cstring>

#define NEPHOSCOPE_FOR_CLASSES_OF_SUITE(DO) \
  DO(vtkCellCompositingRepresentation)      \
  DO(vtkCloudOptics)                        \
  DO(vtkCloudSurface)                       \
  DO(vtkCloudTextureRepresentation)         \
  DO(vtkCloudsOverGlobe)                    \
  DO(vtkContourCellSplitter)                \
  DO(vtkGlobeGrid)                          \
  DO(vtkGlobeTerrain)                       \
  DO(vtkHazeRepresentation)                 \
  DO(vtkPVFlowVolume)                       \
  DO(vtkPolyhedronToTetrahedra)             \
  DO(vtkSmokePuffs)                         \
  DO(vtkSparseVolumeReader)                 \
  DO(vtkSparseVolumeWriter)                 \
  DO(vtkStructuredSmoothing)                \
  DO(vtkSunRepresentation)                  \
  DO(vtkSunSource)                          \
  DO(vtkSunlight)                           \
  DO(vtkTextureCoordinateAdvection)         \
  DO(vtkTexturedSplatsRepresentation)

namespace nephoscope
{
inline bool IsOfSuite(const char* classOfProxy)
{
#define NEPHOSCOPE_IS(CLASS) || std::strcmp(classOfProxy, #CLASS "WithLabels") == 0
  return classOfProxy && (false NEPHOSCOPE_FOR_CLASSES_OF_SUITE(NEPHOSCOPE_IS));
#undef NEPHOSCOPE_IS
}
}

#endif
