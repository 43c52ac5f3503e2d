// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets.h"

#include "Vector3.h"

#include "vtkBoundingBox.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
vtkSmartPointer<vtkDataObject> SharedCopyOfOne(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}
}

std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> sets;
  ForEachLeaf(data, [&](vtkDataObject* leaf) {
    auto* set = vtkDataSet::SafeDownCast(leaf);
    if (set && set->GetNumberOfCells() > 0)
    {
      sets.push_back(set);
    }
  });
  return sets;
}

bool HasOnlyVertices(vtkDataSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    if (type != VTK_VERTEX && type != VTK_POLY_VERTEX && type != VTK_EMPTY_CELL)
    {
      return false;
    }
  }
  return true;
}

bool IsStructured(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
    vtkStructuredGrid::SafeDownCast(data);
}

vtkBoundingBox FiniteBounds(vtkDataSet* set)
{
  double bounds[6];
  set->GetBounds(bounds);
  if (std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); }))
  {
    return vtkBoundingBox(bounds);
  }
  vtkBoundingBox box;
  for (vtkIdType point = 0; point < set->GetNumberOfPoints(); ++point)
  {
    Vector3 x;
    set->GetPoint(point, x.data());
    if (IsFinite(x))
    {
      box.AddPoint(x.data());
    }
  }
  return box;
}

vtkBoundingBox BoundsOf(const std::vector<vtkDataSet*>& sets)
{
  vtkBoundingBox box;
  for (vtkDataSet* set : sets)
  {
    box.AddBox(FiniteBounds(set));
  }
  return box;
}

vtkMTimeType NewestMTime(vtkDataObject* data)
{
  vtkMTimeType newest = data ? data->GetMTime() : 0;
  if (data)
  {
    ForEachLeaf(data, [&](vtkDataObject* leaf) { newest = std::max(newest, leaf->GetMTime()); });
  }
  return newest;
}

vtkSmartPointer<vtkDataObject> SharedCopy(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return SharedCopyOfOne(data);
  }
  auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    copy->SetDataSet(leaves, SharedCopyOfOne(leaves->GetCurrentDataObject()));
  }
  return copy;
}
}
