// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tetrahedra of a dataset's cells, one cell after another, divided as vtkCellCompositingMapper divides them.
 */
#ifndef TetrahedronSource_h
#define TetrahedronSource_h

#include "CellDecomposition.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <tuple>

namespace nephoscope
{

inline constexpr unsigned char skippedCells = vtkDataSetAttributes::DUPLICATECELL |
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

inline FaceList<int> facesOf(int cellType)
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
    default:
      return { nullptr, nullptr };
  }
}

/** Gives the tetrahedra of one cell after another. */
class TetrahedronSource
{
public:
  explicit TetrahedronSource(vtkDataSet* data)
    : Data(data)
    , CellGhosts(data->GetCellGhostArray())
    , PointGhosts(data->GetPointGhostArray())
  {
  }

  bool IsHidden(vtkIdType cell)
  {
    if (this->CellGhosts && (this->CellGhosts->GetValue(cell) & skippedCells))
    {
      return true;
    }
    if (!this->PointGhosts)
    {
      return false;
    }
    this->Data->GetCellPoints(cell, this->Ids);
    for (vtkIdType id : *this->Ids)
    {
      if (this->PointGhosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT)
      {
        return true;
      }
    }
    return false;
  }

  template <typename Function>
  void Emit(vtkIdType cell, Function emit)
  {
    const int type = this->Data->GetCellType(cell);
    const FaceList<int> faces = facesOf(type);
    if (faces.Begin)
    {
      this->Data->GetCellPoints(cell, this->Ids);
      this->Cone(faces, this->Ids->GetPointer(0), emit);
    }
    else if (type == VTK_POLYHEDRON)
    {
      this->EmitPolyhedron(cell, emit);
    }
    else
    {
      this->EmitTriangulated(cell, emit);
    }
  }

private:
  template <typename Emit>
  void Cone(FaceList<int> faces, const vtkIdType* ids, Emit emit)
  {
    decomposeCell(
      faces, [&](int a, int b) { return this->Less(ids[a], ids[b]); },
      [&](const std::array<int, 4>& t) {
        emit(std::array<vtkIdType, 4>{ { ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]] } });
      });
  }

  template <typename Emit>
  void EmitPolyhedron(vtkIdType cell, Emit emit)
  {
    auto grid = vtkUnstructuredGrid::SafeDownCast(this->Data);
    if (!grid)
    {
      return;
    }
    grid->GetFaceStream(cell, this->Ids); // number of faces, then the face list
    const vtkIdType* stream = this->Ids->GetPointer(0);
    decomposeCell(
      FaceList<vtkIdType>{ stream + 1, stream + this->Ids->GetNumberOfIds() },
      [&](vtkIdType a, vtkIdType b) { return this->Less(a, b); }, emit);
  }

  template <typename Emit>
  void EmitTriangulated(vtkIdType cell, Emit emit)
  {
    this->Data->GetCell(cell, this->Cell);
    if (this->Cell->GetCellDimension() != 3 || !this->Cell->Triangulate(0, this->Ids, this->CellPoints))
    {
      return;
    }
    for (vtkIdType i = 0; i + 3 < this->Ids->GetNumberOfIds(); i += 4)
    {
      const vtkIdType* t = this->Ids->GetPointer(i);
      emit(std::array<vtkIdType, 4>{ { t[0], t[1], t[2], t[3] } });
    }
  }

  // The mapper's order of vertices: by coordinates, so that it does not depend on numbering, blocks or ranks.
  bool Less(vtkIdType a, vtkIdType b)
  {
    double p[3], q[3];
    this->Data->GetPoint(a, p);
    this->Data->GetPoint(b, q);
    return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
  }

  vtkDataSet* Data;
  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> CellPoints;
  vtkNew<vtkGenericCell> Cell;
};

} // namespace nephoscope

#endif
