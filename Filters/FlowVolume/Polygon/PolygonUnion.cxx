// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonUnion.h"

#include "VelocityField.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <set>

namespace nephoscope
{
namespace
{
using Corners = std::vector<Vector3>;

// Corner positions, polygon by polygon.
std::vector<Corners> PolygonsOf(vtkPolyData* part)
{
  std::vector<Corners> polygons;
  auto cells = vtk::TakeSmartPointer(part->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    Corners corners(static_cast<std::size_t>(count));
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      part->GetPoint(ids[c], corners[c].data());
    }
    polygons.push_back(corners);
  }
  return polygons;
}

// Polygons that meet in the positions of their corners.
class Joint
{
public:
  void Add(const Corners& polygon)
  {
    Corners key = polygon;
    std::sort(key.begin(), key.end());
    if (!this->Added.insert(key).second)
    {
      return;
    }
    this->Cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Vector3& corner : polygon)
    {
      const auto id = this->Ids.emplace(corner, this->Points->GetNumberOfPoints());
      if (id.second)
      {
        this->Points->InsertNextPoint(corner.data());
      }
      this->Cells->InsertCellPoint(id.first->second);
    }
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    auto whole = vtkSmartPointer<vtkPolyData>::New();
    whole->SetPoints(this->Points);
    whole->SetPolys(this->Cells);
    return whole;
  }

  Joint() { this->Points->SetDataTypeToDouble(); }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  std::set<Corners> Added;
  std::map<Vector3, vtkIdType> Ids;
};
}

vtkSmartPointer<vtkPolyData> BarePolygons(vtkPolyData* polygon)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  if (polygon && polygon->GetNumberOfCells() > 0)
  {
    bare->CopyStructure(polygon);
  }
  return bare;
}

vtkSmartPointer<vtkPolyData> UnitePolygons(const std::vector<vtkSmartPointer<vtkDataObject>>& parts)
{
  vtkSmartPointer<vtkPolyData> first;
  std::set<std::vector<Corners>> different;
  for (const auto& part : parts)
  {
    auto* polygon = vtkPolyData::SafeDownCast(part);
    if (polygon && polygon->GetNumberOfCells() > 0)
    {
      first = first ? first : vtkSmartPointer<vtkPolyData>(polygon);
      different.insert(PolygonsOf(polygon));
    }
  }
  if (different.size() < 2)
  {
    return first ? first : vtkSmartPointer<vtkPolyData>::New();
  }
  Joint joint;
  for (const auto& part : parts)
  {
    if (auto* polygon = vtkPolyData::SafeDownCast(part))
    {
      for (const Corners& corners : PolygonsOf(polygon))
      {
        joint.Add(corners);
      }
    }
  }
  return joint.Make();
}
}
