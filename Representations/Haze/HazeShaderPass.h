// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes haze into the fragment shaders of vtkOpenGLPolyDataMapper and its subclasses, as passes of
 * VTK write theirs: it is named in the property keys of the props while the renderer draws. Every
 * fragment is hazed where it is, opaque or translucent, and before layers are peeled, blended or
 * composited between ranks.
 */
#ifndef nephoscope_HazeShaderPass_h
#define nephoscope_HazeShaderPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"

#include <string>

class vtkRenderer;

namespace nephoscope
{

class HazeShaderPass : public vtkOpenGLRenderPass
{
public:
  static HazeShaderPass* New();
  vtkTypeMacro(HazeShaderPass, vtkOpenGLRenderPass);

  /** Draws nothing by itself. */
  void Render(const vtkRenderState*) override {}

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray = nullptr) override;
  /** When the shaders changed: another kind of haze has other functions. */
  vtkMTimeType GetShaderStageMTime() override { return this->FunctionsTime.GetMTime(); }

  /** The props that the renderer will draw; the renderer is not kept alive. */
  void Enter(vtkRenderer* renderer);
  void Leave(vtkRenderer* renderer);

protected:
  HazeShaderPass() = default;
  ~HazeShaderPass() override = default;

private:
  HazeShaderPass(const HazeShaderPass&) = delete;
  void operator=(const HazeShaderPass&) = delete;

  vtkRenderer* Renderer = nullptr; // while it draws
  std::string Functions;           // of its haze
  vtkTimeStamp FunctionsTime;
};

} // namespace nephoscope

#endif
