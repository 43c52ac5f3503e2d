// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Brings the opaque depth to FaceSweep and its picture to OpenGL. */
#ifndef nephoscope_FacePass_h
#define nephoscope_FacePass_h

#include "CellDrawing.h"
#include "FaceMesh.h"
#include "FaceProjection.h"

#include "vtkNew.h"

#include <cstdint>
#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class CellScene;

class FacePass
{
public:
  FacePass();
  ~FacePass();

  /**
   * Draws over the bound framebuffer, whose size is that of `opaqueDepth`. Returns an empty string,
   * or what went wrong.
   */
  std::string Draw(vtkOpenGLRenderWindow* window, const CellScene& scene, const CellView& view,
    const CellDrawingOptions& options, bool sorted, vtkTextureObject* opaqueDepth);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Copy(vtkOpenGLRenderWindow* window, std::vector<float>& rgba, int width, int height);

  FaceMesh Mesh;
  std::int64_t MeshVersion = -1; // of the scene's geometry
  FaceProjection Projection;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkNew<vtkTextureObject> Picture;
};

} // namespace nephoscope

#endif
