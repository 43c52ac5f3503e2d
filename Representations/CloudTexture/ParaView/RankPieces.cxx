// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankPieces.h"

#include "DataSets.h"
#include "Ranks.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

namespace nephoscope
{
namespace
{
vtkSmartPointer<vtkDataObject> MarkedCopy(vtkDataObject* leaf)
{
  auto copy = vtk::TakeSmartPointer(leaf->NewInstance());
  copy->ShallowCopy(leaf);
  vtkNew<vtkFieldData> own; // the copy shares those of the leaf
  own->ShallowCopy(leaf->GetFieldData());
  copy->SetFieldData(own);
  if (auto* set = vtkDataSet::SafeDownCast(copy))
  {
    MarkPiece(set);
  }
  return copy;
}
} // namespace

void MarkPiece(vtkDataSet* set)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName(pieceName);
  const auto add = [&](const auto* some, int count) {
    std::for_each(
      some, some + count, [&](auto x) { numbers->InsertNextValue(static_cast<double>(x)); });
  };
  if (auto* image = vtkImageData::SafeDownCast(set))
  {
    add(image->GetOrigin(), 3);
    add(image->GetSpacing(), 3);
    add(image->GetDirectionMatrix()->GetData(), 9);
    add(image->GetExtent(), 6);
  }
  else
  {
    numbers->InsertNextValue(0); // there is nothing to keep
  }
  set->GetFieldData()->AddArray(numbers);
}

void RestorePiece(vtkDataSet* set)
{
  auto* image = vtkImageData::SafeDownCast(set);
  auto* numbers =
    image ? vtkDoubleArray::SafeDownCast(image->GetFieldData()->GetArray(pieceName)) : nullptr;
  if (numbers && numbers->GetNumberOfValues() == 21)
  {
    image->SetOrigin(numbers->GetPointer(0));
    image->SetSpacing(numbers->GetPointer(3));
    image->SetDirectionMatrix(numbers->GetPointer(6));
    int extent[6];
    std::transform(numbers->GetPointer(15), numbers->GetPointer(15) + 6, extent,
      [](double x) { return static_cast<int>(x); });
    image->SetExtent(extent);
  }
}

bool HasMarkedPieces(vtkDataObject* data)
{
  const std::vector<vtkDataSet*> sets = data ? DataSetsOf(data) : std::vector<vtkDataSet*>();
  return std::any_of(sets.begin(), sets.end(),
    [](vtkDataSet* set) { return set->GetFieldData()->HasArray(pieceName) != 0; });
}

void PlacePieces(vtkDataObject* own, vtkMultiBlockDataSet* placed)
{
  std::vector<vtkSmartPointer<vtkDataObject>> leaves;
  if (own)
  {
    ForEachLeaf(own, [&](vtkDataObject* leaf) { leaves.push_back(MarkedCopy(leaf)); });
  }
  const auto most = MaximumOverRanks(static_cast<unsigned int>(leaves.size()));
  auto* others = OtherRanks();
  const auto ranks = static_cast<unsigned int>(others ? others->GetNumberOfProcesses() : 1);
  auto block = static_cast<unsigned int>(others ? others->GetLocalProcessId() : 0);
  placed->SetNumberOfBlocks(0);
  placed->SetNumberOfBlocks(most * ranks);
  for (const auto& leaf : leaves)
  {
    placed->SetBlock(block, leaf);
    block += ranks;
  }
}

} // namespace nephoscope
