// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws cells into a float image and lays it over the scene.
 *
 * Everything the shaders read is in buffer textures: geometry and transfer functions are uploaded
 * when they change, the drawing order of projected cells whenever the view does.
 */
#ifndef nephoscope_CellCompositingPass_h
#define nephoscope_CellCompositingPass_h

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "ContourBuffers.h"
#include "FloatLayer.h"
#include "ProjectedCells.h"
#include "RayCells.h"
#include "RayMedia.h"
#include "VolumePeel.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
class CellScene;
struct TetrahedronNeighbors;
class ContourScene;
class PolygonScene;

class CellCompositingPass
{
public:
  // Each returns an empty string, or what went wrong.
  /**
   * With `neighbors` the cells are drawn ray by ray, otherwise one by one in the order of
   * UploadOrder.
   */
  std::string UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
    const TetrahedronNeighbors* neighbors);
  /** Only the values of colour, of opacity or of both; the geometry is that of the last upload. */
  std::string UploadValues(
    vtkOpenGLRenderWindow* window, const CellGeometry& geometry, bool ofColor, bool ofOpacity)
  {
    return this->Buffers.UploadValues(window, geometry, ofColor, ofOpacity);
  }
  std::string UploadTransferFunctions(vtkOpenGLRenderWindow* window,
    const std::vector<TransferFunctionTable>& colorAndOpacity,
    const std::vector<TransferFunctionTable>& opacity, const std::vector<std::int32_t>& tables)
  {
    return this->Buffers.UploadTransferFunctions(window, colorAndOpacity, opacity, tables);
  }
  std::string UploadCameraLight(
    vtkOpenGLRenderWindow* window, const CameraLight& light, double width)
  {
    return this->Buffers.UploadCameraLight(window, light, width);
  }
  std::string UploadContours(vtkOpenGLRenderWindow* window, const CellScene& scene);
  std::string UploadPolygons(vtkOpenGLRenderWindow* window, const PolygonScene& polygons,
    const CellGeometry& geometry, const TetrahedronNeighbors* neighbors)
  {
    return this->Contours.UploadPolygons(window, polygons, geometry, neighbors);
  }
  /** The part of the scene that is visible with its transfer function and view. */
  std::string UploadDrawn(vtkOpenGLRenderWindow* window, const CellScene& scene);
  std::string Draw(
    vtkOpenGLRenderWindow* window, const CellView& view, const CellDrawingOptions& options);
  /** Draws only the part that a depth peeling pass requests, into its targets, ray by ray. */
  std::string DrawPeel(vtkOpenGLRenderWindow* window, const CellView& view,
    const CellDrawingOptions& options, const VolumePeel::Request& request);

  /** A medium that is drawn ray by ray together with others. */
  struct Medium
  {
    CellCompositingPass* Pass;
    const CellView* View;
    const CellDrawingOptions* Options;
  };
  ///@{
  /**
   * The same of several media at once, which may overlap in space; they have been uploaded to be
   * drawn ray by ray.
   */
  std::string DrawMedia(vtkOpenGLRenderWindow* window, const std::vector<Medium>& media);
  std::string DrawMediaPeel(vtkOpenGLRenderWindow* window, const std::vector<Medium>& media,
    const VolumePeel::Request& request);
  ///@}
  /** Whether the window's OpenGL can draw so many at once. */
  static bool CanDrawMedia(const std::vector<Medium>& media);

  /** Composites the drawing of another object over the scene, through the same float image. */
  std::string DrawLayer(vtkOpenGLRenderWindow* window, const FloatLayer::Painter& paint);

  /** False if nothing has been drawn yet, or if the last drawing was a peel. */
  bool CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image);
  int GetNumberOfRayLayers() const { return this->UseRays ? this->Rays.GetNumberOfLayers() : 0; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using Caster = std::function<std::string(const int viewport[4], VolumePeel* peel, int range)>;
  std::string CastPeel(
    vtkOpenGLRenderWindow* window, const VolumePeel::Request& request, const Caster& cast);
  std::string CastRanges(vtkOpenGLRenderWindow* window, const int viewport[4], const Caster& cast);
  std::string CastMedia(vtkOpenGLRenderWindow* window, const std::vector<Medium>& media,
    const int viewport[4], VolumePeel* peel, int range);

  CellBuffers Buffers;
  ContourBuffers Contours;
  ProjectedCells Projected;
  RayCells Rays;
  RayMedia Media;
  bool UseRays = false;
  FloatLayer Layer;
  FloatAccumulation SecondAccumulation; // for the second range of a peel, ray by ray
  VolumePeel Peel;
  bool Peeled = false;
};

} // namespace nephoscope

#endif
