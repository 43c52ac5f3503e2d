// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatPieces.h"

#include "DataBlocks.h"

#include "vtkDataSet.h"

namespace nephoscope
{

vtkSmartPointer<vtkDataSet> sampledPart(vtkDataObject* input)
{
  return appendedBlocks(input, [](vtkDataSet* data) { return data->GetNumberOfPoints() > 0; });
}

} // namespace nephoscope
