// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Draws splats into a float image and lays it over the scene. */
#ifndef nephoscope_SplatPass_h
#define nephoscope_SplatPass_h

#include "BufferTexture.h"
#include "ClippingPlanes.h"
#include "FloatLayer.h"
#include "HazeView.h"
#include "SplatKernel.h"
#include "SplatLight.h"
#include "SplatRegion.h"
#include "VertexNumbers.h"
#include "VolumePeel.h"

#include "vtkNew.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
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
  // Numbers of splats at the end of the order, each with those before it (SplatRanges.h): so near
  // that the eye may be inside; too large to be points; too close to be drawn to first order. The
  // default: all are drawn as parallelograms.
  std::size_t NearSplats = 0;
  std::size_t LargeSplats = std::numeric_limits<std::size_t>::max();
  std::size_t CloserSplats = std::numeric_limits<std::size_t>::max();
  double LeastPointDistance = 0.0; // in radii of the largest splat; nearer ones are not points
  bool Vectors = false;
  bool Segments = false;     // instead of streaks
  bool MediaApart = false;   // the order holds vectors as items of their own
  double MaximumSpeed = 1.0; // where vectors are fully drawn
  double VectorScale = 1.0;  // optical depth of vectors at full strength
  double VectorUnit = 1.0;   // of the lengths that follow, in units of the data
  double StreakPeriod = 1.5;
  double StreakWidth = 0.1;
  double SegmentLength = 2.0;
  double SegmentWidth = 1.5;       // pixels
  double ImageSampleDistance = 1;  // from sample to sample of the image
  SplatRegion Region = WholeSpace; // relative to the samples' centre
  HazeView Haze;
  ClippingPlanes Planes;
  std::size_t FirstSplat = 0;  // of the order, where volumes are drawn in slices
  std::size_t SplatsAfter = 0; // that are not drawn
  double LayerThickness = 0.0; // of layers at right angles to the line of sight; 0: there are none
};

class SplatPass
{
public:
  SplatPass();
  ~SplatPass();

  // Each returns an empty string, or what went wrong.
  /**
   * Places and shapes of the splats of the classes, and after them those of the nodes of `tree`;
   * vectors are gone.
   */
  std::string UploadCells(vtkOpenGLRenderWindow* window, const SplatSamples& samples,
    const SplatClasses& classes, const SplatTree& tree);
  /** Colour and extinction of the same. */
  std::string UploadColors(
    vtkOpenGLRenderWindow* window, const SplatClasses& classes, const SplatTree& tree);
  /** Where it is used, colours are the scalars of the light. */
  std::string UploadLight(vtkOpenGLRenderWindow* window, const SplatLightSource& source,
    const SplatSamples& samples, const SplatClasses& classes, const SplatTree& tree)
  {
    return this->Light.Upload(window, source, samples, classes, tree);
  }
  /** (x, y, z, phase) of every splat of the classes and node, and (red, green, blue, seed). */
  std::string UploadVectors(
    vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& vectors);
  std::string UploadVectorColors(
    vtkOpenGLRenderWindow* window, const std::vector<std::array<float, 4>>& colors);
  /**
   * From back to front; ~n for the vector of splat n, where media are apart. `weights`, one for
   * each, of its extinction; empty: all 1.
   */
  void UploadOrder(const std::vector<std::int32_t>& order, const std::vector<float>& weights);
  std::string Draw(
    vtkOpenGLRenderWindow* window, const SceneView& view, const SplatDrawingOptions& options);
  /** Draws only the part that a depth peeling pass requests, into its targets. */
  std::string DrawPeel(vtkOpenGLRenderWindow* window, const SceneView& view,
    const SplatDrawingOptions& options, const VolumePeel::Request& request);

  /** False if nothing has been drawn yet, or if the last drawing was a peel. */
  bool CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image)
  {
    return !this->Peeled && this->Layer.CopyTo(window, image);
  }
  void ReleaseGraphicsResources(vtkWindow* window);

  static constexpr int LargestPoint = 128; ///< pixels across

  /**
   * How a range of splats is drawn: as points, as parallelograms, or, around the eye, over the
   * whole viewport.
   */
  enum class Way
  {
    FarPoints, ///< to first order in size over distance
    Points,
    Quads,
    Viewport
  };
  struct Variant ///< of the shaders
  {
    Way As = Way::Quads;
    bool JacobianPerSplat = false;
    bool Parallel = false;
    bool Cut = true;     ///< by opaque geometry
    bool Peeled = false; ///< into the ranges of a peel
    bool Region = false; ///< not all of space
    bool Fade = false;   ///< there are weights
    bool Light = false;  ///< depends on the direction of view
  };

private:
  std::string DrawAll(vtkOpenGLRenderWindow* window, const SceneView& view,
    const SplatDrawingOptions& options, const int viewport[4], vtkTextureObject* depths);
  std::string DrawRange(vtkOpenGLRenderWindow* window, const SceneView& view,
    const SplatDrawingOptions& options, const Variant& variant,
    const std::array<std::size_t, 2>& range);
  bool HasOpaquePixels(vtkOpenGLRenderWindow* window);
  void Bind(vtkShaderProgram* program);
  void SetUniforms(
    vtkShaderProgram* program, const SceneView& view, const SplatDrawingOptions& options) const;

  BufferTexture Splats;
  BufferTexture Colors;
  BufferTexture Vectors;
  BufferTexture VectorColors;
  SplatLight Light;
  VertexNumbers Order;
  VertexNumbers Weights;
  std::size_t Count = 0;
  bool Fade = false; // there are weights
  bool JacobianPerSplat = false;
  int FirstNode = 0; // the first splat with a Jacobian of its own, where others share one
  float SharedJacobian[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; // columns
  float PixelsPerDevice[2] = { 1, 1 };
  int DepthUnit = 0; // of the opaque depth, or of the ranges of a peel
  FloatLayer Layer;
  VolumePeel Peel;
  bool Peeled = false;
  bool TestsFarEnds = false; // of splats, against the near ends of ranges
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
};

} // namespace nephoscope

#endif
