// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VelocityProblem.h"

#include "StructuredFields.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <array>

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
    ". Three arrays of one component are put together with the Calculator: u*iHat + v*jHat + w*kHat.";
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
  return HasVolume(data) ? std::string()
                         : "The dataset has no cells with a volume, only surfaces, lines or points. Give "
                           "the volume mesh, or make one with Delaunay 3D.";
}
}

std::string VelocityProblem(vtkDataSet* data, const VelocityArray& array)
{
  const std::string shape = ShapeProblem(data);
  return shape.empty() ? ArrayProblem(data, array) : shape;
}
}
