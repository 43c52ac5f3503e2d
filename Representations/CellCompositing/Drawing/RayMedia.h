// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws several media ray by ray as one: where they overlap in space, their extinctions add.
 *
 * Each pixel's ray walks through all meshes in step. It enters every mesh through the nearest
 * boundary face, as RayCells has it, and a round ends where the ray enters one of the meshes again:
 * there the next face of that mesh is taken, while the walks through the others begin anew at their
 * last faces and come to the place without integrating. A round therefore costs little where meshes
 * are convex or their gaps few: there is one round more than re-entries.
 *
 * Where a ray enters a single mesh, it is walked through as that of a single volume, which is
 * faster.
 */
#ifndef nephoscope_RayMedia_h
#define nephoscope_RayMedia_h

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace nephoscope
{

class RayCells;
struct CellDrawing;

class RayMedia
{
public:
  struct Medium
  {
    RayCells* Rays;
    const CellDrawing* Drawing; ///< all of one window and viewport
    int OtherTextures = 0;      ///< that its buffers have, at most
  };
  static constexpr int Most = 4; ///< as many as a texel has components
  static constexpr const char* NotCompiled = "the shaders of several media did not compile";

  RayMedia();
  ~RayMedia();

  /** Whether the shaders of the window's OpenGL may read as many textures as the media need. */
  static bool HasEnoughTextures(const std::vector<Medium>& media);

  /**
   * Draws into the bound framebuffer, which holds a transparent image. Returns an empty string, or
   * what went wrong.
   */
  std::string Draw(const std::vector<Medium>& media);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string DrawFrom(const std::vector<Medium>& media);
  void Allocate(const CellDrawing& drawing);
  bool ReadyPrograms(const std::vector<Medium>& media);
  bool DrawLonePixels(const std::vector<Medium>& media);
  void FindOwners(const std::vector<Medium>& media);
  void Begin(const std::vector<Medium>& media);
  bool FindNextEntries(const std::vector<Medium>& media);
  void DrawPlan(const std::vector<Medium>& media, bool first);
  void DrawRound(const std::vector<Medium>& media);

  // Numbers of RayCells' entries: those that count in this round, the next ones, and those of the
  // next round.
  int Last = 0, Next = 1, Then = 2;
  vtkNew<vtkTextureObject> Plans[2]; // of this round and of the one before
  int Plan = 0;
  vtkNew<vtkTextureObject> Faces;
  vtkNew<vtkTextureObject> Owners; // the medium that a ray enters, if it is a single one
  vtkNew<vtkOpenGLFramebufferObject> PlanFramebuffer, OwnersFramebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* PlanProgram = nullptr; // owned, as the next, by the window's shader cache
  vtkShaderProgram* OwnersProgram = nullptr;
  vtkShaderProgram* Program = nullptr;
  int Size[2] = { 0, 0 };
};

} // namespace nephoscope

#endif
