// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws cells ray by ray: each pixel walks through the mesh from tetrahedron to tetrahedron, front
 * to back.
 *
 * The order of the tetrahedra is then exact by construction, whatever the mesh: cycles, holes,
 * separate parts. First the boundary triangles through which rays enter the mesh are drawn, the
 * nearest per pixel kept; then every pixel walks from there until its ray leaves the mesh. Where
 * rays enter again (holes, other parts), the next nearest triangles are drawn, and so on until none
 * is left: as depth peeling goes through layers, but a layer is a whole stretch of mesh. The cost
 * of a layer is proportional to the pixels that have it, because a depth test ends the others.
 * Triangles behind opaque objects are never drawn.
 */
#ifndef nephoscope_RayCells_h
#define nephoscope_RayCells_h

#include "BoundaryFaces.h"
#include "BufferTexture.h"
#include "ChessboardGrid.h"
#include "CoveredPixels.h"
#include "RayEntries.h"
#include "RayShaders.h"
#include "RayVoxels.h"

#include "vtkNew.h"

#include <array>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
struct CellDrawing;
struct EyeTetrahedron;
struct TetrahedronNeighbors;

class RayCells
{
public:
  RayCells();
  ~RayCells();

  // Each returns an empty string, or what went wrong.
  /** A structured grid needs no neighbours. */
  std::string UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
    const TetrahedronNeighbors& neighbors);
  /**
   * Where rays enter, the box of a grid's visible cells, and the range of scalars in which nothing
   * is visible.
   */
  std::string UploadBoundary(vtkOpenGLRenderWindow* window, const std::vector<BoundaryFace>& faces,
    const CellGeometry& geometry, const CellBox& box, const std::array<float, 2>& clearRange);
  /** Which cells of a grid, and of hexahedra crossed whole, can be seen. */
  std::string UploadVoxels(vtkOpenGLRenderWindow* window, const CellGeometry& geometry,
    const CellBox& box, const std::vector<std::uint8_t>& clearDistances)
  {
    return this->Voxels.Upload(window, geometry, box, clearDistances);
  }
  /** The array of points whose contours are drawn; empty if it is the coloured one. */
  std::string UploadContoured(
    vtkOpenGLRenderWindow* window, const CellGeometry& geometry, const std::vector<float>& scalars)
  {
    return this->Voxels.UploadContoured(window, geometry, scalars);
  }
  /** Pixels that may be drawn: those of the boundary. */
  PixelRegion FindRegion(
    const SceneView& view, const EyeTetrahedron& eye, const int viewport[4]) const;
  /** Draws into the bound framebuffer, which holds a transparent image. */
  std::string Draw(const CellDrawing& drawing);

  /**
   * Passes over the picture that the last drawing took: as often as one of the rays entered the
   * mesh, at least.
   */
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /** Greatest number of textures that one walk reads for itself. */
  int CountTextures() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  friend class RayMedia; // walks through the meshes of several in step

  std::string DrawFrom(const CellDrawing& drawing);
  std::string OwnConstants() const;
  bool DrawsHexahedra(const CellDrawing& drawing) const;
  TetrahedronTopology GetTopology() const;
  bool ReadySegmentProgram(const CellDrawing& drawing);
  /** The walk as one of several in a shader (ShaderInstance.h). */
  std::string MediumShader(const CellDrawing& drawing, int instance) const;
  void SetWalk(const CellDrawing& drawing, vtkShaderProgram* program, int instance);
  /** Draws only the pixels of this owner (RayOwners.frag.glsl). */
  std::string DrawOwned(const CellDrawing& drawing, vtkTextureObject* owners, int owner);
  bool StartsAtEye(const EyeTetrahedron& eye) const;
  void DrawLayers(const CellDrawing& drawing);
  /** From the entries of that number, or from the eye. */
  void DrawSegments(const CellDrawing& drawing, int from, const EyeTetrahedron& eye);
  void SetEye(const EyeTetrahedron& eye, vtkShaderProgram* program, int instance = -1);
  void SetTopology(vtkShaderProgram* program, int instance = -1);
  void DeactivateTopology();
  void SetRays(const CellDrawing& drawing, vtkShaderProgram* program, int instance = -1);

  RayVoxels Voxels; // draws instead where it can
  BufferTexture Neighbors, Hexahedra, BoundaryFaces, HiddenCells;
  ChessboardGrid Grid; // empty: another mesh
  CellBox Box;
  std::array<float, 2> ClearRange = { { 1, 0 } };
  std::size_t NumberOfJumps = 0; // boundary faces where rays go on, after those where they enter
  bool HasHiddenCells = false;
  bool HasHexahedra = false;
  bool DividesHexahedra = false;
  bool HasOtherPoints = false; // where divided hexahedra meet, since values jump there
  RayEntries Entries;
  int NumberOfLayers = 0;

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* SegmentProgram = nullptr; // owned by the window's shader cache
};

} // namespace nephoscope

#endif
