// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataBlocks.h"

#include "AdaptiveCells.h"
#include "DataSets.h"

#include "vtkAppendFilter.h"
#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace nephoscope
{

namespace
{
std::vector<vtkSmartPointer<vtkDataSet>> BlocksOf(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts)
{
  std::vector<vtkSmartPointer<vtkDataSet>> blocks;
  ForEachLeaf(input, [&](vtkDataObject* leaf) {
    vtkSmartPointer<vtkDataSet> cells = LeafCells(leaf);
    if (cells && counts(cells))
    {
      blocks.push_back(cells);
    }
  });
  return blocks;
}
} // namespace

namespace
{
using Attributes = vtkDataSetAttributes* (*)(vtkDataSet*);

vtkDataSetAttributes* PointData(vtkDataSet* data)
{
  return data->GetPointData();
}

vtkDataSetAttributes* CellData(vtkDataSet* data)
{
  return data->GetCellData();
}

// vtkAppendFilter drops arrays that differ in type from block to block: they become double.
void GiveOneType(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks, const std::string& name,
  Attributes attributes)
{
  const auto arrayOf = [&](vtkDataSet* block) { return attributes(block)->GetArray(name.c_str()); };
  const auto isNumbers = [&](vtkDataSet* block) {
    return arrayOf(block) && !vtkBitArray::SafeDownCast(arrayOf(block));
  };
  if (!std::all_of(blocks.begin(), blocks.end(), isNumbers))
  {
    return;
  }
  const int type = arrayOf(blocks.front())->GetDataType();
  if (std::all_of(blocks.begin(), blocks.end(),
        [&](vtkDataSet* block) { return arrayOf(block)->GetDataType() == type; }))
  {
    return;
  }
  for (vtkDataSet* block : blocks)
  {
    vtkDataArray* array = arrayOf(block);
    const bool isScalars = attributes(block)->GetScalars() == array;
    vtkNew<vtkDoubleArray> numbers;
    numbers->DeepCopy(array);
    numbers->SetName(name.c_str());
    attributes(block)->AddArray(numbers);
    if (isScalars)
    {
      attributes(block)->SetActiveScalars(name.c_str());
    }
  }
}

// It drops arrays that only some blocks have: where others have none, the values are missing.
void AddMissing(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks, const std::string& name,
  Attributes attributes, vtkIdType (vtkDataSet::*count)())
{
  int components = 0;
  for (vtkDataSet* block : blocks)
  {
    vtkDataArray* array = attributes(block)->GetArray(name.c_str());
    if (attributes(block)->HasArray(name.c_str()) &&
      (!array || (components > 0 && array->GetNumberOfComponents() != components)))
    {
      return; // text, or no array that all could have
    }
    components = array ? array->GetNumberOfComponents() : components;
  }
  for (vtkDataSet* block : blocks)
  {
    if (!attributes(block)->HasArray(name.c_str()))
    {
      vtkNew<vtkDoubleArray> missing;
      missing->SetName(name.c_str());
      missing->SetNumberOfComponents(components);
      missing->SetNumberOfTuples((block->*count)());
      missing->Fill(std::numeric_limits<double>::quiet_NaN());
      attributes(block)->AddArray(missing);
    }
  }
}

std::set<std::string> NamesOfArrays(
  const std::vector<vtkSmartPointer<vtkDataSet>>& blocks, Attributes attributes)
{
  std::set<std::string> names;
  for (vtkDataSet* block : blocks)
  {
    for (int i = 0; i < attributes(block)->GetNumberOfArrays(); ++i)
    {
      const char* name = attributes(block)->GetArrayName(i);
      names.insert(name ? name : "");
    }
  }
  names.erase("");
  return names;
}

// It drops the flags of hidden cells and ghosts, too, where only some blocks have them.
void CompleteFlags(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks, Attributes attributes,
  vtkIdType (vtkDataSet::*count)())
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  const auto has = [&](vtkDataSet* block) { return attributes(block)->HasArray(name) != 0; };
  if (!std::any_of(blocks.begin(), blocks.end(), has))
  {
    return;
  }
  for (vtkDataSet* block : blocks)
  {
    if (!has(block))
    {
      vtkNew<vtkUnsignedCharArray> flags;
      flags->SetName(name);
      flags->SetNumberOfValues((block->*count)());
      flags->FillValue(0);
      attributes(block)->AddArray(flags);
    }
  }
}

// Copies that have the same arrays, of one type, and the same flags.
void MatchArrays(std::vector<vtkSmartPointer<vtkDataSet>>& blocks)
{
  for (auto& block : blocks)
  {
    auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
    copy->ShallowCopy(block);
    block = copy;
  }
  using Count = vtkIdType (vtkDataSet::*)();
  const std::pair<Attributes, Count> kinds[2] = { { PointData, &vtkDataSet::GetNumberOfPoints },
    { CellData, &vtkDataSet::GetNumberOfCells } };
  for (const auto& [attributes, count] : kinds)
  {
    CompleteFlags(blocks, attributes, count);
    for (const std::string& name : NamesOfArrays(blocks, attributes))
    {
      AddMissing(blocks, name, attributes, count);
      GiveOneType(blocks, name, attributes);
    }
  }
}

// Whether it is a part of a mesh, and no cloud of particles or surface.
bool HasVolumes(vtkDataSet* data)
{
  std::array<bool, VTK_NUMBER_OF_CELL_TYPES> seen{};
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    const int type = data->GetCellType(i);
    if (type < 0 || type >= VTK_NUMBER_OF_CELL_TYPES ||
      std::exchange(seen[static_cast<std::size_t>(type)], true))
    {
      continue;
    }
    cell->SetCellType(type);
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}
} // namespace

vtkSmartPointer<vtkDataSet> AppendedBlocks(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts, BorderPoints border)
{
  auto blocks = BlocksOf(input, counts);
  const bool adaptive = vtkUniformGridAMR::SafeDownCast(input) != nullptr;
  if (adaptive)
  {
    HideCoveredCells(blocks);
  }
  if (blocks.size() < 2)
  {
    if (blocks.empty())
    {
      return nullptr;
    }
    auto copy = vtkSmartPointer<vtkDataSet>::Take(blocks.front()->NewInstance());
    copy->ShallowCopy(blocks.front());
    return copy;
  }
  vtkNew<vtkAppendFilter> append;
  // Neighbours share a face. Splats of points on it would count twice.
  const bool meshes =
    border == BorderPoints::Merged && std::all_of(blocks.begin(), blocks.end(), HasVolumes);
  append->SetMergePoints(adaptive || meshes);
  MatchArrays(blocks);
  for (vtkDataSet* block : blocks)
  {
    append->AddInputData(block);
  }
  append->Update();
  return vtkSmartPointer<vtkDataSet>(append->GetOutput());
}

void StoreNumbers(vtkDataSet* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  vtkNew<vtkFieldData> own; // the input shares its field data with the copy
  own->ShallowCopy(data->GetFieldData());
  own->AddArray(array);
  data->SetFieldData(own);
}

} // namespace nephoscope
