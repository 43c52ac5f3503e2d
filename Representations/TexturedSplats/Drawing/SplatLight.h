// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Light of splats that depends on the direction of view, for shaders/SplatLight.glsl. */
#ifndef nephoscope_SplatLight_h
#define nephoscope_SplatLight_h

#include "BufferTexture.h"
#include "CameraLight.h"
#include "TransferFunctionTable.h"

#include <array>
#include <string>

class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace nephoscope
{

struct SplatClasses;
struct SplatSamples;
class SplatTree;

/** Where it comes from. `Width`: of the range by which scalars are normalised. */
struct SplatLightSource
{
  CameraLight Light;
  double Width = 1;
  TransferFunctionTable Colors;
};

/** On the graphics card: 32 bytes for each splat and node. Nothing where the light is not used. */
class SplatLight
{
public:
  /** Returns an empty string, or what went wrong. */
  std::string Upload(vtkOpenGLRenderWindow* window, const SplatLightSource& source,
    const SplatSamples& samples, const SplatClasses& classes, const SplatTree& tree);
  bool IsUsed() const { return this->NumberOfPhases > 0; }

  void Activate(vtkShaderProgram* program, vtkMatrix4x4* modelToView);
  void Deactivate();
  void Release(vtkWindow* window);

private:
  BufferTexture Parts, Phases, Colors;
  std::array<float, 3> TowardsSun = { { 0, 0, 1 } };
  std::array<float, 2> Range = { { 0, 1 } };
  int NumberOfPhases = 0;
};

} // namespace nephoscope

#endif
