// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * As SurfaceLayers, in one drawing and without a limit, for OpenGL with images in shaders (4.2, or
 * the extension): each pixel has a list of the faces behind it.
 */
#ifndef nephoscope_SurfaceLists_h
#define nephoscope_SurfaceLists_h

#include "SurfaceLayers.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <functional>

namespace nephoscope
{

class SurfaceLists
{
public:
  SurfaceLists();
  ~SurfaceLists();
  SurfaceLists(const SurfaceLists&) = delete;
  SurfaceLists& operator=(const SurfaceLists&) = delete;

  /** Whether the current OpenGL can. */
  static bool IsSupported();

  /** Nodes in a row of their image. */
  static constexpr int Columns = 4096;

  /**
   * Calls paint() to draw the surface once, or twice if there were more faces than in earlier
   * pictures. False: this OpenGL cannot.
   */
  bool Draw(const SurfaceLayers::Request& request, const std::function<void()>& paint);

  /**
   * Calls paint(face, part) to change the lists: the shader CloudDepths, over all pixels, for each
   * face of the longest list and each part of the ray behind it. False: OpenGL ended a loop early.
   */
  bool Rewrite(const SurfaceLayers::Request& request, int parts,
    const std::function<void(int face, int part)>& paint);

  /** Two images as the shader SurfaceLists writes them. */
  vtkTextureObject* GetHeads() { return this->Heads; }
  vtkTextureObject* GetNodes() { return this->Nodes; }

  /** For the program that paint() uses. */
  void SetUniforms(vtkShaderProgram* program) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(const SurfaceLayers::Request& request, int rows);
  bool Fill(const SurfaceLayers::Request& request, const std::function<void()>& paint, int& count);
  void SetState(const SurfaceLayers::Request& request);
  void PaintImages(const std::function<void()>& paint);
  int ReadNumber(int row);

  vtkNew<vtkOpenGLFramebufferObject> HeadsFramebuffer, Framebuffer;
  vtkNew<vtkTextureObject> Heads, Nodes;
  int Size[2] = { 0, 0 };
  int Rows = 0;
};

} // namespace nephoscope

#endif
