// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** CellGeometry of a dataset, and what tests ask of it. */
#ifndef nephoscope_BuiltGeometry_h
#define nephoscope_BuiltGeometry_h

#include "CellGeometry.h"

#include "TestGrids.h"

#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace nephoscope_test
{

using namespace nephoscope;

inline double VolumeOf(const CellGeometry& geometry)
{
  double sum = 0;
  for (std::size_t i = 0; i < geometry.Tetrahedra.size(); ++i)
  {
    const std::array<Vector3, 4> p = geometry.Vertices(i);
    sum += std::fabs(
             Dot(Cross(Difference(p[1], p[0]), Difference(p[2], p[0])), Difference(p[3], p[0]))) /
      6;
  }
  return sum;
}

inline CellGeometry Build(
  vtkDataSet* data, vtkDataArray* array, bool onCells = false, int component = -1)
{
  CellGeometry geometry;
  EXPECT_EQ(geometry.Build(data, { array, onCells, component }), "");
  return geometry;
}

inline CellGeometry BuildNumbered(vtkDataSet* data)
{
  return Build(data, AddPointNumbers(data));
}

inline double ScalarOf(const CellGeometry& geometry, float normalised)
{
  return geometry.ScalarRange[0] + normalised * (geometry.ScalarRange[1] - geometry.ScalarRange[0]);
}

inline void HideCell(
  vtkDataSet* data, vtkIdType cell, unsigned char flag = vtkDataSetAttributes::HIDDENCELL)
{
  data->AllocateCellGhostArray()->SetValue(cell, flag);
}

/** The unit cube as one cell of each linear type, or cut into several of them. */
inline vtkSmartPointer<vtkUnstructuredGrid> UnitCubeOf(int type)
{
  const std::vector<std::array<double, 3>> p = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 1, 1, 1 } }, { { 0, 1, 1 } },
    { { 0.5, 0.5, 0.5 } } };
  switch (type)
  {
    case VTK_TETRA:
      return MakeGrid(p,
        { { type, { 0, 1, 3, 4 } }, { type, { 1, 2, 3, 6 } }, { type, { 1, 5, 4, 6 } },
          { type, { 3, 4, 6, 7 } }, { type, { 1, 3, 4, 6 } } });
    case VTK_VOXEL:
      return MakeGrid(p, { { type, { 0, 1, 3, 2, 4, 5, 7, 6 } } });
    case VTK_WEDGE:
      return MakeGrid(p, { { type, { 0, 1, 2, 4, 5, 6 } }, { type, { 0, 2, 3, 4, 6, 7 } } });
    case VTK_PYRAMID:
      return MakeGrid(p,
        { { type, { 0, 1, 2, 3, 8 } }, { type, { 4, 5, 6, 7, 8 } }, { type, { 0, 1, 5, 4, 8 } },
          { type, { 3, 2, 6, 7, 8 } }, { type, { 0, 3, 7, 4, 8 } }, { type, { 1, 2, 6, 5, 8 } } });
    default:
      return MakeGrid(p, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  }
}

} // namespace nephoscope_test

#endif
