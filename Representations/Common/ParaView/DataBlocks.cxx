// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataBlocks.h"

#include "AdaptiveCells.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace nephoscope
{

namespace
{
std::vector<vtkSmartPointer<vtkDataSet>> blocksOf(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts)
{
  std::vector<vtkSmartPointer<vtkDataSet>> blocks;
  const auto add = [&](vtkDataObject* leaf) {
    vtkSmartPointer<vtkDataSet> cells = leafCells(leaf);
    if (cells && counts(cells))
    {
      blocks.push_back(cells);
    }
  };
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  else
  {
    add(input);
  }
  return blocks;
}
} // namespace

vtkSmartPointer<vtkDataSet> appendedBlocks(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts)
{
  auto blocks = blocksOf(input, counts);
  const bool adaptive = vtkUniformGridAMR::SafeDownCast(input) != nullptr;
  if (adaptive)
  {
    hideCoveredCells(blocks);
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
  append->SetMergePoints(adaptive); // neighbours share a face
  for (vtkDataSet* block : blocks)
  {
    append->AddInputData(block);
  }
  append->Update();
  return vtkSmartPointer<vtkDataSet>(append->GetOutput());
}

void storeNumbers(vtkDataSet* data, const char* name, const std::vector<double>& values)
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
