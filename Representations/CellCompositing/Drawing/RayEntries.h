// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the rays of pixels enter the mesh: the boundary triangles through which they do, the
 * nearest per pixel behind the last ones.
 *
 * After some layers, the triangles are drawn in slices of depth (FaceSlices.h).
 */
#ifndef nephoscope_RayEntries_h
#define nephoscope_RayEntries_h

#include "BoundaryFaces.h"
#include "CoveredPixels.h"
#include "FaceSlices.h"
#include "VertexNumbers.h"

#include "vtkNew.h"

#include <array>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
struct CellDrawing;
struct SceneView;

class RayEntries
{
public:
  /**
   * The number of the entries that hold the last ones of the unsliced layers, while slices are
   * drawn.
   */
  static constexpr int Passed = 1;

  RayEntries();
  ~RayEntries();

  /** The first `count` of the faces. */
  void SetFaces(
    const CellGeometry& geometry, const std::vector<BoundaryFace>& faces, std::size_t count);

  const PointBounds& GetBounds() const { return this->Bounds; }
  /** Depths between which the data lie. */
  std::array<float, 2> DepthRange(const SceneView& view) const;

  void Allocate(const CellDrawing& drawing);
  /** Only pixels that have this number in a texture; all without one. Before ReadyProgram. */
  void SetOwners(vtkTextureObject* owners, int owner);
  bool ReadyProgram(const CellDrawing& drawing);

  // Entries have the numbers 0 to 2: this time, last time, and before the slices.
  /** There are none of this number. */
  void Clear(const CellDrawing& drawing, int number);
  /** Those behind the last ones, of all faces or of a slice; false when no ray enters any more. */
  bool Draw(const CellDrawing& drawing, int into, int lastNumber, const FaceSlices::Slice* slice);
  void SliceFaces(const CellDrawing& drawing);
  /** After SliceFaces: front to back. */
  const std::vector<FaceSlices::Slice>& GetSlices() const { return this->Slices.GetSlices(); }

  /** Boundary triangle and depth where each pixel's ray enters. */
  vtkTextureObject* GetTexture(int number) { return this->Entries[number]; }
  /** The depths of the entries that were drawn last. */
  vtkTextureObject* GetDepth() { return this->Depth; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void DrawFaces(const FaceSlices::Slice* slice);

  VertexNumbers Vertices;
  std::size_t NumberOfFaces = 0;
  PointBounds Bounds; // of the faces
  double Radius = 0;  // of the points about their centre

  FaceSlices Slices;
  vtkNew<vtkOpenGLBufferObject> SliceVertices;

  vtkNew<vtkTextureObject> Entries[3];
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  int Size[2] = { 0, 0 };
  vtkTextureObject* Owners = nullptr; // not owned
  int Owner = 0;

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
};

} // namespace nephoscope

#endif
