// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The existing arrays, in the form used in messages.
#ifndef nephoscope_ArrayNames_h
#define nephoscope_ArrayNames_h

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"

#include <string>

namespace nephoscope
{

/** Whether a filter or a representation added it for its own use. */
inline bool IsInternalArray(const char* name)
{
  const std::string text = name ? name : "";
  return text.rfind("Nephoscope", 0) == 0 || text.rfind("vtkOriginal", 0) == 0 ||
    text == vtkDataSetAttributes::GhostArrayName();
}

/**
 * With commas between them; "none" without arrays. `components`: only those with so many; 0: all.
 */
inline std::string NamesOfArrays(vtkFieldData* data, int components = 0)
{
  std::string names;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    const char* name = data->GetArrayName(a);
    const int own = data->GetAbstractArray(a)->GetNumberOfComponents();
    if (!IsInternalArray(name) && (components == 0 || components == own))
    {
      names += (names.empty() ? "" : ", ") + std::string(name ? name : "(unnamed)");
    }
  }
  return names.empty() ? "none" : names;
}

/** For messages: in quotation marks, or "without a name". */
inline std::string QuotedName(vtkAbstractArray* array)
{
  return array->GetName() ? "'" + std::string(array->GetName()) + "'"
                          : std::string("without a name");
}

/** These with commas between them; "none" without arrays. */
inline std::string QuotedNames(vtkFieldData* data)
{
  std::string names;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    names += (a > 0 ? ", " : "") + QuotedName(data->GetAbstractArray(a));
  }
  return names.empty() ? "none" : names;
}

/** The same, without unnamed arrays. */
inline std::string QuotedArrayNames(vtkFieldData* data)
{
  std::string names;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    const char* name = data->GetArrayName(a);
    names += name ? (names.empty() ? "'" : ", '") + std::string(name) + "'" : "";
  }
  return names.empty() ? "none" : names;
}

}

#endif
