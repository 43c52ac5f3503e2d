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
