// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The depths at which the rays of all pixels enter and leave a surface, by drawing it several
 * times: each time finds the nearest and the farthest front face that are left, and as many back
 * faces. As far as nothing opaque hides them.
 */
#ifndef nephoscope_SurfaceLayers_h
#define nephoscope_SurfaceLayers_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <functional>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

class SurfaceLayers
{
public:
  /** One drawing of the surface. */
  struct Drawing
  {
    vtkTextureObject* Previous = nullptr; ///< depths of the drawing before; null for the first
    vtkTextureObject* Found =
      nullptr; ///< not null: the densities at these depths are wanted, not further depths
  };
  using Painter = std::function<void(const Drawing&)>;

  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr;
    int Size[2] = { 0, 0 };
    int Limit = 1; ///< of drawings
    bool WithDensities = false;
    unsigned int OnlyFaces = 0; ///< SurfaceLists: GL_BACK or GL_FRONT; 0: both are wanted
    vtkTextureObject* OpaqueDepth = nullptr;
  };

  SurfaceLayers();
  ~SurfaceLayers();
  SurfaceLayers(const SurfaceLayers&) = delete;
  SurfaceLayers& operator=(const SurfaceLayers&) = delete;

  /**
   * Draws until nothing is left or the limit is reached. False: this OpenGL cannot. All state is
   * restored.
   */
  bool Draw(const Request& request, const Painter& paint);

  int GetNumberOfDrawings() const { return this->NumberOfDrawings; }
  /** Whether more faces are there than the limit allowed to find. */
  bool HasMore() const { return this->More; }
  /**
   * RGBA32F: minus the depth of the nearest front and back face, depth of the farthest front and
   * back face; "noLayer" where there is none.
   */
  vtkTextureObject* GetDepths(int drawing)
  {
    return this->Depths[static_cast<std::size_t>(drawing)];
  }
  /** RGBA32F: density at these back faces in the second and fourth component. */
  vtkTextureObject* GetDensities(int drawing)
  {
    return this->Densities[static_cast<std::size_t>(drawing)];
  }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using Images = std::vector<vtkSmartPointer<vtkTextureObject>>;
  vtkTextureObject* Image(const Request& request, Images& images, int drawing);
  void SetState(const Request& request);
  bool DrawAll(const Request& request, const Painter& paint);
  bool DrawDepths(const Request& request, const Painter& paint, int drawing);
  void DrawDensities(const Request& request, const Painter& paint, int drawing);
  bool AnyLeft(const Request& request, const Painter& paint);
  bool Attach(vtkTextureObject* image);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  Images Depths, Densities;
  int Size[2] = { 0, 0 };
  int NumberOfDrawings = 0;
  bool More = false;
};

} // namespace nephoscope

#endif
