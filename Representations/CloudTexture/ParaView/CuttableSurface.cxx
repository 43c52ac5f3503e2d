// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CuttableSurface.h"

#include "IdsAsNumbers.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <numeric>
#include <vector>

namespace nephoscope
{
namespace
{
// For each new cell the polygon that it comes from, counted from 0.
std::vector<vtkIdType> insertFans(vtkCellArray* polygons, vtkCellArray* triangles)
{
  std::vector<vtkIdType> sources;
  auto each = vtk::TakeSmartPointer(polygons->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* corners;
    each->GetCurrentCell(size, corners);
    if (size <= 3)
    {
      triangles->InsertNextCell(size, corners);
      sources.push_back(each->GetCurrentCellId());
    }
    for (vtkIdType i = 1; size > 3 && i + 1 < size; ++i)
    {
      triangles->InsertNextCell({ corners[0], corners[i], corners[i + 1] });
      sources.push_back(each->GetCurrentCellId());
    }
  }
  return sources;
}

// Cells are vertices, lines, polygons, strips, in this order.
void copyCellData(vtkPolyData* surface, const std::vector<vtkIdType>& sources)
{
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const vtkIdType after = before + surface->GetNumberOfPolys();
  const auto count = static_cast<vtkIdType>(sources.size());
  vtkNew<vtkCellData> data;
  vtkCellData* old = surface->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(old, before + count + surface->GetNumberOfStrips());
  data->CopyData(old, 0, before, 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    data->CopyData(old, before + sources[static_cast<std::size_t>(i)], before + i);
  }
  data->CopyData(old, before + count, surface->GetNumberOfStrips(), after);
  old->ShallowCopy(data);
}
} // namespace

void fanPolygons(vtkPolyData* surface)
{
  vtkCellArray* polygons = surface->GetPolys();
  if (!polygons || polygons->GetMaxCellSize() <= 3)
  {
    return;
  }
  vtkNew<vtkCellArray> triangles;
  const std::vector<vtkIdType> sources = insertFans(polygons, triangles);
  copyCellData(surface, sources);
  surface->SetPolys(triangles);
  surface->DeleteCells();
}

void keepPointsApart(vtkPolyData* surface, int rank)
{
  constexpr vtkIdType mostPoints = vtkIdType(1) << 40;
  makeIdsNumbers(surface->GetPointData());
  makeIdsNumbers(surface->GetCellData());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("NephoscopePointIds");
  ids->SetNumberOfValues(surface->GetNumberOfPoints());
  std::iota(
    ids->GetPointer(0), ids->GetPointer(0) + surface->GetNumberOfPoints(), rank * mostPoints);
  surface->GetPointData()->SetGlobalIds(ids);
}

} // namespace nephoscope
