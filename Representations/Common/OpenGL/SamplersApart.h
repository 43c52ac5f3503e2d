// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Gives each kind of a program's samplers a texture unit of its own, at the end of the units,
 * before a pass sets those that it uses.
 *
 * Samplers begin at unit 0. Two of different kinds at one unit make every draw an error
 * (GL_INVALID_OPERATION), although the program may read neither: a driver may count samplers as
 * active in code that is never reached.
 */
#ifndef nephoscope_SamplersApart_h
#define nephoscope_SamplersApart_h

#include "OpenGLFunctions.h"

#include "vtkShaderProgram.h"

#include <array>

namespace nephoscope
{

/** The program is the one in use. */
inline void SetSamplersApart(vtkShaderProgram* program)
{
  static const std::array<GLenum, 6> kinds = { { GL_SAMPLER_2D, GL_INT_SAMPLER_2D,
    GL_SAMPLER_BUFFER, GL_INT_SAMPLER_BUFFER, GL_SAMPLER_3D, GL_SAMPLER_2D_ARRAY } };
  const auto handle = static_cast<GLuint>(program->GetHandle());
  GLint units = 0, uniforms = 0;
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
  glGetProgramiv(handle, GL_ACTIVE_UNIFORMS, &uniforms);
  for (GLuint i = 0; i < static_cast<GLuint>(uniforms); ++i)
  {
    char name[64];
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(handle, i, sizeof(name), nullptr, &size, &type, name);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    {
      if (kinds[kind] == type)
      {
        glUniform1i(glGetUniformLocation(handle, name), units - 1 - static_cast<GLint>(kind));
      }
    }
  }
}

} // namespace nephoscope

#endif
