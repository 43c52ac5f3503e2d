// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The depth at the centres of the pixels of a multisampled framebuffer: the mean of their samples.
 */
#ifndef nephoscope_MeanDepth_h
#define nephoscope_MeanDepth_h

#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;

namespace nephoscope
{

/** The samples of the depth of a framebuffer, if they are a texture. */
struct DepthSamples
{
  unsigned int Texture = 0; ///< 0: there is none
  int Count = 0;

  /** Those of the bound draw framebuffer. */
  static DepthSamples OfDrawFramebuffer();
};

class MeanDepth
{
public:
  MeanDepth();
  ~MeanDepth();
  MeanDepth(const MeanDepth&) = delete;
  MeanDepth& operator=(const MeanDepth&) = delete;

  /**
   * Writes the mean depth to a region (x, y, width, height) of the bound framebuffer, whose lower
   * left pixel is at `corner` of the samples. False: nothing was written, since the shader did not
   * compile.
   */
  bool Draw(vtkOpenGLRenderWindow* window, const DepthSamples& samples, const int corner[2],
    const int region[4]);
  void ReleaseGraphicsResources();

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

} // namespace nephoscope

#endif
