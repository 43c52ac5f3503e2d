// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws cells into a float image and lays it over the scene.
 *
 * Everything the shaders read is in buffer textures: geometry and transfer functions are uploaded when they change, the
 * drawing order of projected cells whenever the view does.
 */
#ifndef CellCompositingPass_h
#define CellCompositingPass_h

#include "CellBuffers.h"
#include "CellDrawing.h"
#include "FloatAccumulation.h"
#include "OpaqueDepth.h"
#include "ProjectedCells.h"
#include "RayCells.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
class CellScene;
struct CellPieces;
struct TetrahedronNeighbors;

class CellCompositingPass
{
public:
  // Each returns an empty string, or what went wrong.
  /** With `neighbors` the cells are drawn ray by ray, else one by one in the order that UploadOrder tells. */
  std::string UploadGeometry(
    vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const CellPieces& pieces,
    const TetrahedronNeighbors* neighbors);
  std::string UploadTransferFunctions(vtkOpenGLRenderWindow* window, const TransferFunctionTable& colorAndOpacity,
    const TransferFunctionTable& opacity)
  {
    return this->Buffers.UploadTransferFunctions(window, colorAndOpacity, opacity);
  }
  /** What the scene's transfer function and view let be seen. */
  std::string UploadDrawn(vtkOpenGLRenderWindow* window, const CellScene& scene);
  std::string Draw(vtkOpenGLRenderWindow* window, const CellView& view, const CellDrawingOptions& options);

  bool CopyFloatImage(vtkOpenGLRenderWindow* window, vtkImageData* image);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  CellBuffers Buffers;
  ProjectedCells Projected;
  RayCells Rays;
  bool UseRays = false;
  OpaqueDepth Depth;
  FloatAccumulation Accumulation;
};

} // namespace nephoscope

#endif
