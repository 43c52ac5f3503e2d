// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnBlocks.h"

#include "DataSets.h"
#include "InputBlocks.h"

#include "vtkDataSetAttributes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUniformGridAMR.h"

#include <algorithm>
#include <vector>

namespace nephoscope
{
namespace
{
bool Has(vtkDataObject* block, const ArrayOfBlocks& array, int association)
{
  const bool isAsked = array.Association == association ||
    array.Association == vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
  vtkDataSetAttributes* arrays = isAsked ? block->GetAttributes(association) : nullptr;
  return arrays && arrays->HasArray(array.Name.c_str());
}

std::string Listed(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
  {
    const bool isLast = i + 1 == names.size();
    text += (i == 0 ? "" : isLast ? " and " : ", ") + names[i];
  }
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                             : text;
}

std::string Told(const std::vector<std::string>& names, const std::string& array)
{
  const bool isOne = names.size() == 1;
  return (isOne ? "Block " : "Blocks ") + Listed(names) + (isOne ? " is" : " are") +
    " not drawn, without an array '" + array +
    "': choose Solid Color, or an array that all blocks have, to draw every block.";
}
} // namespace

DrawnBlocks BlocksWith(const ArrayOfBlocks& array, vtkDataObject* input,
  const std::function<bool(vtkDataObject*)>& counts, const std::function<bool(bool)>& onAnyRank)
{
  DrawnBlocks drawn;
  drawn.Data = input;
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  blocks = vtkUniformGridAMR::SafeDownCast(blocks) || array.Name.empty() ? nullptr : blocks;
  vtkNew<vtkMultiBlockDataSet> kept;
  std::vector<std::string> names;
  bool any = false;
  auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(
    blocks ? blocks->NewIterator() : kept->NewIterator());
  for (leaf->InitTraversal(); blocks && !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkDataObject* block = leaf->GetCurrentDataObject();
    const bool hasIt =
      Has(block, array, vtkDataObject::POINT) || Has(block, array, vtkDataObject::CELL);
    any = any || hasIt;
    if (!hasIt && counts(block))
    {
      names.push_back(NameOfBlock(leaf));
    }
    else
    {
      kept->SetBlock(kept->GetNumberOfBlocks(), block);
    }
  }
  if (onAnyRank(any) && !names.empty())
  {
    kept->SetFieldData(input->GetFieldData());
    drawn.Data = kept;
    drawn.Message = Told(names, array.Name);
  }
  return drawn;
}

} // namespace nephoscope
