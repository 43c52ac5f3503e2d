// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VelocityChoice.h"

#include "DataSets.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <algorithm>
#include <set>
#include <vector>

namespace nephoscope
{
namespace
{
vtkDataSetAttributes* Attributes(vtkDataSet* set, bool onCells)
{
  return onCells ? static_cast<vtkDataSetAttributes*>(set->GetCellData()) : set->GetPointData();
}

// Three bytes are a colour.
bool IsVector(vtkDataArray* array)
{
  return array && array->GetName() && array->GetNumberOfComponents() == 3 &&
    array->GetDataType() != VTK_UNSIGNED_CHAR;
}

std::string Listed(const std::set<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return list.empty() ? "none" : list;
}

// Arrays of three components by name, in all blocks. Normals are directions, not velocities.
std::set<std::string> Vectors(const std::vector<vtkDataSet*>& sets, bool onCells)
{
  std::set<std::string> names;
  for (vtkDataSet* set : sets)
  {
    vtkDataSetAttributes* attributes = Attributes(set, onCells);
    for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = attributes->GetArray(a);
      if (IsVector(array) && array != attributes->GetNormals())
      {
        names.insert(array->GetName());
      }
    }
  }
  return names;
}

std::string ActiveVectors(const std::vector<vtkDataSet*>& sets, bool onCells)
{
  for (vtkDataSet* set : sets)
  {
    vtkDataArray* active = Attributes(set, onCells)->GetVectors();
    if (IsVector(active))
    {
      return active->GetName();
    }
  }
  return {};
}

int ComponentsOf(const std::vector<vtkDataSet*>& sets, const std::string& name, bool onCells)
{
  for (vtkDataSet* set : sets)
  {
    if (vtkDataArray* array = Attributes(set, onCells)->GetArray(name.c_str()))
    {
      return array->GetNumberOfComponents();
    }
  }
  return 0;
}

std::string ListOfAll(const std::vector<vtkDataSet*>& sets)
{
  return "Point arrays of three components: " + Listed(Vectors(sets, false)) +
    "; cell arrays: " + Listed(Vectors(sets, true)) + ".";
}

bool ChooseNamed(const std::vector<vtkDataSet*>& sets, const std::string& name, int association,
  VelocityArray& choice, std::string& problem)
{
  int components = 0;
  for (const bool onCells : { false, true })
  {
    const int other =
      onCells ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS;
    const int found = association == other ? 0 : ComponentsOf(sets, name, onCells);
    if (found == 3)
    {
      choice = { name, onCells };
      return true;
    }
    components = std::max(components, found);
  }
  if (components > 0)
  {
    problem = "The array '" + name + "' has " + std::to_string(components) +
      " components; a velocity has three. Merge components first (Merge Vector Components, Calculator). ";
  }
  else
  {
    const bool wantsCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
    const bool isOther = ComponentsOf(sets, name, !wantsCells) == 3;
    problem = std::string("There is no ") + (wantsCells ? "cell" : "point") + " array '" + name +
      "' to take the velocity from. " +
      (isOther ? std::string("It is on ") + (wantsCells ? "points" : "cells") +
            ": choose that association. "
               : std::string());
  }
  problem += ListOfAll(sets);
  return false;
}

bool ChooseDefault(
  const std::vector<vtkDataSet*>& sets, VelocityArray& choice, std::string& problem)
{
  const std::string display = "DisplayVelocity"; // of vtkGlobeGrid
  for (const bool onCells : { false, true })
  {
    if (ComponentsOf(sets, display, onCells) == 3)
    {
      choice = { display, onCells };
      return true;
    }
  }
  for (const bool onCells : { false, true })
  {
    const std::string active = ActiveVectors(sets, onCells);
    if (!active.empty())
    {
      choice = { active, onCells };
      return true;
    }
  }
  for (const bool onCells : { false, true })
  {
    const auto names = Vectors(sets, onCells);
    if (names.size() == 1)
    {
      choice = { *names.begin(), onCells };
      return true;
    }
    if (names.size() > 1)
    {
      problem = "The input has several arrays that may be the velocity: choose one of "
                "them. " +
        ListOfAll(sets);
      return false;
    }
  }
  problem =
    "The input has no velocity: no named array of three components on points or on cells. Make one first "
    "(Merge Vector Components, Calculator).";
  return false;
}
}

bool ChooseVelocity(
  vtkDataObject* data, vtkInformation* wanted, VelocityArray& choice, std::string& problem)
{
  const auto sets = DataSetsOf(data);
  const char* name = wanted ? wanted->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (!name || !*name)
  {
    return ChooseDefault(sets, choice, problem);
  }
  return ChooseNamed(sets, name, wanted->Get(vtkDataObject::FIELD_ASSOCIATION()), choice, problem);
}
}
