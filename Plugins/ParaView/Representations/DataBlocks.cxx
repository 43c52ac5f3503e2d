// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataBlocks.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace nephoscope
{

vtkSmartPointer<vtkDataSet> appendedBlocks(
  vtkDataObject* input, const std::function<bool(vtkDataSet*)>& counts)
{
  if (auto data = vtkDataSet::SafeDownCast(input))
  {
    if (!counts(data))
    {
      return nullptr;
    }
    auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
    copy->ShallowCopy(data);
    return copy;
  }
  auto composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return nullptr;
  }
  std::vector<vtkDataSet*> blocks;
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (block && counts(block))
    {
      blocks.push_back(block);
    }
  }
  if (blocks.size() < 2)
  {
    return blocks.empty() ? nullptr : appendedBlocks(blocks.front(), counts);
  }
  vtkNew<vtkAppendFilter> append;
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
