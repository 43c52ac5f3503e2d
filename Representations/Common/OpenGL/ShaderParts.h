// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text of a shader put together: a line `//NEPHOSCOPE::Name` in it is where the part of that
 * name goes. Parts may name parts that come later in the list.
 */
#ifndef nephoscope_ShaderParts_h
#define nephoscope_ShaderParts_h

#include "vtkShaderProgram.h"

#include <initializer_list>
#include <string>
#include <utility>

namespace nephoscope
{

using ShaderParts = std::initializer_list<std::pair<const char*, std::string>>;

inline std::string WithShaderParts(std::string shader, const ShaderParts& parts)
{
  for (const auto& part : parts)
  {
    vtkShaderProgram::Substitute(shader, std::string("//NEPHOSCOPE::") + part.first, part.second);
  }
  return shader;
}

} // namespace nephoscope

#endif
