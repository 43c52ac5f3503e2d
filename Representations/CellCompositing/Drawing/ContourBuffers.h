// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Contour surfaces inside the volume, on the GPU. */
#ifndef ContourBuffers_h
#define ContourBuffers_h

#include "BufferTexture.h"

#include <array>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class ContourScene;
struct CellDrawing;

class ContourBuffers
{
public:
  /** Returns an empty string, or what went wrong. */
  std::string Upload(vtkOpenGLRenderWindow* window, const ContourScene& contours);

  bool IsUsed() const { return this->NumberOfContours > 0; }
  std::string ShaderConstants() const;
  /** Binds the textures; tells the program their units, and how surfaces are lit. */
  void Activate(const CellDrawing& drawing, vtkShaderProgram* program);
  void Deactivate();
  void Release(vtkWindow* window);

private:
  enum Name
  {
    Scalars,
    Contours,
    Gradients,
    NumberOfBuffers
  };
  void SetLights(const CellDrawing& drawing, vtkShaderProgram* program) const;

  std::array<BufferTexture, NumberOfBuffers> Buffers;
  int NumberOfContours = 0;
  bool OfColor = true;
  bool Smooth = false;
};

} // namespace nephoscope

#endif
