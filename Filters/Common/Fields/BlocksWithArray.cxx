// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlocksWithArray.h"

#include "DataSets.h"
#include "DefaultRange.h"
#include "MessageSuppression.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"

namespace nephoscope
{
BlocksWithArray::BlocksWithArray(
  vtkAlgorithm* filter, std::function<bool(vtkDataSet*)> has, std::function<void()> begin)
  : Filter(filter)
  , Has(std::move(has))
  , OnBegin(std::move(begin))
{
  filter->AddObserver(vtkCommand::StartEvent, this, &BlocksWithArray::Begin);
  filter->AddObserver(vtkCommand::EndEvent, this, &BlocksWithArray::End);
}

void BlocksWithArray::Begin()
{
  if (this->Depth++ > 0)
  {
    return;
  }
  this->Count();
  this->OnBegin ? this->OnBegin() : void();
}

void BlocksWithArray::Count()
{
  this->Blocks = 0;
  this->IsInAny = false;
  this->Told = false;
  vtkDataObject* input = this->Filter->GetNumberOfInputConnections(0) > 0
    ? this->Filter->GetInputDataObject(0, 0)
    : nullptr;
  if (!vtkCompositeDataSet::SafeDownCast(input))
  {
    return;
  }
  bool isHere = false;
  ForEachLeaf(input, [&](vtkDataObject* leaf) {
    auto* block = vtkDataSet::SafeDownCast(leaf);
    ++this->Blocks;
    isHere = isHere || (block && this->Has(block));
  });
  this->IsInAny = IsTrueOfAnyPiece(this->Filter, isHere);
}

void BlocksWithArray::End()
{
  --this->Depth;
}

bool BlocksWithArray::IsLackedBy(vtkDataSet* block)
{
  if (this->Blocks == 0 || this->Has(block))
  {
    return false;
  }
  const bool silent = this->IsInAny || this->Told;
  this->Told = true;
  if (silent)
  {
    FailureCode::Set(this->Filter, !this->IsInAny);
  }
  return silent;
}

const char* BlocksWithArray::NorInOthers() const
{
  return this->Blocks > 1 && !this->IsInAny ? " No other block has it either." : "";
}
}
