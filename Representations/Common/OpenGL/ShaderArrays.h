// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How shaders read the arrays of BufferTexture: `uniform FloatArray a; ... element(a, i)`, and
 * IntegerArray. What the two types are goes where a shader names `//NEPHOSCOPE::Arrays`.
 *
 * They are buffer textures, which may be as small as 65,536 elements (GL_MAX_TEXTURE_BUFFER_SIZE).
 * Where they are, arrays are 2-D textures with rows of a power of two.
 */
#ifndef nephoscope_ShaderArrays_h
#define nephoscope_ShaderArrays_h

#include "OpenGLFunctions.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace nephoscope
{

struct ArrayLayout
{
  int RowBits = 0; ///< 2-D textures with rows of 2^RowBits elements; 0: buffer textures
  std::size_t Capacity = 0;
};

/** The layout of the current context. */
inline ArrayLayout CurrentArrayLayout()
{
  constexpr GLint large = 1 << 24;
  GLint buffer = 0, side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &buffer);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
  ArrayLayout layout;
  layout.Capacity = static_cast<std::size_t>(buffer);
  if (buffer < large && std::size_t(side) * std::size_t(side) > layout.Capacity)
  {
    while ((2 << layout.RowBits) <= std::min(side, 4096))
    {
      ++layout.RowBits;
    }
    layout.Capacity = std::size_t(side) << layout.RowBits;
  }
  return layout;
}

inline std::string ArrayDeclarations(const ArrayLayout& layout)
{
  const std::string bits = std::to_string(layout.RowBits);
  const std::string mask = std::to_string((1 << layout.RowBits) - 1);
  const bool rows = layout.RowBits > 0;
  const std::string place = rows ? "ivec2(i & " + mask + ", i >> " + bits + "), 0" : "i";
  return std::string(rows
             ? "#define FloatArray sampler2D\n#define IntegerArray isampler2D\n"
             : "#define FloatArray samplerBuffer\n#define IntegerArray isamplerBuffer\n") +
    "vec4 element(FloatArray a, int i) { return texelFetch(a, " + place + "); }\n" +
    "ivec4 element(IntegerArray a, int i) { return texelFetch(a, " + place + "); }\n";
}

} // namespace nephoscope

#endif
