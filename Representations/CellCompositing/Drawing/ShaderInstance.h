// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text of a shader several times in one: every name that it declares outside of functions
 * (uniforms, variables, constants, functions, structures and macros) gets a number, "points_1".
 * Names that the text does not declare itself are common to all.
 */
#ifndef nephoscope_ShaderInstance_h
#define nephoscope_ShaderInstance_h

#include <string>

namespace nephoscope
{

/**
 * "points" and 1: "points_1"; no number where it is negative. The text lasts: vtkShaderProgram
 * keeps pointers to names of uniforms.
 */
const char* InstanceName(const char* name, int number);

std::string ShaderInstance(const std::string& text, int number);

/**
 * A function that calls one of all instances with the same arguments: addMedium_0(from, to),
 * addMedium_1(from, to) and so on.
 */
std::string CallInstances(const std::string& function, const std::string& of,
  const std::string& parameters, const std::string& arguments, int count);

} // namespace nephoscope

#endif
