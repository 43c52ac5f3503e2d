// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Data in the place that a display's Position, Orientation, Scale and Origin give them. ParaView
 * divides data among ranks, and orders the ranks, by the places that data have without these.
 */
#ifndef nephoscope_MovedData_h
#define nephoscope_MovedData_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkMatrix4x4;

namespace nephoscope
{

/** Whether the matrix does more than scale along the axes; ParaView's order is right then. */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT bool TurnsOrShifts(vtkMatrix4x4* matrix);

/**
 * The data moved, with their vectors; images and rectilinear grids remain such unless they are
 * turned.
 */
VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkSmartPointer<vtkDataSet> MovedData(
  vtkDataSet* data, vtkMatrix4x4* matrix);

/** The bounds of a box that has been moved. */
void MoveBounds(double bounds[6], vtkMatrix4x4* matrix);

} // namespace nephoscope

#endif
