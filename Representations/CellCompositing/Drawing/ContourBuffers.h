// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Surfaces inside the volume, on the GPU: contours, and polygons in faces of cells. */
#ifndef nephoscope_ContourBuffers_h
#define nephoscope_ContourBuffers_h

#include "BufferTexture.h"

#include <array>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class CellGeometry;
class ContourScene;
class PolygonScene;
struct TetrahedronNeighbors;
struct CellDrawing;

class ContourBuffers
{
public:
  /** Returns an empty string, or what went wrong. */
  std::string Upload(vtkOpenGLRenderWindow* window, const ContourScene& contours);
  /** None without `neighbors`, which rays have. */
  std::string UploadPolygons(vtkOpenGLRenderWindow* window, const PolygonScene& polygons,
    const CellGeometry& geometry, const TetrahedronNeighbors* neighbors);

  bool IsUsed() const { return this->NumberOfContours > 0; }
  bool HasPolygons() const { return this->UsePolygons; }
  bool HasScalars() const { return this->IsUsed() && !this->OfColor; }
  std::string ShaderConstants() const;
  /** Binds the textures, and sets their units and the lighting of surfaces in the program. */
  void Activate(const CellDrawing& drawing, vtkShaderProgram* program);
  void Deactivate();
  void Release(vtkWindow* window);

private:
  enum Name
  {
    Scalars,
    Contours,
    Gradients,
    OfTetrahedra,
    Polygons,
    NumberOfBuffers
  };
  void SetLights(const CellDrawing& drawing, vtkShaderProgram* program) const;

  std::array<BufferTexture, NumberOfBuffers> Buffers;
  int NumberOfContours = 0;
  bool OfColor = true;
  bool Smooth = false;
  bool UsePolygons = false;
};

} // namespace nephoscope

#endif
