// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "SplatPass.h"

#include "PointMargin.h"
#include "SamplersApart.h"
#include "ShaderArrays.h"
#include "ShaderParts.h"
#include "SplatClasses.h"
#include "SplatReach.h"
#include "SplatRegionUniforms.h"
#include "SplatSamples.h"
#include "SplatShaderConstants.h"
#include "SplatTree.h"
#include "ViewState.h"
#include "VolumeSlices.h"

#include "OpaquePixelsFragment.h"
#include "OpaquePixelsVertex.h"
#include "SplatCell.h"
#include "SplatFootprint.h"
#include "SplatInRegion.h"
#include "SplatLightShader.h"
#include "SplatRegionShader.h"
#include "TexturedSplatFragment.h"
#include "TexturedSplatGeometry.h"
#include "TexturedSplatPointFragment.h"
#include "TexturedSplatPointVertex.h"
#include "TexturedSplatVertex.h"
#include "VectorSplatGeometry.h"
#include "VectorTextureShader.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <memory>
#include <sstream>

namespace nephoscope
{
namespace
{
// Pixels: splats whose cell is smaller are spread over a pixel, whose own variance is that of a
// box, 1/12, over the kernel's.
constexpr double largeEnough = 1.0;
constexpr double dotSize = 3.0; // square pixels: the sum of the squares of two half axes of a cell,
                                // below which splats are dots
constexpr double pixelVarianceOfKernels = 1.0 / 12.0 / cubic_kernel::variance;
constexpr float tailShare = 0.6f;     // of a streak's period, at full speed
constexpr double streakSpacing = 1.0; // from row to row, in units of the vectors

// SplatFootprint.glsl: zOfDepth
float ZOfDepth(float depth, const std::array<float, 4>& depthToVC)
{
  const float e = 1.0f - depth;
  return depth <= 0.0f ? 1.0e37f
    : e > 0.0f         ? (depthToVC[0] + depthToVC[1] * e) / (depthToVC[2] + depthToVC[3] * e)
                       : -1.0e37f;
}

std::array<float, 2> ZOfSlice(const std::array<float, 4>& depthToVC)
{
  const VolumeSlices* slices = VolumeSlices::GetCurrent();
  const std::array<float, 2> depths = slices ? slices->GetDepths() : std::array<float, 2>{ 0, 1 };
  return { ZOfDepth(depths[0], depthToVC), ZOfDepth(depths[1], depthToVC) };
}

// Vertices of quadrangles: the medium, or its halves behind and in front of streaks, or of two
// segments.
int VerticesOfSplat(const SplatDrawingOptions& options, bool nearEye)
{
  const bool both = nearEye || !options.MediaApart;
  const int vectors = options.Segments ? 2 : 1;
  return 4 * (options.Vectors ? vectors + (both ? 2 : 0) : 1);
}

std::string ConstantsOfShader(const SplatDrawingOptions& options, const SplatPass::Variant& variant)
{
  const bool nearEye = variant.As == SplatPass::Way::Viewport;
  const bool firstOrder = variant.As == SplatPass::Way::FarPoints && !variant.Parallel;
  const bool vectors = options.Vectors;
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint
       << "const bool jacobianPerSplat = " << (variant.JacobianPerSplat ? "true" : "false") << ";\n"
       << "const bool parallelRays = " << (variant.Parallel ? "true" : "false") << ";\n"
       << "const bool cutByOpaque = " << (variant.Cut ? "true" : "false") << ";\n"
       << "const bool peeled = " << (variant.Peeled ? "true" : "false") << ";\n"
       << "const bool firstOrder = " << (firstOrder ? "true" : "false") << ";\n"
       << "const int kernel = " << static_cast<int>(options.Kernel) << ";\n"
       << "const bool nearEye = " << (nearEye ? "true" : "false") << ";\n"
       << "const bool drawSegments = " << (options.Segments ? "true" : "false") << ";\n"
       << "const bool mediaApart = " << (options.MediaApart ? "true" : "false") << ";\n"
       << "#define MAX_VERTICES " << VerticesOfSplat(options, nearEye) << "\n"
       << (variant.Light ? "#define CAMERA_LIGHT\n" : "") << (variant.Fade ? "#define FADE\n" : "")
       << (variant.Region ? "#define DRAW_REGION\n" : "") << "const float dotSize = " << dotSize
       << ";\n"
       << "const float largeEnough = " << largeEnough << ";\n"
       << "const float pixelVariance = " << pixelVarianceOfKernels << ";\n";
  text
    << "#define FOOTPRINT_PEAK " << KernelFootprint(options.Kernel, 0.0) << "\n"
    << "#define MEDIUM 0\n#define HALF_MEDIUM 1\n#define STREAKS 2\n#define SEGMENT 3\n#define VIEWPORT 4\n";
  // Where vectors are not drawn, their shaders are left out.
  return text.str() + KernelConstants() + options.Haze.Definition() + options.Planes.Definition() +
    (vectors ? "#define DRAW_VECTORS\n" + VectorTextureConstants(streakSpacing) : std::string());
}

std::string Specialized(const char* shader, const std::string& constants)
{
  return WithShaderParts(shader,
    { { "VectorSplat", VectorSplatGeometry }, { "VectorTexture", VectorTextureShader },
      { "Constants", constants }, { "Light", SplatLightShader },
      { "CameraLight", CameraLight::ShaderText() },
      { "Arrays", ArrayDeclarations(CurrentArrayLayout()) }, { "Cell", SplatCell },
      { "Footprint", SplatFootprint }, { "Region", SplatRegionShader },
      { "InRegion", SplatInRegion } });
}

using Float4 = std::array<float, 4>;

// Columns of J with the centre in the fourth components.
void PackCell(
  const SplatSamples::Jacobian& j, const SplatSamples::Float3& p, std::vector<Float4>& packed)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    packed.push_back({ { j[c][0], j[c][1], j[c][2], p[c] } });
  }
}

// The centre alone where the Jacobian is shared; nodes of the tree always have their own.
std::vector<Float4> PackSplats(
  const SplatSamples& samples, const SplatClasses& classes, const SplatTree& tree, bool jacobians)
{
  std::vector<Float4> packed;
  packed.reserve(classes.Samples.size() * (jacobians ? 3 : 1) + 3 * tree.Nodes().size());
  for (const std::int32_t sample : classes.Samples)
  {
    const auto i = static_cast<std::size_t>(sample);
    const auto& p = samples.Positions[i];
    if (jacobians)
    {
      PackCell(samples.JacobianOf(i), p, packed);
    }
    else
    {
      packed.push_back({ { p[0], p[1], p[2], 0 } });
    }
  }
  for (const SplatTreeNode& node : tree.Nodes())
  {
    PackCell(node.Jacobian, node.Position, packed);
  }
  return packed;
}
}

SplatPass::SplatPass() = default;
SplatPass::~SplatPass() = default;

std::string SplatPass::UploadCells(vtkOpenGLRenderWindow* window, const SplatSamples& samples,
  const SplatClasses& classes, const SplatTree& tree)
{
  this->FirstNode = static_cast<int>(classes.Samples.size());
  this->JacobianPerSplat = !samples.HaveOneShape;
  for (std::size_t i = 0; i < 9; ++i)
  {
    this->SharedJacobian[i] = samples.Jacobians[0][i / 3][i % 3];
  }
  const std::vector<Float4> packed = PackSplats(samples, classes, tree, this->JacobianPerSplat);
  std::string error = this->Splats.Upload(window, packed.data(), packed.size(), 4, VTK_FLOAT);
  error = error.empty() ? this->UploadVectors(window, {}) : error; // until there are some
  return error.empty() ? this->UploadVectorColors(window, {}) : error;
}

std::string SplatPass::UploadColors(
  vtkOpenGLRenderWindow* window, const SplatClasses& classes, const SplatTree& tree)
{
  if (tree.IsEmpty())
  {
    return this->Colors.Upload(window, classes.Colors.data(), classes.Colors.size(), 4, VTK_FLOAT);
  }
  std::vector<Float4> colors = classes.Colors;
  for (const SplatTreeNode& node : tree.Nodes())
  {
    colors.push_back(node.Color);
  }
  return this->Colors.Upload(window, colors.data(), colors.size(), 4, VTK_FLOAT);
}

std::string SplatPass::UploadVectors(
  vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& vectors)
{
  return this->Vectors.Upload(window, vectors.data(), vectors.size(), 4, VTK_FLOAT);
}

std::string SplatPass::UploadVectorColors(
  vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& colors)
{
  return this->VectorColors.Upload(window, colors.data(), colors.size(), 4, VTK_FLOAT);
}

void SplatPass::UploadOrder(
  const std::vector<std::int32_t>& order, const std::vector<float>& weights)
{
  this->Count = order.size();
  this->Fade = !weights.empty();
  this->Order.Upload(order);
  this->Weights.Upload(weights);
}

std::string SplatPass::Draw(
  vtkOpenGLRenderWindow* window, const SceneView& view, const SplatDrawingOptions& options)
{
  this->Peeled = false;
  const auto paint = [&](const int viewport[4], OpaqueDepth& opaqueDepth) {
    return this->DrawAll(window, view, options, viewport, opaqueDepth.GetTexture());
  };
  return this->Layer.Draw(window, paint, nullptr, options.ImageSampleDistance);
}

std::string SplatPass::DrawPeel(vtkOpenGLRenderWindow* window, const SceneView& view,
  const SplatDrawingOptions& options, const VolumePeel::Request& request)
{
  this->Peeled = true;
  const VolumeSlices* slices = VolumeSlices::GetCurrent();
  this->TestsFarEnds = !slices || !slices->IsFront();
  const auto paint = [&](const int viewport[4]) {
    return this->DrawAll(window, view, options, viewport, this->Peel.GetRanges());
  };
  return this->Layer.DrawPeel(window, this->Peel, request, paint,
    this->TestsFarEnds ? VolumePeel::Nearest : VolumePeel::Farthest);
}

std::string SplatPass::DrawAll(vtkOpenGLRenderWindow* window, const SceneView& view,
  const SplatDrawingOptions& options, const int viewport[4], vtkTextureObject* depths)
{
  this->PixelsPerDevice[0] = 0.5f * static_cast<float>(viewport[2]);
  this->PixelsPerDevice[1] = 0.5f * static_cast<float>(viewport[3]);
  depths->Activate();
  this->DepthUnit = depths->GetTextureUnit();
  Variant variant;
  variant.JacobianPerSplat = this->JacobianPerSplat;
  variant.Parallel = view.EyeView[3] == 0;
  variant.Peeled = this->Peeled;
  variant.Cut = !this->Peeled && this->HasOpaquePixels(window);
  if (variant.Cut)
  {
    this->Layer.HideBehindOpaque(window);
  }
  variant.Fade = this->Fade;
  variant.Light = this->Light.IsUsed();
  variant.Region = IsRegion(options.Region);
  const std::size_t ends[] = { options.CloserSplats, options.LargeSplats, options.NearSplats, 0 };
  const Way ways[] = { Way::FarPoints, Way::Points, Way::Quads, Way::Viewport };
  std::string error;
  std::size_t begin = std::min(options.FirstSplat, this->Count);
  const std::size_t all = this->Count - std::min(options.SplatsAfter, this->Count);
  for (std::size_t i = 0; i < 4 && error.empty(); ++i)
  {
    const std::size_t end = std::min(this->Count - std::min(ends[i], this->Count), all);
    if (end > begin)
    {
      variant.As = ways[i];
      error = this->DrawRange(window, view, options, variant, { { begin, end } });
      begin = end;
    }
  }
  depths->Deactivate();
  return error;
}

// Looking at the opaque depth costs as much as all else that is done for a pixel: it is left out
// where there is nothing to see.
bool SplatPass::HasOpaquePixels(vtkOpenGLRenderWindow* window)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(OpaquePixelsVertex, OpaquePixelsFragment, "");
  if (!program)
  {
    return true;
  }
  this->Bind(program);
  program->SetUniformi("opaqueDepth", this->DepthUnit);
  GLuint query = 0, samples = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  glDeleteQueries(1, &query);
  this->VertexArray->Release();
  return samples > 0;
}

void SplatPass::Bind(vtkShaderProgram* program)
{
  if (program != this->Program)
  {
    this->Program = program;
    this->VertexArray->ShaderProgramChanged();
  }
  this->VertexArray->Bind();
}

std::string SplatPass::DrawRange(vtkOpenGLRenderWindow* window, const SceneView& view,
  const SplatDrawingOptions& options, const Variant& variant,
  const std::array<std::size_t, 2>& range)
{
  const std::string constants = ConstantsOfShader(options, variant);
  const bool points = variant.As == Way::FarPoints || variant.As == Way::Points;
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    Specialized(points ? TexturedSplatPointVertex : TexturedSplatVertex, constants).c_str(),
    Specialized(points ? TexturedSplatPointFragment : TexturedSplatFragment, constants).c_str(),
    points ? "" : Specialized(TexturedSplatGeometry, constants).c_str());
  if (!program)
  {
    return "the shaders did not compile";
  }
  this->Bind(program);
  SetSamplersApart(program);
  this->SetUniforms(program, view, options);
  program->SetUniformi("splats", this->Splats.Activate());
  program->SetUniformi("splatColors", this->Colors.Activate());
  this->Order.Activate(program, "splatNumber");
  this->Weights.Activate(program, "splatWeight");
  program->SetUniformi("splatVectors", this->Vectors.Activate());
  program->SetUniformi("vectorColors", this->VectorColors.Activate());
  this->Light.Activate(program, view.ModelToView);
  {
    const std::unique_ptr<PointMargin> margin(points
        ? new PointMargin(window->GetState(), static_cast<int>(2 * this->PixelsPerDevice[0]),
            static_cast<int>(2 * this->PixelsPerDevice[1]), LargestPoint / 2)
        : nullptr);
    glDrawArrays(
      GL_POINTS, static_cast<GLint>(range[0]), static_cast<GLsizei>(range[1] - range[0]));
  }
  this->Order.Deactivate();
  this->Weights.Deactivate();
  this->Splats.Deactivate();
  this->Colors.Deactivate();
  this->Vectors.Deactivate();
  this->VectorColors.Deactivate();
  this->Light.Deactivate();
  this->VertexArray->Release();
  return std::string();
}

void SplatPass::SetUniforms(
  vtkShaderProgram* program, const SceneView& view, const SplatDrawingOptions& options) const
{
  options.Haze.SetUniforms(program);
  options.Planes.SetUniforms(program);
  vtkNew<vtkMatrix4x4> transposed; // as OpenGL wants it
  vtkMatrix4x4::Transpose(view.ModelToView, transposed);
  program->SetUniformMatrix("modelToVC", transposed);
  vtkMatrix4x4::Transpose(view.ViewToDevice, transposed);
  program->SetUniformMatrix("VCToDC", transposed);
  program->SetUniformMatrix3x3("sharedJacobian", const_cast<float*>(this->SharedJacobian));
  program->SetUniformi("firstNode", this->FirstNode);
  program->SetUniformf("kernelRadius", static_cast<float>(KernelRadius(options.Kernel)));
  program->SetUniformf("extinctionScale", static_cast<float>(options.ExtinctionScale));
  program->SetUniformf("greatestSpeed", static_cast<float>(options.MaximumSpeed));
  program->SetUniformf("vectorScale", static_cast<float>(options.VectorScale));
  program->SetUniformf("vectorUnit", static_cast<float>(options.VectorUnit));
  const auto period = static_cast<float>(options.StreakPeriod);
  program->SetUniformf("streakLength", static_cast<float>(streakKernelShare) * period);
  const float shape[3] = { period, tailShare * period, static_cast<float>(options.StreakWidth) };
  program->SetUniform3f("streakShape", shape);
  program->SetUniformf("segmentLength", static_cast<float>(options.SegmentLength));
  program->SetUniformf("segmentWidth", static_cast<float>(options.SegmentWidth));
  program->SetUniform2f("pixelsPerDC", this->PixelsPerDevice);
  const float within[2] = { this->PixelsPerDevice[0] /
      (this->PixelsPerDevice[0] + 0.5f * LargestPoint),
    this->PixelsPerDevice[1] / (this->PixelsPerDevice[1] + 0.5f * LargestPoint) };
  program->SetUniform2f("withinMargin", within);
  program->SetUniform4f("rayOfPixel", RayOfPixel(view.ViewToDevice, this->PixelsPerDevice).data());
  program->SetUniformi("opaqueDepth", this->DepthUnit);
  program->SetUniformi("depthRanges", this->DepthUnit);
  const std::array<float, 4> depthToVC = DepthToViewOf(view.ViewToDevice);
  program->SetUniform4f("depthToVC", depthToVC.data());
  program->SetUniformi("testsFarEnds", this->Peeled && this->TestsFarEnds);
  program->SetUniform2f("sliceZ", ZOfSlice(depthToVC).data());
  SetRegionUniforms(program, view, options, this->PixelsPerDevice);
}

void SplatPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Splats.Release(window);
  this->Colors.Release(window);
  this->Order.Release();
  this->Weights.Release();
  this->Vectors.Release(window);
  this->VectorColors.Release(window);
  this->Light.Release(window);
  this->Layer.ReleaseGraphicsResources(window);
  this->Peel.ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
}

} // namespace nephoscope
