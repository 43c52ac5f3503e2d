// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text of shaders: options become constants, so that what is switched off costs nothing, and shared parts are put in
 * where the shader names them. The window's shader cache keeps the variants.
 */
#ifndef ShaderText_h
#define ShaderText_h

#include "ContourSurfacesShader.h"
#include "FaceScalarsShader.h"
#include "OpaqueDepthShader.h"
#include "OpticalSegmentShader.h"
#include "TetrahedronInputShader.h"
#include "TransferFunctionShader.h"

#include "vtkShaderProgram.h"

#include <string>

namespace nephoscope
{

inline std::string shaderConstant(const char* name, bool value)
{
  return std::string("const bool ") + name + (value ? " = true;\n" : " = false;\n");
}

inline std::string specializedShader(const char* shader, const std::string& constants)
{
  std::string source = shader;
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::Constants", constants);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::TetrahedronInput", TetrahedronInputShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::OpaqueDepth", OpaqueDepthShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::OpticalSegment", OpticalSegmentShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::TransferFunction", TransferFunctionShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::FaceScalars", FaceScalarsShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::ContourSurfaces", ContourSurfacesShader);
  return source;
}

} // namespace nephoscope

#endif
