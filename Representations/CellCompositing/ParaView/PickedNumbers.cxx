// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PickedNumbers.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUniformGridAMR.h"

#include <numeric>

namespace nephoscope
{
namespace
{
void AddNumbers(vtkDataSetAttributes* attributes, const char* name, vtkIdType count)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfValues(count);
  std::iota(numbers->Begin(), numbers->End(), 0);
  attributes->AddArray(numbers);
}
} // namespace

vtkSmartPointer<vtkDataObject> WithPickedNumbers(vtkDataObject* input)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  if (!blocks || vtkUniformGridAMR::SafeDownCast(input))
  {
    return input;
  }
  auto numbered = vtkSmartPointer<vtkCompositeDataSet>::Take(blocks->NewInstance());
  numbered->CopyStructure(blocks);
  numbered->SetFieldData(blocks->GetFieldData());
  auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* data = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (!data)
    {
      numbered->SetDataSet(leaf, leaf->GetCurrentDataObject());
      continue;
    }
    auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
    copy->ShallowCopy(data);
    AddNumbers(copy->GetCellData(), pickedCellsName, data->GetNumberOfCells());
    AddNumbers(copy->GetPointData(), pickedPointsName, data->GetNumberOfPoints());
    vtkNew<vtkIdTypeArray> indices;
    indices->SetName(pickedBlocksName);
    indices->SetNumberOfValues(data->GetNumberOfCells());
    indices->FillValue(leaf->GetCurrentFlatIndex());
    copy->GetCellData()->AddArray(indices);
    numbered->SetDataSet(leaf, copy);
  }
  return numbered;
}

bool HasNumbersOf(vtkDataObject* input, vtkDataSet* piece)
{
  auto* data = vtkDataSet::SafeDownCast(input);
  return data && piece && data->GetNumberOfCells() == piece->GetNumberOfCells() &&
    data->GetNumberOfPoints() == piece->GetNumberOfPoints();
}

void DropSharedNumbers(vtkDataObject* input, vtkDataSet* piece)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  if (!blocks || !piece)
  {
    return;
  }
  auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkDataObject* block = leaf->GetCurrentDataObject();
    if (block->GetNumberOfElements(vtkDataObject::CELL) == piece->GetNumberOfCells() &&
      block->GetNumberOfElements(vtkDataObject::POINT) == piece->GetNumberOfPoints())
    {
      return; // this one alone is drawn
    }
  }
  piece->GetPointData()->RemoveArray(pickedPointsName);
}

} // namespace nephoscope
