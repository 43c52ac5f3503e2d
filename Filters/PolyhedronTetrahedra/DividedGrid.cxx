// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DividedGrid.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>

namespace nephoscope
{
namespace
{
vtkSmartPointer<vtkPoints> WithNewPoints(
  vtkPoints* old, const CellDivisions& divisions, vtkIdType added)
{
  if (added == 0)
  {
    return old;
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(old->GetDataType());
  const vtkIdType n = old->GetNumberOfPoints();
  points->SetNumberOfPoints(n + added);
  points->GetData()->InsertTuples(0, n, 0, old->GetData());
  vtkIdType next = n;
  for (const auto& division : divisions)
  {
    for (std::size_t k = 0; division && k < division->NewPoints.size(); ++k)
    {
      points->SetPoint(next++, division->NewPoints[k].data());
    }
  }
  return points;
}

/** Copies the cells, and of each new cell the number of the old one. */
class CellWriter
{
public:
  CellWriter(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output, vtkIdList* parents)
    : Input(input)
    , Output(output)
    , Parents(parents)
    , NextNewPoint(input->GetNumberOfPoints())
  {
  }

  void Write(vtkIdType cell, const CellDivision* division)
  {
    if (division)
    {
      this->WriteTetrahedra(cell, *division);
      return;
    }
    const int type = this->Input->GetCellType(cell);
    if (type == VTK_POLYHEDRON)
    {
      this->Input->GetFaceStream(cell, this->Ids);
    }
    else
    {
      this->Input->GetCellPoints(cell, this->Ids);
    }
    this->Output->InsertNextCell(type, this->Ids);
    this->Parents->InsertNextId(cell);
  }

private:
  void WriteTetrahedra(vtkIdType cell, const CellDivision& division)
  {
    const auto old = static_cast<int>(division.PointIds.size());
    for (const std::array<int, 4>& t : division.Tetrahedra)
    {
      vtkIdType ids[4];
      for (std::size_t k = 0; k < 4; ++k)
      {
        ids[k] = t[k] < old
          ? static_cast<vtkIdType>(division.PointIds[static_cast<std::size_t>(t[k])])
          : this->NextNewPoint + t[k] - old;
      }
      this->Output->InsertNextCell(VTK_TETRA, 4, ids);
      this->Parents->InsertNextId(cell);
    }
    this->NextNewPoint += static_cast<vtkIdType>(division.NewPoints.size());
  }

  vtkUnstructuredGrid* Input;
  vtkUnstructuredGrid* Output;
  vtkIdList* Parents;
  vtkIdType NextNewPoint;
  vtkNew<vtkIdList> Ids;
};

void CarryCellArrays(vtkCellData* input, vtkIdList* parents, vtkCellData* output)
{
  output->CopyGlobalIdsOff();
  output->CopyAllocate(input, parents->GetNumberOfIds());
  for (vtkIdType i = 0; i < parents->GetNumberOfIds(); ++i)
  {
    output->CopyData(input, parents->GetId(i), i);
  }
  if (vtkDataArray* ids = input->GetGlobalIds())
  {
    auto plain = vtkSmartPointer<vtkDataArray>::Take(ids->NewInstance());
    plain->SetName(ids->GetName());
    plain->InsertTuplesStartingAt(0, parents, ids);
    output->AddArray(plain);
  }
}

// What can be no mean of others.
enum class ArrayKind
{
  Field,
  Ghosts,
  Ids
};

ArrayKind KindOf(vtkPointData* data, int index)
{
  const char* name = data->GetArrayName(index);
  const int attribute = data->IsArrayAnAttribute(index);
  if (name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0)
  {
    return ArrayKind::Ghosts;
  }
  return attribute == vtkDataSetAttributes::GLOBALIDS ||
      attribute == vtkDataSetAttributes::PEDIGREEIDS
    ? ArrayKind::Ids
    : ArrayKind::Field;
}

void Interpolate(
  vtkAbstractArray* from, const CellDivisions& divisions, vtkIdType next, vtkAbstractArray* to)
{
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  for (const auto& division : divisions)
  {
    for (std::size_t k = 0; division && k < division->NewPoints.size(); ++k)
    {
      ids->Reset();
      weights.clear();
      for (std::size_t v = 0; v < division->PointIds.size(); ++v)
      {
        if (division->Weights[k][v] !=
          0) // so that a value that is not finite spreads no further than it must
        {
          ids->InsertNextId(static_cast<vtkIdType>(division->PointIds[v]));
          weights.push_back(division->Weights[k][v]);
        }
      }
      to->InterpolateTuple(next++, ids, from, weights.data());
    }
  }
}

void CarryPointArrays(vtkPointData* input, const CellDivisions& divisions, vtkIdType old,
  vtkIdType added, vtkPointData* output)
{
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* from = input->GetAbstractArray(a);
    const ArrayKind kind = KindOf(input, a);
    auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->CopyComponentNames(from);
    to->SetNumberOfTuples(old + added);
    to->InsertTuples(0, old, 0, from);
    auto numbers = vtkDataArray::SafeDownCast(to);
    if (kind == ArrayKind::Field || !numbers)
    {
      Interpolate(from, divisions, old, to);
    }
    for (vtkIdType i = old; kind != ArrayKind::Field && numbers && i < old + added; ++i)
    {
      for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      {
        numbers->SetComponent(i, c, kind == ArrayKind::Ghosts ? 0 : -1);
      }
    }
    output->AddArray(to);
    const int attribute = input->IsArrayAnAttribute(a);
    if (attribute >= 0 && kind != ArrayKind::Ids)
    {
      output->SetActiveAttribute(output->GetNumberOfArrays() - 1, attribute);
    }
  }
}
}

vtkIdType BuildDividedGrid(
  vtkUnstructuredGrid* input, const CellDivisions& divisions, vtkUnstructuredGrid* output)
{
  vtkIdType added = 0, cells = 0;
  for (const auto& division : divisions)
  {
    added += division ? static_cast<vtkIdType>(division->NewPoints.size()) : 0;
    cells += division ? static_cast<vtkIdType>(division->Tetrahedra.size()) : 1;
  }
  output->Initialize();
  output->SetPoints(WithNewPoints(input->GetPoints(), divisions, added));
  output->Allocate(cells);
  vtkNew<vtkIdList> parents;
  parents->Allocate(cells);
  CellWriter writer(input, output, parents);
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    writer.Write(cell, divisions[static_cast<std::size_t>(cell)].get());
  }
  CarryCellArrays(input->GetCellData(), parents, output->GetCellData());
  if (added == 0)
  {
    output->GetPointData()->ShallowCopy(input->GetPointData());
  }
  else
  {
    CarryPointArrays(
      input->GetPointData(), divisions, input->GetNumberOfPoints(), added, output->GetPointData());
  }
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  return added;
}

} // namespace nephoscope
