// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The haze of a renderer as its shaders take it. For mappers with programs of their own; those of
 * vtkOpenGLPolyDataMapper are hazed unasked.
 */
#ifndef nephoscope_HazeView_h
#define nephoscope_HazeView_h

#include "vtkNephoscopeRepresentationsHazeModule.h" // for export macro

#include <string>

class vtkHaze;
class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;

namespace nephoscope
{

class HazeLink;
struct HazePlacement;

class VTKNEPHOSCOPEREPRESENTATIONSHAZE_EXPORT HazeView
{
public:
  /** No haze. */
  HazeView() = default;
  /** The view of the renderer as it draws now; its haze may be none, or off. */
  explicit HazeView(vtkRenderer* renderer);

  bool IsOn() const { return this->On; }

  /**
   * shaders/Haze.glsl for a program that has SetUniforms called: within it NEPHOSCOPE_HAZE is
   * defined. Whether a sun lights the haze is a constant. Empty where there is no haze.
   */
  std::string Definition() const;

  void SetUniforms(vtkShaderProgram* program) const;

private:
  void SetPlace(vtkHaze& haze, const HazePlacement& placement, vtkMatrix4x4* worldToView,
    const double start[3]);
  void SetSun(const HazeLink& link, vtkMatrix4x4* worldToView);
  void SetDevice(vtkMatrix4x4* viewToDevice);

  bool On = false;
  bool OnGlobe = true;
  bool Parallel = false;
  float Unit = 1;
  float Extinction = 0;
  float Tint[3] = { 1, 1, 1 };
  float Sun[3] = { 0, 0, 0 };
  float Asymmetry = 0;
  int ShadowUnit = -1; ///< texture unit; -1: no clouds shade the haze
  float ToShadows[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }; // columns
  float Eye[3] = { 0, 0, 0 };
  float Frame[3] = { 0, 0, 1 };
  float Height[2] = { 1, 0 };
  float FromDevice[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }; // columns
  float DeviceOrigin[3] = { 0, 0, 0 };
};

} // namespace nephoscope

#endif
