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
inline FaceList<int> LinearCellFaces(int cellType)
{
  switch (cellType)
  {
    case VTK_TETRA:
      return MakeFaceList(tetrahedronFaceList);
    case VTK_HEXAHEDRON:
      return MakeFaceList(hexahedronFaceList);
    case VTK_VOXEL:
      return MakeFaceList(voxelFaceList);
    case VTK_WEDGE:
      return MakeFaceList(wedgeFaceList);
    case VTK_PYRAMID:
      return MakeFaceList(pyramidFaceList);
    case VTK_PENTAGONAL_PRISM:
      return MakeFaceList(pentagonalPrismFaceList);
    case VTK_HEXAGONAL_PRISM:
      return MakeFaceList(hexagonalPrismFaceList);
    default:
      return { nullptr, nullptr };
  }
}

} // namespace nephoscope

#endif
