// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text of shaders: options become constants, so that disabled options cost nothing, and shared
 * parts are inserted where the shader names them. The window's shader cache keeps the variants.
 */
#ifndef nephoscope_ShaderText_h
#define nephoscope_ShaderText_h

#include "ContourSurfacesShader.h"
#include "FaceNumberShader.h"
#include "OpaqueDepthShader.h"
#include "OpticalSegmentShader.h"
#include "PolygonSurfacesShader.h"
#include "ShaderArrays.h"
#include "ShaderParts.h"
#include "TetrahedronInputShader.h"
#include "TransferFunctionShader.h"

#include <string>

namespace nephoscope
{

inline std::string ShaderConstant(const char* name, bool value)
{
  return std::string("const bool ") + name + (value ? " = true;\n" : " = false;\n");
}

inline std::string SpecializedShader(const std::string& shader, const std::string& constants)
{
  return WithShaderParts(shader,
    { { "Constants", constants }, { "Arrays", ArrayDeclarations(CurrentArrayLayout()) },
      { "TetrahedronInput", TetrahedronInputShader }, { "OpaqueDepth", OpaqueDepthShader },
      { "FaceNumber", FaceNumberShader }, { "OpticalSegment", OpticalSegmentShader },
      { "TransferFunction", TransferFunctionShader }, { "ContourSurfaces", ContourSurfacesShader },
      { "PolygonSurfaces", PolygonSurfacesShader } });
}

} // namespace nephoscope

#endif
