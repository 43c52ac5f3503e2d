// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Input of the methods of drawing cells: the view, the options, and their common GPU data. */
#ifndef nephoscope_CellDrawing_h
#define nephoscope_CellDrawing_h

#include "CellMethod.h"
#include "ClippingPlanes.h"
#include "HazeView.h"
#include "SceneLights.h"
#include "ViewState.h"

#include <array>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace nephoscope
{

class CellBuffers;
class ContourBuffers;
class OpaqueDepth;
class VolumePeel;
struct EyeTetrahedron;

using CellView = SceneView;

/**
 * The current context computes on the processor. Uniforms are then worth a copy
 * (RayCells.frag.glsl); a GPU would keep the copies in registers that it has too few of.
 */
bool IsSoftwareOpenGL();

struct CellDrawingOptions
{
  CellMethod Method = CellMethod::Cells;
  bool AverageIntegration = false;
  bool SplitAtControlPoints = true;
  bool Trilinear = false;         ///< the scalar in hexahedra; otherwise they are tetrahedra
  double ImageSampleDistance = 1; ///< from ray to ray, in pixels
  double ExtinctionScale = 1.0;   ///< extinction per world length at opacity 1
  bool CameraLight = false;       ///< the colour depends on the direction of view
  bool ContourLayers = false;     ///< layers lie between contours; otherwise tetrahedra have them
  bool ContourLighting = false;
  std::array<float, 4> ContourShading = { { 0, 1, 0,
    1 } };                             ///< ambient, diffuse, specular, specular power
  std::vector<SceneLight> Lights;      ///< of contour surfaces
  const EyeTetrahedron* Eye = nullptr; ///< where rays start
  HazeView Haze;
  ClippingPlanes Planes;
};

struct CellDrawing
{
  vtkOpenGLRenderWindow* Window;
  const int* Viewport; ///< x, y, width, height
  const CellView& View;
  const CellDrawingOptions& Options;
  CellBuffers& Buffers;
  ContourBuffers& Contours;
  OpaqueDepth& Depth;
  VolumePeel* Peel = nullptr; ///< where set, its depth ranges count and not the opaque depth
  int Range = 0;              ///< the one of them that is drawn

  std::string ShaderConstants() const { return this->OwnConstants() + this->CommonConstants(); }
  /** The same constants without those common to everything that the renderer draws. */
  std::string OwnConstants() const;
  /** For one of several media: its number, OwnConstants, and the table of a small function. */
  std::string MediumConstants(int number) const;
  /** The constants that are the same for all media. */
  std::string CommonConstants() const;
  /** Binds the shared textures and sets the uniforms that every fragment shader of cells has. */
  void SetUniforms(vtkShaderProgram* program) const;
  ///@{
  /**
   * The same in two parts, where the shader has several media: what they have in common, and one of
   * them.
   */
  void SetCommonUniforms(vtkShaderProgram* program) const;
  void SetOwnUniforms(vtkShaderProgram* program, int instance) const;
  ///@}
  void Finish() const;

private:
  void SetDepths(vtkShaderProgram* program) const;
};

} // namespace nephoscope

#endif
