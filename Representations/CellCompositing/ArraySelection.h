// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What the parts of vtkCellCompositingMapper ask of the arrays they select. */
#ifndef ArraySelection_h
#define ArraySelection_h

#include "ScalarSelection.h"

#include "vtkFieldData.h"

#include <sstream>
#include <string>

namespace nephoscope
{

/** Names of a dataset's arrays, for messages. */
inline std::string arrayNames(vtkFieldData* data)
{
  std::ostringstream names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    names << (i ? ", " : "") << (name ? name : "(unnamed)");
  }
  return data->GetNumberOfArrays() ? names.str() : "none";
}

/** Empty when the selected array has a value for every point or cell. */
inline std::string checkLength(vtkDataSet* input, const ScalarSelection& scalars)
{
  const vtkIdType expected = scalars.OnCells ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  const vtkIdType found = scalars.Array->GetNumberOfTuples();
  if (found == expected)
  {
    return std::string();
  }
  const char* name = scalars.Array->GetName();
  return std::string("Array '") + (name ? name : "(unnamed)") + "' has " + std::to_string(found) +
    " values where the input has " + std::to_string(expected) + (scalars.OnCells ? " cells." : " points.");
}

} // namespace nephoscope

#endif
