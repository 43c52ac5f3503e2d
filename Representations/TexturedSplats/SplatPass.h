// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Draws splats into a float image and lays it over the scene. */
#ifndef SplatPass_h
#define SplatPass_h

#include "BufferTexture.h"
#include "FloatLayer.h"
#include "SplatKernel.h"

#include "vtkNew.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

struct SceneView;
struct SplatClasses;
struct SplatSamples;
class SplatTree;

struct SplatDrawingOptions
{
  SplatKernel Kernel = SplatKernel::Cubic;
  double ExtinctionScale = 1.0;
  std::size_t NearSplats = 0; // the last ones of the order: so near that the eye may be inside
  bool Vectors = false;
  bool Segments = false;      // instead of streaks
  bool MediaApart = false;    // the order holds vectors as items of their own
  double GreatestSpeed = 1.0; // where vectors are fully drawn
  double VectorScale = 1.0;   // optical depth of vectors at full strength
  double VectorUnit = 1.0;    // of the lengths that follow, in units of the data
  double StreakPeriod = 1.5;
  double StreakWidth = 0.1;
  double SegmentLength = 2.0;
  double SegmentWidth = 1.5; // pixels
};

class SplatPass
{
public:
  SplatPass();
  ~SplatPass();

  // Each returns an empty string, or what went wrong.
  /** The splats of the classes, and after them the nodes of `tree`. */
  std::string UploadSplats(vtkOpenGLRenderWindow* window, const SplatSamples& samples,
    const SplatClasses& classes, const SplatTree& tree);
  /** (x, y, z, phase) of every splat of the classes and node, and (red, green, blue, seed). */
  std::string UploadVectors(
    vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& vectors);
  std::string UploadVectorColors(
    vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& colors);
  /** From back to front; ~n for the vector of splat n, where media are apart. */
  std::string UploadOrder(vtkOpenGLRenderWindow* window, const std::vector<std::int32_t>& order);
  std::string Draw(
    vtkOpenGLRenderWindow* window, const SceneView& view, const SplatDrawingOptions& options);

  bool CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image)
  {
    return this->Layer.CopyTo(window, image);
  }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string DrawRange(vtkOpenGLRenderWindow* window, const SceneView& view,
    const SplatDrawingOptions& options, bool nearEye);
  void SetUniforms(
    vtkShaderProgram* program, const SceneView& view, const SplatDrawingOptions& options) const;

  BufferTexture Splats;
  BufferTexture Colors;
  BufferTexture Vectors;
  BufferTexture VectorColors;
  BufferTexture Order;
  std::size_t Count = 0;
  bool JacobianPerSplat = false;
  int FirstNode = 0; // the first splat with a Jacobian of its own, where others share one
  float SharedJacobian[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; // columns
  float PixelsPerDevice[2] = { 1, 1 };
  int DepthUnit = 0;
  FloatLayer Layer;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; // without attributes
  vtkShaderProgram* Program = nullptr;            // owned by the window's shader cache
};

} // namespace nephoscope

#endif
