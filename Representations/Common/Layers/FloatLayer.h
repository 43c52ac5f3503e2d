// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Drawing between the opaque geometry and the picture: translucent objects are blended in a float
 * image, which is then composited over the scene. Depth is neither tested nor written: shaders look
 * at the opaque depth themselves.
 */
#ifndef nephoscope_FloatLayer_h
#define nephoscope_FloatLayer_h

#include "FloatAccumulation.h"
#include "OpaqueDepth.h"
#include "VolumePeel.h"
#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <array>
#include <functional>
#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkWindow;

namespace nephoscope
{

/** x, y, width, height in the viewport. */
using PixelRegion = std::array<int, 4>;

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT FloatLayer
{
public:
  /**
   * Draws into the bound image of the viewport's size; `opaqueDepth` is as large. Returns what went
   * wrong.
   */
  using Painter = std::function<std::string(const int viewport[4], OpaqueDepth& opaqueDepth)>;

  /**
   * Returns an empty string, or what went wrong. All state of OpenGL is restored. Where a region of
   * the viewport is given, the painter is cut off there, and the depth is copied and the image laid
   * over the scene only there. With a sample distance of more than 1 the painter's viewport has
   * that many times fewer pixels along each axis, between which the image is then interpolated.
   */
  std::string Draw(vtkOpenGLRenderWindow* window, const Painter& paint,
    const PixelRegion* region = nullptr, double sampleDistance = 1);

  /**
   * Answers a depth peeling pass: both ranges of `peel` are drawn at once, gl_FragData[0] and [1],
   * over a depth buffer in which fragments pass that may lie in a range (VolumePeel::GetDepth),
   * with the function that belongs to `test`.
   */
  std::string DrawPeel(vtkOpenGLRenderWindow* window, VolumePeel& peel,
    const VolumePeel::Request& request,
    const std::function<std::string(const int viewport[4])>& paint,
    VolumePeel::DepthTest test = VolumePeel::Nearest);

  /**
   * For a painter: fragments whose depth is behind opaque geometry fail from now on. Shaders may go
   * on reading the opaque depth.
   */
  void HideBehindOpaque(vtkOpenGLRenderWindow* window);

  ///@{
  /** For code that draws into the image in another way. */
  OpaqueDepth& GetDepth() { return this->Depth; }
  FloatAccumulation& GetAccumulation() { return this->Accumulation; }
  ///@}

  bool CopyTo(vtkOpenGLRenderWindow* window, vtkImageData* image)
  {
    return this->Accumulation.CopyTo(window, image);
  }
  void ReleaseGraphicsResources(vtkWindow* window);

  /** Premultiplied colours are added in the order in which they come, without a depth test. */
  static void SetBlending(vtkOpenGLState* state);
  /**
   * Forgets errors that others have left in OpenGL, before drawing: VTK's peeling of multisampled
   * windows leaves some.
   */
  static void ForgetErrors();
  /** Empty, or the error that OpenGL has. */
  static std::string CheckOpenGL(const char* where);

private:
  OpaqueDepth Depth;
  FloatAccumulation Accumulation;
};

} // namespace nephoscope

#endif
