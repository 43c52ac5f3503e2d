// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** How the cells become a picture; the values of vtkCellCompositingMapper::MethodType. */
#ifndef nephoscope_CellMethod_h
#define nephoscope_CellMethod_h

namespace nephoscope
{

enum class CellMethod
{
  Cells = 0, ///< or projection
  Rays = 1,
  TrianglesLinear = 2,
  TrianglesTable = 3,
  Faces = 4,
  Automatic = 5
};

} // namespace nephoscope

#endif
