// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws tetrahedra one after another, in a given order, each over the pixels that it covers: its
 * back faces with the exact integral of each pixel's ray, or the triangles of TrianglePass.h.
 * Neither surfaces between the cells nor parts between peeled surfaces.
 */
#ifndef nephoscope_ProjectedCells_h
#define nephoscope_ProjectedCells_h

#include "BufferTexture.h"
#include "VertexNumbers.h"

#include "vtkNew.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
struct CellDrawing;

class ProjectedCells
{
public:
  ProjectedCells();
  ~ProjectedCells();

  // Each returns an empty string, or what went wrong.
  std::string UploadGeometry(vtkOpenGLRenderWindow* window, const CellGeometry& geometry);
  void UploadOrder(const std::vector<std::int32_t>& order);
  std::string Draw(const CellDrawing& drawing);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  BufferTexture Tetrahedra;
  VertexNumbers Order;
  BufferTexture AlphaTable; // of the triangles
  std::size_t OrderSize = 0;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
};

} // namespace nephoscope

#endif
