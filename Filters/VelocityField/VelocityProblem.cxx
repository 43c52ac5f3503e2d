// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VelocityProblem.h"

#include "StructuredFields.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace nephoscope
{
namespace
{
std::string ListOf(vtkDataSetAttributes* attributes, const char* kind)
{
  std::string list;
  for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = attributes->GetArray(a);
    if (array && array->GetName() && array->GetNumberOfComponents() == 3)
    {
      list += (list.empty() ? "'" : ", '") + std::string(array->GetName()) + "'";
    }
  }
  return std::string(kind) + " arrays of three components: " + (list.empty() ? "none" : list);
}

std::string Choices(vtkDataSet* data)
{
  return " Choose a velocity: " + ListOf(data->GetPointData(), "point") + "; " +
    ListOf(data->GetCellData(), "cell") +
    ". To combine three arrays of one component, use the Calculator: u*iHat + v*jHat + w*kHat.";
}

std::string ArrayProblem(vtkDataSet* data, const VelocityArray& wanted)
{
  vtkDataSetAttributes* here = data->GetPointData();
  vtkDataSetAttributes* there = data->GetCellData();
  std::string kind = "point";
  std::string otherKind = "cell";
  if (wanted.OnCells)
  {
    std::swap(here, there);
    std::swap(kind, otherKind);
  }
  const std::string name = " array '" + wanted.Name + "'";
  const vtkDataArray* array = here->GetArray(wanted.Name.c_str());
  if (!array && there->GetArray(wanted.Name.c_str()))
  {
    return "There is no " + kind + name + ", but there is a " + otherKind +
      " array of that name: choose it as the " + otherKind + " array.";
  }
  if (!array)
  {
    return "There is no " + kind + name + "." + Choices(data);
  }
  const int components = array->GetNumberOfComponents();
  if (components != 3)
  {
    return "The " + kind + name + " has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + "; a velocity has three." + Choices(data);
  }
  return std::string();
}

bool HasVolume(vtkDataSet* data)
{
  std::array<bool, 256> seen{};
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    const int type = data->GetCellType(i);
    if (type >= 0 && type < 256 && !seen[static_cast<std::size_t>(type)])
    {
      seen[static_cast<std::size_t>(type)] = true;
      cell->SetCellType(type);
      if (cell->GetCellDimension() == 3)
      {
        return true;
      }
    }
  }
  return false;
}

std::string ShapeProblem(vtkDataSet* data)
{
  if (data->GetNumberOfPoints() == 0 || data->GetNumberOfCells() == 0)
  {
    return "The dataset is empty: it has no cells. Check the reader or filter that it comes from.";
  }
  int n[3];
  if (StructuredSize(data, n))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (n[axis] < 2)
      {
        return "The grid is flat: it has " + std::to_string(n[0]) + " x " + std::to_string(n[1]) +
          " x " + std::to_string(n[2]) +
          " points. The flow is followed through cells that have a volume: give at least two points along "
          "each axis, for example more than one level in the reader.";
      }
    }
    return std::string();
  }
  return HasVolume(data)
    ? std::string()
    : "The dataset has no cells with a volume, only surfaces, lines or points. Give "
      "the volume mesh, or make one with Delaunay 3D.";
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

double DistanceToBounds(vtkDataSet* set, vtkIdType cell, const Vector3& position)
{
  double bounds[6];
  set->GetCellBounds(cell, bounds);
  Vector3 offset{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double x = position[axis];
    offset[axis] = x - std::min(std::max(x, bounds[2 * axis]), bounds[2 * axis + 1]);
  }
  return Norm(offset);
}

bool IsBlanked(vtkDataSet* set, vtkIdType cell)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    set->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL);
}
}

NearestCell FindNearestCell(const std::vector<vtkDataSet*>& sets, const Vector3& position)
{
  NearestCell nearest;
  vtkNew<vtkGenericCell> cell;
  for (vtkDataSet* set : sets)
  {
    std::vector<double> weights(static_cast<std::size_t>(std::max(8, set->GetMaxCellSize())));
    for (vtkIdType i = 0; i < set->GetNumberOfCells(); ++i)
    {
      if (IsBlanked(set, i) || DistanceToBounds(set, i, position) >= nearest.Distance)
      {
        continue;
      }
      set->GetCell(i, cell);
      Vector3 middle{};
      double parametric[3];
      int part = cell->GetParametricCenter(parametric);
      cell->EvaluateLocation(part, parametric, middle.data(), weights.data());
      const double distance = Norm(middle - position);
      if (cell->GetCellDimension() == 3 && distance < nearest.Distance)
      {
        nearest = { distance, middle };
      }
    }
  }
  return nearest;
}

std::string VelocityProblem(vtkDataSet* data, const VelocityArray& array)
{
  const std::string shape = ShapeProblem(data);
  return shape.empty() ? ArrayProblem(data, array) : shape;
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
      return "The cell at " + Written(position) +
        " is blanked: move the polygon into visible cells.";
    }
  }
  return {};
}

std::string WhyOutside(const vtkBoundingBox& box, const Vector3& nearest, const Vector3& position)
{
  std::ostringstream sentence;
  if (box.ContainsPoint(position[0], position[1], position[2]))
  {
    sentence
      << Written(position)
      << " is in no cell, although it is within the bounds of the data: it is in a hole, such as "
         "a body or the ground. The nearest cell is around "
      << Written(nearest) << ": move the polygon there, by Center if it is regular.";
    return sentence.str();
  }
  double bounds[6];
  box.GetBounds(bounds);
  sentence << Written(position) << " is outside the data, which are within x " << bounds[0]
           << " to " << bounds[1] << ", y " << bounds[2] << " to " << bounds[3] << ", z "
           << bounds[4] << " to " << bounds[5] << ": move the polygon into them.";
  return sentence.str();
}
}
