// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nephoscope_WholeViewport_h
#define nephoscope_WholeViewport_h

#include "OpenGLFunctions.h"

#include "vtkOpenGLVertexArrayObject.h"

namespace nephoscope
{

/** A vertex shader: one triangle without attributes that covers the viewport. */
constexpr const char* wholeViewportVertex =
  "//VTK::System::Dec\n"
  "void main()\n"
  "{\n"
  "  vec2 corner = vec2(gl_VertexID == 1, gl_VertexID == 2);\n"
  "  gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);\n"
  "}\n";

/** Draws it; `attributes` is an array of none. */
inline void DrawWholeViewport(vtkOpenGLVertexArrayObject* attributes)
{
  attributes->Bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  attributes->Release();
}

} // namespace nephoscope

#endif
