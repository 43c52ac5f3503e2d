// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "CellCompositingPass.h"

#include "CellGeometry.h"
#include "ContourScene.h"
#include "OpticalSegment.h"

#include "CellCompositingFragment.h"
#include "CellCompositingGeometry.h"
#include "CellCompositingVertex.h"
#include "ContourSurfacesShader.h"
#include "FaceScalarsShader.h"
#include "OpticalSegmentShader.h"
#include "TransferFunctionShader.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace nephoscope
{
namespace
{
std::string constant(const char* name, bool value)
{
  return std::string("const bool ") + name + (value ? " = true;\n" : " = false;\n");
}

std::string specialized(const char* shader, const std::string& constants)
{
  std::string source = shader;
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::Constants", constants);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::OpticalSegment", OpticalSegmentShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::TransferFunction", TransferFunctionShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::FaceScalars", FaceScalarsShader);
  vtkShaderProgram::Substitute(source, "//NEPHOSCOPE::ContourSurfaces", ContourSurfacesShader);
  return source;
}

// z in view coordinates as (a + b e) / (c + d e), where e = 1 - depth: counted from the far plane, where most depths lie in
// a perspective projection, nothing cancels in float.
std::array<float, 4> depthToView(vtkMatrix4x4* viewToDevice)
{
  const double m22 = viewToDevice->GetElement(2, 2);
  const double m23 = viewToDevice->GetElement(2, 3);
  const double m32 = viewToDevice->GetElement(3, 2);
  const double m33 = viewToDevice->GetElement(3, 3);
  // (m22 z + m23) / (m32 z + m33) = 1 - 2 e
  return { { static_cast<float>(m33 - m23), static_cast<float>(-2 * m33), static_cast<float>(m22 - m32),
    static_cast<float>(2 * m32) } };
}

// (pixel, 1) to the direction of its ray, or in a parallel projection to a point of it, in model coordinates.
void pixelToRay(const CellCompositingPass::View& view, const int size[2], vtkMatrix3x3* result)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Multiply4x4(view.ViewToDevice, view.ModelToView, inverse);
  inverse->Invert();
  const double corners[3][4] = { { 2.0 / size[0], 0, 0, 0 }, { 0, 2.0 / size[1], 0, 0 }, { -1, -1, 0, 1 } };
  double place[3][4]; // of the pixel's derivatives, and of pixel (0, 0), in homogeneous model coordinates
  for (int i = 0; i < 3; ++i)
  {
    inverse->MultiplyPoint(corners[i], place[i]);
  }
  const bool parallel = view.EyeModel[3] == 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double value = parallel ? place[i][axis] / place[2][3] : place[i][axis] - place[i][3] * view.EyeModel[axis];
      result->SetElement(i, axis, value); // transposed, as OpenGL wants it
    }
  }
}

bool hasNarrowIntervals(const std::vector<TransferFunctionTable>& tables)
{
  constexpr float narrow = 1e-3f; // of the range of the scalar: rounding at a face is some 1e-6 of it
  return std::any_of(tables.begin(), tables.end(), [=](const TransferFunctionTable& table) {
    return std::any_of(table.Widths.begin(), table.Widths.end(), [=](float w) { return w > 0 && w < narrow; });
  });
}

std::array<float, 4> toFloat(const double v[4])
{
  return { { static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]),
    static_cast<float>(v[3]) } };
}

std::string checkOpenGL(const char* where)
{
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR)
  {
    return std::string();
  }
  std::ostringstream text;
  text << "OpenGL error 0x" << std::hex << error << " " << where;
  return text.str();
}
}

/** An array on the GPU that shaders read with texelFetch. */
class CellCompositingPass::BufferTexture
{
public:
  template <typename T>
  std::string Upload(vtkOpenGLRenderWindow* window, const T* data, std::size_t tuples, int components, int type)
  {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (tuples > static_cast<std::size_t>(limit))
    {
      std::ostringstream text;
      text << tuples << " elements do not fit in a buffer texture of this OpenGL, which holds " << limit
           << "; distribute the data over more ranks, or draw fewer cells";
      return text.str();
    }
    this->Release(window);
    const std::size_t bytes = std::max<std::size_t>(tuples, 1) * components * 4;
    this->Storage.resize((bytes + sizeof(float) - 1) / sizeof(float), 0.0f);
    const char* source = tuples > 0 ? reinterpret_cast<const char*>(data)
                                    : reinterpret_cast<const char*>(this->Storage.data());
    this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
    this->Buffer->Upload(source, bytes, vtkOpenGLBufferObject::TextureBuffer);
    this->Storage.clear();
    this->Texture->SetContext(window);
    if (type == VTK_INT) // which vtkTextureObject would not choose an integer format for
    {
      this->Texture->SetInternalFormat(components == 4 ? GL_RGBA32I : GL_R32I);
      this->Texture->SetFormat(components == 4 ? GL_RGBA_INTEGER : GL_RED_INTEGER);
    }
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(std::max<std::size_t>(tuples, 1)), components, type, this->Buffer);
    return std::string();
  }
  int Activate()
  {
    this->Texture->Activate();
    return this->Texture->GetTextureUnit();
  }
  void Deactivate() { this->Texture->Deactivate(); }
  void Release(vtkWindow* window)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Buffer->ReleaseGraphicsResources();
  }

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::vector<float> Storage;
};

CellCompositingPass::CellCompositingPass()
{
  for (auto& buffer : this->Buffers)
  {
    buffer.reset(new BufferTexture);
  }
}
CellCompositingPass::~CellCompositingPass() = default;

std::string CellCompositingPass::UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry)
{
  this->UseCellScalars = !geometry.CellScalars.empty();
  this->SeparateOpacity = geometry.HasOpacityScalars;
  this->OpacityOnCells = geometry.OpacityOnCells;
  std::string error;
  const auto upload = [&](BufferName name, const auto& values, int components, int type) {
    if (error.empty())
    {
      error = this->Buffers[name]->Upload(window, values.data(), values.size(), components, type);
    }
  };
  upload(Points, geometry.Points, 4, VTK_FLOAT);
  upload(Tetrahedra, geometry.Tetrahedra, 4, VTK_INT);
  upload(CellScalars, geometry.CellScalars, 1, VTK_FLOAT);
  upload(OpacityScalars, geometry.OpacityScalars, 1, VTK_FLOAT);
  return error;
}

// All tables one after the other; nodes as (position, width above).
std::string CellCompositingPass::UploadTables(vtkOpenGLRenderWindow* window,
  const std::vector<TransferFunctionTable>& tables, BufferName nodes, BufferName intervals)
{
  std::vector<std::array<float, 2>> allNodes;
  std::vector<TransferFunctionTable::Interval> allIntervals;
  for (const TransferFunctionTable& table : tables)
  {
    for (std::size_t i = 0; i < table.Nodes.size(); ++i)
    {
      allNodes.push_back({ { table.Nodes[i], table.Widths[i] } });
    }
    allIntervals.insert(allIntervals.end(), table.Intervals.begin(), table.Intervals.end());
  }
  const std::string error = this->Buffers[nodes]->Upload(window, allNodes.data(), allNodes.size(), 2, VTK_FLOAT);
  return error.empty()
    ? this->Buffers[intervals]->Upload(window, allIntervals.data(), 2 * allIntervals.size(), 4, VTK_FLOAT)
    : error;
}

std::string CellCompositingPass::UploadTransferFunctions(vtkOpenGLRenderWindow* window,
  const std::vector<TransferFunctionTable>& colorAndOpacity, const std::vector<TransferFunctionTable>& opacity,
  const std::vector<std::int32_t>& tables)
{
  this->NumberOfTransferNodes = static_cast<int>(colorAndOpacity[0].Nodes.size());
  this->NumberOfOpacityNodes = static_cast<int>(opacity[0].Nodes.size());
  this->UseLayers = colorAndOpacity.size() > 1;
  this->NarrowIntervals = hasNarrowIntervals(colorAndOpacity) || hasNarrowIntervals(opacity);
  std::vector<std::array<float, 4>> layers; // first node, number of nodes, of either table
  float first[2] = { 0, 0 };
  for (std::size_t i = 0; i < colorAndOpacity.size(); ++i)
  {
    const float sizes[2] = { float(colorAndOpacity[i].Nodes.size()), float(opacity[i].Nodes.size()) };
    layers.push_back({ { first[0], sizes[0], first[1], sizes[1] } });
    first[0] += sizes[0];
    first[1] += sizes[1];
  }
  std::string error = this->UploadTables(window, colorAndOpacity, TransferNodes, TransferIntervals);
  error = error.empty() ? this->UploadTables(window, opacity, OpacityNodes, OpacityIntervals) : error;
  error = error.empty() ? this->Buffers[LayerTables]->Upload(window, layers.data(), layers.size(), 4, VTK_FLOAT) : error;
  return error.empty() ? this->Buffers[TetrahedronLayers]->Upload(window, tables.data(), tables.size(), 1, VTK_INT)
                       : error;
}

std::string CellCompositingPass::UploadContours(vtkOpenGLRenderWindow* window, const ContourScene& contours)
{
  this->NumberOfContours = static_cast<int>(contours.Contours.size());
  this->ContourOfColor = contours.OfColor;
  this->SmoothContourNormals = contours.Smooth;
  std::string error;
  const auto upload = [&](BufferName name, const auto& values, std::size_t tuples, int components) {
    error = error.empty() ? this->Buffers[name]->Upload(window, values.data(), tuples, components, VTK_FLOAT) : error;
  };
  upload(Contours, contours.Contours, 2 * contours.Contours.size(), 4);
  upload(ContourScalars, contours.Scalars, contours.Scalars.size(), 1);
  upload(ContourGradients, contours.Gradients, contours.Gradients.size(), 4);
  return error;
}

std::string CellCompositingPass::UploadOrder(
  vtkOpenGLRenderWindow* window, const std::vector<std::int32_t>& order)
{
  this->OrderSize = order.size();
  return this->Buffers[DrawingOrder]->Upload(window, order.data(), order.size(), 1, VTK_INT);
}

std::string CellCompositingPass::Draw(vtkOpenGLRenderWindow* window, const View& view, const Options& options)
{
  vtkOpenGLState* state = window->GetState();
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  vtkOpenGLState::ScopedglScissor savedScissorBox(state);
  vtkOpenGLState::ScopedglEnableDisable savedScissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedCulling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate savedBlendFunction(state);

  std::copy(viewport + 2, viewport + 4, this->ImageSize);
  this->Depth.Copy(window, viewport);
  std::string error;
  if (this->Accumulation.Begin(window, viewport))
  {
    error = this->DrawTetrahedra(window, view, options);
  }
  else
  {
    error = "this OpenGL cannot draw into 32-bit float images";
  }
  this->Accumulation.End(window);
  if (error.empty())
  {
    this->Accumulation.Overlay(window, viewport);
    error = checkOpenGL("while compositing cells");
  }
  return error;
}

// Options are constants of the shader: what is switched off costs nothing. The window's cache keeps the variants.
bool CellCompositingPass::ReadyProgram(vtkOpenGLRenderWindow* window, const Options& options)
{
  const std::string constants = constant("useCellScalars", this->UseCellScalars) +
    constant("separateOpacity", this->SeparateOpacity) + constant("opacityOnCells", this->OpacityOnCells) +
    constant("averageIntegration", options.AverageIntegration) +
    constant("splitAtControlPoints", options.SplitAtControlPoints) + constant("useLayers", this->UseLayers) +
    constant("useContours", this->NumberOfContours > 0) + constant("contourOfColor", this->ContourOfColor) +
    constant("contourLayers", options.ContourLayers && this->UseLayers) +
    constant("consistentFaces", this->NarrowIntervals || this->NumberOfContours > 0) +
    constant("contourLighting", options.ContourLighting) +
    constant("smoothContourNormals", this->SmoothContourNormals);
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(CellCompositingVertex,
    specialized(CellCompositingFragment, constants).c_str(),
    specialized(CellCompositingGeometry, constants).c_str());
  if (program != this->Program)
  {
    this->Program = program;
    this->VertexArray->ShaderProgramChanged();
  }
  return program != nullptr;
}

std::string CellCompositingPass::DrawTetrahedra(
  vtkOpenGLRenderWindow* window, const View& view, const Options& options)
{
  if (!this->ReadyProgram(window, options))
  {
    return "the shaders did not compile";
  }
  this->VertexArray->Bind();
  this->ActivateTextures();
  this->SetUniforms(view, options);

  // Back faces in front of the near plane or behind the far plane still end segments inside: clamp, do not clip.
  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  glEnable(GL_DEPTH_CLAMP);
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST); // the shader ends each ray at the opaque depth
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(this->OrderSize));
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }

  this->VertexArray->Release();
  for (auto& buffer : this->Buffers)
  {
    buffer->Deactivate();
  }
  this->Depth.GetTexture()->Deactivate();
  return std::string();
}

void CellCompositingPass::ActivateTextures()
{
  static const char* const names[NumberOfBuffers] = { "points", "tetrahedra", "cellScalars", "opacityScalars",
    "drawingOrder", "transferNodes", "transferIntervals", "opacityNodes", "opacityIntervals",
    "tetrahedronLayers", "layerTables", "contourScalars", "contours", "contourGradients" };
  for (int i = 0; i < NumberOfBuffers; ++i)
  {
    this->Program->SetUniformi(names[i], this->Buffers[i]->Activate());
  }
  this->Depth.GetTexture()->Activate();
  this->Program->SetUniformi("opaqueDepth", this->Depth.GetTexture()->GetTextureUnit());
}

void CellCompositingPass::SetUniforms(const View& view, const Options& options)
{
  vtkShaderProgram* program = this->Program;
  program->SetUniformi("numberOfTransferNodes", this->NumberOfTransferNodes);
  program->SetUniformi("numberOfOpacityNodes", this->NumberOfOpacityNodes);
  program->SetUniformf("extinctionScale", static_cast<float>(options.ExtinctionScale));

  vtkNew<vtkMatrix4x4> transposed; // as OpenGL wants it
  vtkMatrix4x4::Transpose(view.ModelToView, transposed);
  program->SetUniformMatrix("MCVCMatrix", transposed);
  vtkMatrix4x4::Transpose(view.ViewToDevice, transposed);
  program->SetUniformMatrix("VCDCMatrix", transposed);
  program->SetUniform4f("eyeMC", toFloat(view.EyeModel).data());
  program->SetUniform4f("eyeVC", toFloat(view.EyeView).data());
  program->SetUniform4f("depthToVC", depthToView(view.ViewToDevice).data());

  float nodes[numberOfQuadratureNodes][2];
  for (int i = 0; i < numberOfQuadratureNodes; ++i)
  {
    nodes[i][0] = static_cast<float>(quadratureNodes[i][0]);
    nodes[i][1] = static_cast<float>(quadratureNodes[i][1]);
  }
  program->SetUniform2fv("quadratureNodes", numberOfQuadratureNodes, nodes);
  vtkNew<vtkMatrix3x3> rays;
  pixelToRay(view, this->ImageSize, rays);
  program->SetUniformMatrix("pixelToRay", rays);
  if (this->NumberOfContours > 0)
  {
    this->SetContourUniforms(view, options);
  }
}

void CellCompositingPass::SetContourUniforms(const View& view, const Options& options)
{
  vtkShaderProgram* program = this->Program;
  program->SetUniformi("numberOfContours", this->NumberOfContours);
  program->SetUniform4f("contourShading", options.ContourShading.data());
  // Gradients go by the inverse transpose; vtkMatrix3x3 is transposed on its way to OpenGL, so that the inverse is given.
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(view.ModelToView, inverse);
  vtkNew<vtkMatrix3x3> gradients;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      gradients->SetElement(i, j, inverse->GetElement(i, j));
    }
  }
  program->SetUniformMatrix("gradientMatrix", gradients);

  std::array<std::vector<float>, 5> values;
  for (const SceneLight& light : options.Lights)
  {
    const std::array<float, 3> parts[5] = { light.Color, light.Direction, light.Position, light.Attenuation, light.Cone };
    for (std::size_t i = 0; i < 5; ++i)
    {
      values[i].insert(values[i].end(), parts[i].begin(), parts[i].end());
    }
  }
  const int count = static_cast<int>(options.Lights.size());
  program->SetUniformi("numberOfLights", count);
  const char* const names[5] = { "lightColors", "lightDirections", "lightPositions", "lightAttenuations", "lightCones" };
  for (std::size_t i = 0; i < 5 && count > 0; ++i)
  {
    program->SetUniform3fv(names[i], count, values[i].data());
  }
}

bool CellCompositingPass::CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image)
{
  return this->Accumulation.CopyTo(window, image);
}

void CellCompositingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& buffer : this->Buffers)
  {
    buffer->Release(window);
  }
  this->Depth.ReleaseGraphicsResources(window);
  this->Accumulation.ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}

} // namespace nephoscope
