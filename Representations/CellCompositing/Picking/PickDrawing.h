// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Draws numbers as colours, pixel by pixel, for the passes of vtkHardwareSelector. */
#ifndef nephoscope_PickDrawing_h
#define nephoscope_PickDrawing_h

#include "vtkNew.h"

#include <array>
#include <memory>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class PickDrawing
{
public:
  PickDrawing();
  ~PickDrawing();

  /**
   * `pixels`: red, green, blue and depth of `size` squares, `width` pixels wide, row by row from
   * the pixel `first` of the window; where the depth is negative nothing is drawn.
   */
  void Draw(vtkOpenGLRenderWindow* window, const std::array<int, 2>& first, int width,
    const std::array<int, 2>& size, const std::vector<float>& pixels);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Numbers;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

} // namespace nephoscope

#endif
