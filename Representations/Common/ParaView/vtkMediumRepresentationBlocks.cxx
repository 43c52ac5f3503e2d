// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks without the coloured array, or without that for the opacity, beside others that have it;
// data without it.
#include "vtkMediumRepresentation.h"

#include "DrawnBlocks.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <sstream>
#include <string>

namespace
{
// Only one time step of several may lack an array.
std::string AtItsTime(vtkDataObject* data)
{
  vtkInformation* info = data ? data->GetInformation() : nullptr;
  std::ostringstream text;
  if (info && info->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    text << " at time " << info->Get(vtkDataObject::DATA_TIME_STEP());
  }
  return text.str();
}
}

vtkSmartPointer<vtkDataObject> vtkMediumRepresentation::KeepDrawnBlocks(vtkDataObject* input)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME())
    ? info->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  const nephoscope::ArrayOfBlocks arrays[2] = {
    { name ? name : "", name ? info->Get(vtkDataObject::FIELD_ASSOCIATION()) : 0 },
    { this->GetOpacityArrayName(), vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS },
  };
  vtkSmartPointer<vtkDataObject> data = input;
  std::string message;
  for (const nephoscope::ArrayOfBlocks& array : arrays)
  {
    const nephoscope::DrawnBlocks drawn = nephoscope::BlocksWith(
      array, data, [this](vtkDataObject* block) { return this->DrawsBlock(block); },
      [](bool here) { return MinimumOverRanks(here ? 0 : 1) == 0; });
    data = drawn.Data;
    message += (message.empty() || drawn.Message.empty() ? "" : " ") + drawn.Message;
  }
  if (message != this->LeftOut && !message.empty())
  {
    vtkWarningMacro(<< message);
  }
  this->LeftOut = message;
  return data;
}

// Called by all ranks.
void vtkMediumRepresentation::WarnOfMissingArray()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info && info->Has(vtkDataObject::FIELD_NAME())
    ? info->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  const std::string asked = name ? name : "";
  const bool here = this->Piece && !asked.empty() &&
    (this->Piece->GetPointData()->HasArray(name) || this->Piece->GetCellData()->HasArray(name));
  const bool missing = !asked.empty() && this->HasPiece && MinimumOverRanks(here ? 0 : 1) == 1;
  if (missing && this->MissingArray != asked && IsFirstRank())
  {
    vtkWarningMacro(<< "The data have no array '" << asked << "'"
                    << AtItsTime(this->GetInputDataObject(0, 0))
                    << ": they are drawn in one colour. Choose another one in Coloring.");
  }
  this->MissingArray = missing ? asked : "";
}
