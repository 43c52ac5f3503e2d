// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The faces of VTK's linear 3-D cells, for CellDecomposition.h. */
#ifndef nephoscope_LinearCellFaces_h
#define nephoscope_LinearCellFaces_h

#include "CellDecomposition.h"

#include "vtkCellType.h"

namespace nephoscope
{

/** Faces of VTK's linear 3-D cells; empty for all others. */
inline FaceList<int> linearCellFaces(int cellType)
{
  switch (cellType)
  {
    case VTK_TETRA:
      return makeFaceList(tetrahedronFaceList);
    case VTK_HEXAHEDRON:
      return makeFaceList(hexahedronFaceList);
    case VTK_VOXEL:
      return makeFaceList(voxelFaceList);
    case VTK_WEDGE:
      return makeFaceList(wedgeFaceList);
    case VTK_PYRAMID:
      return makeFaceList(pyramidFaceList);
    case VTK_PENTAGONAL_PRISM:
      return makeFaceList(pentagonalPrismFaceList);
    case VTK_HEXAGONAL_PRISM:
      return makeFaceList(hexagonalPrismFaceList);
    default:
      return { nullptr, nullptr };
  }
}

} // namespace nephoscope

#endif
