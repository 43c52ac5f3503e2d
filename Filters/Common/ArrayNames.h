// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The existing arrays, in the form used in messages.
#ifndef nephoscope_ArrayNames_h
#define nephoscope_ArrayNames_h

#include "vtkFieldData.h"

#include <string>

namespace nephoscope
{

/** With commas between them; "none" without arrays. */
inline std::string arrayNames(vtkFieldData* data)
{
  std::string names;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    const char* name = data->GetArrayName(a);
    names += (names.empty() ? "" : ", ") + std::string(name ? name : "(unnamed)");
  }
  return names.empty() ? "none" : names;
}

/** The same in quotation marks, without unnamed arrays. */
inline std::string quotedArrayNames(vtkFieldData* data)
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
