// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The middle of a cell. */
#ifndef nephoscope_CellCenter_h
#define nephoscope_CellCenter_h

#include "Tetrahedron.h"

#include "vtkType.h"

class vtkDataSet;

namespace nephoscope
{
/**
 * The centre of mass of a cell; where it has no volume, or another type, the mean of its corners,
 * each place once: the edge of a hexahedron may have no length.
 */
Vector3 CenterOfCell(vtkDataSet* data, vtkIdType id);
}

#endif
