// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputBlocks.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
// What the first filter that is no part of ParaView's own pipeline has made.
vtkCompositeDataSet* BlocksOf(vtkAlgorithm* filter)
{
  vtkAlgorithmOutput* from = filter->GetInputConnection(0, 0);
  while (from && from->GetProducer()->IsA("vtkPVPostFilter") &&
    from->GetProducer()->GetNumberOfInputConnections(0) > 0)
  {
    from = from->GetProducer()->GetInputConnection(0, 0);
  }
  return from
    ? vtkCompositeDataSet::SafeDownCast(from->GetProducer()->GetOutputDataObject(from->GetIndex()))
    : nullptr;
}

bool ShareArrays(vtkFieldData* one, vtkFieldData* other)
{
  bool same = one->GetNumberOfArrays() == other->GetNumberOfArrays();
  for (int a = 0; same && a < one->GetNumberOfArrays(); ++a)
  {
    same = one->GetAbstractArray(a) == other->GetAbstractArray(a);
  }
  return same;
}

// ParaView's own filters copy blocks, but not what they hold.
bool AreSame(vtkDataSet* one, vtkDataSet* other)
{
  double bounds[2][6];
  one->GetBounds(bounds[0]);
  other->GetBounds(bounds[1]);
  return one->GetNumberOfPoints() == other->GetNumberOfPoints() &&
    std::equal(bounds[0], bounds[0] + 6, bounds[1]) &&
    ShareArrays(one->GetPointData(), other->GetPointData()) &&
    ShareArrays(one->GetCellData(), other->GetCellData());
}
}

std::string NameOfBlock(vtkCompositeDataIterator* leaf)
{
  const unsigned int index = leaf->GetCurrentFlatIndex();
  const char* name = leaf->HasCurrentMetaData()
    ? leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  // In a collection the datasets have names, and their partitions none.
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(leaf->GetDataSet());
  for (unsigned int i = collection && !name ? collection->GetNumberOfPartitionedDataSets() : 0;
       i-- > 0;)
  {
    if (collection->GetCompositeIndex(i) <= index)
    {
      name = collection->HasMetaData(i)
        ? collection->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())
        : nullptr;
      break;
    }
  }
  return name ? "'" + std::string(name) + "'" : std::to_string(index);
}

std::string InBlock(vtkAlgorithm* filter, vtkDataSet* block)
{
  vtkCompositeDataSet* blocks = BlocksOf(filter);
  if (!blocks)
  {
    return "";
  }
  auto leaf = vtk::TakeSmartPointer(blocks->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* set = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (set && AreSame(set, block))
    {
      return "Block " + NameOfBlock(leaf) + ": ";
    }
  }
  return "";
}
}
