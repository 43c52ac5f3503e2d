// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A volume mapper's side of vtkDualDepthPeelingPass, which takes translucent surfaces and volumes
 * apart by depth.
 *
 * With vtkRenderer::UseDepthPeelingForVolumes the pass asks every volume several times per frame to
 * draw the parts of its rays that lie between two layers of surfaces. It does so by writing into
 * the volume's fragment shader, which must cast rays. Mappers that do not cast rays use this class
 * instead:
 *
 *   FindRanges()   a full-screen program of ours, into which the pass writes, leaves the two
 *                  depth ranges of each pixel in a texture
 *   (the mapper draws what lies in each range into a float image of its own)
 *   Deliver()      a second full-screen program hands the two images to the pass
 *
 * The pass lets the volumes of a scene overwrite each other; Deliver() lays them over each other in
 * the order in which they are drawn, as without peeling.
 */
#ifndef nephoscope_VolumePeel_h
#define nephoscope_VolumePeel_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkNew.h"

class vtkAbstractMapper;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkProp;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT VolumePeel
{
public:
  /** Whom the pass asks. */
  struct Request
  {
    vtkAbstractMapper* Mapper = nullptr;
    vtkProp* Volume = nullptr;
  };

  VolumePeel();
  ~VolumePeel();
  VolumePeel(const VolumePeel&) = delete;
  VolumePeel& operator=(const VolumePeel&) = delete;

  /** Whether a peeling pass, or VolumeSlices, requests that this volume draws. */
  static bool IsRequested(vtkProp* volume);

  enum DepthTest
  {
    Nearest,
    Farthest ///< for VolumeSlices only
  };

  /** Finds the ranges of this peel. False when there is nothing to draw in any pixel. */
  bool FindRanges(vtkOpenGLRenderWindow* window, const Request& request, const int viewport[4],
    DepthTest test = Nearest);
  /**
   * RGBA32F, one texel per pixel of the viewport: near and far depth of two ranges, empty where
   * near >= far. For more than two of VolumeSlices, what shaders/Slices.glsl needs.
   */
  vtkTextureObject* GetRanges() const { return this->Ranges; }
  /**
   * Depth buffer that lets only those fragments pass GL_GREATER which lie behind the near end of a
   * range, or with Farthest those pass GL_LESS which lie in front of a far end.
   */
  vtkTextureObject* GetDepth() const { return this->Depth; }

  /**
   * Draws the light of the two ranges (premultiplied, as large as the viewport) into the bound
   * targets of the pass.
   */
  void Deliver(vtkOpenGLRenderWindow* window, const Request& request, const int viewport[4],
    vtkTextureObject* firstLight, vtkTextureObject* secondLight);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);
  vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const Request& request,
    const int viewport[4], const char* shader);
  bool DrawRanges(
    vtkOpenGLRenderWindow* window, const Request& request, const int viewport[4], DepthTest test);
  void CopyTargets(vtkOpenGLRenderWindow* window, unsigned int count);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Ranges;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkTextureObject> Targets[2];
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; // without attributes
  int Size[2] = { 0, 0 };
};

} // namespace nephoscope

#endif
