// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets.h"

#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nephoscope
{
namespace
{
template <typename Function>
void ForEachLeaf(vtkCompositeDataSet* composite, Function&& function)
{
  auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    function(leaves.Get(), leaves->GetCurrentDataObject());
  }
}

vtkSmartPointer<vtkDataObject> SharedCopyOfOne(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

std::string Written(const Vector3& position)
{
  std::ostringstream place;
  place << "(" << position[0] << ", " << position[1] << ", " << position[2] << ")";
  return place.str();
}

// Blanked cells too: some versions of VTK do not find them.
vtkIdType CellAt(vtkDataSet* blanked, const Vector3& position)
{
  auto set = vtkSmartPointer<vtkDataSet>::Take(blanked->NewInstance());
  set->CopyStructure(blanked);
  set->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(static_cast<std::size_t>(std::max(8, set->GetMaxCellSize())));
  double point[3] = { position[0], position[1], position[2] };
  double parametric[3];
  int part = 0;
  return set->FindCell(point, nullptr, cell, -1, 0.0, part, parametric, weights.data());
}

bool IsBlanked(vtkDataSet* set, vtkIdType cell)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    set->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL);
}
}

std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data)
{
  std::vector<vtkDataSet*> sets;
  const auto add = [&](vtkDataObject* object) {
    auto* set = vtkDataSet::SafeDownCast(object);
    if (set && set->GetNumberOfCells() > 0)
    {
      sets.push_back(set);
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    ForEachLeaf(composite, [&](vtkCompositeDataIterator*, vtkDataObject* leaf) { add(leaf); });
  }
  else
  {
    add(data);
  }
  return sets;
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
    double place[3];
    set->GetPoint(point, place);
    if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))
    {
      box.AddPoint(place);
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
  vtkMTimeType newest = data->GetMTime();
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    ForEachLeaf(composite, [&](vtkCompositeDataIterator*, vtkDataObject* leaf) {
      newest = std::max(newest, leaf->GetMTime());
    });
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
  ForEachLeaf(composite, [&](vtkCompositeDataIterator* place, vtkDataObject* leaf) {
    copy->SetDataSet(place, SharedCopyOfOne(leaf));
  });
  return copy;
}

std::string WhyNoVelocityInside(const std::vector<vtkDataSet*>& sets, const Vector3& position)
{
  for (vtkDataSet* set : sets)
  {
    const vtkIdType cell = CellAt(set, position);
    if (cell >= 0 && !IsBlanked(set, cell))
    {
      return "The velocity at " + Written(position) + " is not a finite number (cell " +
        std::to_string(cell) + "): move the polygon, or replace the missing values.";
    }
    if (cell >= 0)
    {
      return "The cell at " + Written(position) + " is blanked: move the polygon into visible cells.";
    }
  }
  return {};
}

std::string WhyOutside(const vtkBoundingBox& box, const Vector3& position)
{
  double bounds[6];
  box.GetBounds(bounds);
  std::ostringstream sentence;
  sentence << Written(position) << " is outside the data, which are within x " << bounds[0] << " to "
           << bounds[1] << ", y " << bounds[2] << " to " << bounds[3] << ", z " << bounds[4] << " to "
           << bounds[5] << ": move the polygon into them.";
  return sentence.str();
}
}
