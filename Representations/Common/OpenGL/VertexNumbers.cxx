// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "VertexNumbers.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkShaderProgram.h"

namespace nephoscope
{
namespace
{
template <typename Numbers>
void UploadOrRelease(vtkOpenGLBufferObject* buffer, const Numbers& numbers)
{
  if (numbers.empty()) // which VTK refuses to upload
  {
    buffer->ReleaseGraphicsResources();
    return;
  }
  buffer->Upload(numbers, vtkOpenGLBufferObject::ArrayBuffer);
}
}

VertexNumbers::VertexNumbers() = default;
VertexNumbers::~VertexNumbers() = default;

void VertexNumbers::Upload(const std::vector<std::int32_t>& numbers, int components)
{
  this->Integers = true;
  this->Components = components;
  UploadOrRelease(this->Buffer, numbers);
}

void VertexNumbers::Upload(const std::vector<float>& numbers)
{
  this->Integers = false;
  this->Components = 1;
  UploadOrRelease(this->Buffer, numbers);
}

void VertexNumbers::Activate(vtkShaderProgram* program, const char* name)
{
  this->Location = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), name);
  if (this->Location < 0 || !this->Buffer->Bind())
  {
    this->Location = -1; // nothing to give
    return;
  }
  const auto location = static_cast<GLuint>(this->Location);
  glEnableVertexAttribArray(location);
  if (this->Integers)
  {
    glVertexAttribIPointer(location, this->Components, GL_INT, 0, nullptr);
  }
  else
  {
    glVertexAttribPointer(location, this->Components, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  this->Buffer->Release();
}

void VertexNumbers::Deactivate()
{
  if (this->Location >= 0)
  {
    glDisableVertexAttribArray(static_cast<GLuint>(this->Location));
    this->Location = -1;
  }
}

void VertexNumbers::Release()
{
  this->Buffer->ReleaseGraphicsResources();
}

} // namespace nephoscope
