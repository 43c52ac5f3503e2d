// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Evaluates GLSL functions on lists of numbers: item i of two input lists is given to the shader as
 * vec4 `first` and `second`, and what it writes to vec4 `result` comes back, all in 32-bit float.
 * For tests of shaders against C++.
 *
 * Declare such a test with nephoscope_add_shader_test. Without a display it exits with 125.
 */
#ifndef nephoscope_ShaderRunner_h
#define nephoscope_ShaderRunner_h

#include "OpenGLFunctions.h"
#include "ShaderArrays.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace nephoscope_test
{

using Float4 = std::array<float, 4>;

/** The text of a shader file of the technique under test. */
inline std::string ReadShader(const std::string& name)
{
  std::ifstream file(NEPHOSCOPE_SHADER_FOLDER "/" + name);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << name;
  return text.str();
}

class ShaderRunner
{
public:
  ShaderRunner()
  {
    vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window = vtkOpenGLRenderWindow::SafeDownCast(window);
    const bool needsDisplay = window->IsA("vtkXOpenGLRenderWindow");
    if (!this->Window || (needsDisplay && !std::getenv("DISPLAY")))
    {
      std::cout << "skipped: no display to draw on" << std::endl;
      std::exit(125);
    }
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(16, 16);
    this->Window->Render();
    std::cout << "OpenGL on " << glGetString(GL_RENDERER) << std::endl;
  }

  ~ShaderRunner()
  {
    for (const auto& texture : this->Buffers)
    {
      texture.Texture->ReleaseGraphicsResources(this->Window);
      texture.Object->ReleaseGraphicsResources();
    }
  }

  /** Makes an array of this name. */
  void AddBuffer(const std::string& name, const std::vector<float>& values, int components)
  {
    Buffer buffer;
    buffer.Name = name;
    buffer.Object->SetType(vtkOpenGLBufferObject::TextureBuffer);
    buffer.Object->Upload(values, vtkOpenGLBufferObject::TextureBuffer);
    buffer.Texture->SetContext(this->Window);
    buffer.Texture->CreateTextureBuffer(
      static_cast<unsigned int>(values.size()) / components, components, VTK_FLOAT, buffer.Object);
    this->Buffers.push_back(buffer);
  }

  /** `functions` go before main, `body` into it; `uniforms` may set more of them. */
  std::vector<Float4> Run(const std::string& functions, const std::string& body,
    std::vector<Float4> first, std::vector<Float4> second,
    const std::function<void(vtkShaderProgram*)>& uniforms)
  {
    const std::size_t items = first.size();
    const int width = 64;
    const int height = static_cast<int>((items + width - 1) / width);
    first.resize(static_cast<std::size_t>(width * height));
    second.resize(first.size());
    auto firstTexture = this->MakeTexture(width, height, first);
    auto secondTexture = this->MakeTexture(width, height, second);
    std::vector<Float4> empty(first.size(), Float4{ { -1, -1, -1, -1 } });
    auto target = this->MakeTexture(width, height, empty);

    const std::string source =
      "//VTK::System::Dec\n//VTK::Output::Dec\nuniform sampler2D firstInput;\n"
      "uniform sampler2D secondInput;\nin vec2 texCoord;\n" +
      nephoscope::ArrayDeclarations(nephoscope::ArrayLayout()) + functions +
      "\nvoid main()\n{\n  ivec2 item = ivec2(texCoord * vec2(textureSize(firstInput, 0)));\n"
      "  vec4 first = texelFetch(firstInput, item, 0);\n"
      "  vec4 second = texelFetch(secondInput, item, 0);\n  vec4 result;\n  " +
      body + "\n  gl_FragData[0] = result;\n}\n";

    std::vector<Float4> results(first.size());
    vtkOpenGLState* state = this->Window->GetState();
    state->PushFramebufferBindings();
    vtkNew<vtkOpenGLFramebufferObject> framebuffer;
    framebuffer->SetContext(this->Window);
    framebuffer->Bind();
    framebuffer->AddColorAttachment(0, target);
    framebuffer->ActivateDrawBuffer(0);
    framebuffer->ActivateReadBuffer(0);
    state->vtkglViewport(0, 0, width, height);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    {
      vtkOpenGLQuadHelper quad(this->Window, nullptr, source.c_str(), nullptr);
      EXPECT_TRUE(quad.Program && quad.Program->GetCompiled()) << source;
      if (quad.Program)
      {
        this->Bind(quad.Program, firstTexture, secondTexture);
        uniforms(quad.Program);
        quad.Render();
      }
      glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, results.data());
      quad.ReleaseGraphicsResources(this->Window);
    }
    state->PopFramebufferBindings();
    framebuffer->ReleaseGraphicsResources(this->Window);
    for (const auto& texture : { firstTexture, secondTexture, target })
    {
      texture->Deactivate();
      texture->ReleaseGraphicsResources(this->Window);
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    results.resize(items);
    return results;
  }

private:
  struct Buffer
  {
    std::string Name;
    vtkSmartPointer<vtkOpenGLBufferObject> Object = vtkSmartPointer<vtkOpenGLBufferObject>::New();
    vtkSmartPointer<vtkTextureObject> Texture = vtkSmartPointer<vtkTextureObject>::New();
  };

  vtkSmartPointer<vtkTextureObject> MakeTexture(int width, int height, std::vector<Float4>& values)
  {
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(this->Window);
    texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4,
      VTK_FLOAT, values.data());
    return texture;
  }

  void Bind(vtkShaderProgram* program, vtkTextureObject* first, vtkTextureObject* second)
  {
    first->Activate();
    second->Activate();
    program->SetUniformi("firstInput", first->GetTextureUnit());
    program->SetUniformi("secondInput", second->GetTextureUnit());
    for (const Buffer& buffer : this->Buffers)
    {
      buffer.Texture->Activate();
      program->SetUniformi(buffer.Name.c_str(), buffer.Texture->GetTextureUnit());
    }
  }

  vtkSmartPointer<vtkOpenGLRenderWindow> Window;
  std::vector<Buffer> Buffers;
};

} // namespace nephoscope_test

#endif
