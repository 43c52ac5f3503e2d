// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws an evenly spaced grid ray by ray: the trilinear field of its cells or their tetrahedra.
 * Where a ray is, is a matter of arithmetic.
 *
 * A ray skips invisible cells, by the distance to the next visible one (ClearDistances.h).
 * Polygons, layers, light that depends on the direction of view and, in tetrahedra, contour
 * surfaces and an opacity array are left to RayCells.
 */
#ifndef nephoscope_RayVoxels_h
#define nephoscope_RayVoxels_h

#include "BoundaryFaces.h"
#include "BufferTexture.h"
#include "CellGeometry.h"

#include "vtkNew.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

struct CellDrawing;
struct SceneView;

class RayVoxels
{
public:
  // Each returns an empty string, or what went wrong.
  std::string Upload(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
    const CellBox& box, const std::vector<std::uint8_t>& clearDistances);
  std::string UploadScalars(vtkOpenGLRenderWindow* window, const CellGeometry& geometry);
  std::string UploadContoured(
    vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const std::vector<float>& scalars);
  /**
   * Draws into the bound framebuffer, which holds a transparent image. If
   * `owners` is given, draws only the pixels that belong to `owner`.
   */
  std::string Draw(const CellDrawing& drawing, vtkTextureObject* owners = nullptr, int owner = 0);

  bool CanDraw(const CellDrawing& drawing) const;

  ///@{
  /** The walk as one of several in a shader (ShaderInstance.h), and its uniforms. */
  std::string MediumShader(const CellDrawing& drawing, int instance) const;
  void SetGrid(vtkShaderProgram* program, int instance = -1);
  ///@}
  BufferTexture& GetClearDistances() { return this->ClearDistances; }
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetRays(vtkShaderProgram* program, const SceneView& view);

  ChessboardGrid Grid;
  CellBox Box;
  GridLattice Lattice;
  BufferTexture Squares, OpacitySquares, ContourSquares, ClearDistances;
  bool HasOpacity = false; ///< where an array gives it, it is on points or cells as the colour is
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
};

} // namespace nephoscope

#endif
