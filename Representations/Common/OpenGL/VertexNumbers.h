// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Numbers that a vertex shader gets one after the other: what it draws, in order. Integers of 32
 * bits stay integers, which vtkOpenGLVertexArrayObject would make floats of.
 *
 * An attribute rather than an array indexed by gl_VertexID: Mesa's softpipe restarts the vertex
 * count after some thousands.
 */
#ifndef nephoscope_VertexNumbers_h
#define nephoscope_VertexNumbers_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkNew.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkOpenGLBufferObject;
class vtkShaderProgram;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT VertexNumbers
{
public:
  VertexNumbers();
  ~VertexNumbers();
  VertexNumbers(const VertexNumbers&) = delete;
  VertexNumbers& operator=(const VertexNumbers&) = delete;

  ///@{
  /** Replaces the content: for each vertex so many components. */
  void Upload(const std::vector<std::int32_t>& numbers, int components = 1);
  void Upload(const std::vector<float>& numbers);
  ///@}

  /** Makes them the attribute of that name, if the program has one; a vertex array is bound. */
  void Activate(vtkShaderProgram* program, const char* name);
  /** The vertex array is restored. */
  void Deactivate();
  void Release();

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  int Components = 1;
  bool Integers = true;
  int Location = -1; // while active
};

} // namespace nephoscope

#endif
