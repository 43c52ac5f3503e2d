// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_LowerCase_h
#define nephoscope_LowerCase_h

#include <algorithm>
#include <cctype>
#include <string>

namespace nephoscope
{
// In lower case, as far as it is ASCII.
inline std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}
}

#endif
