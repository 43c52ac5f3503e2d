// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkDualDepthPeelingPass ends with the first peel that puts nothing into the back. In front of what is opaque the first peel never
 * does, so that where nothing but opaque things is behind, all surfaces but the front one are lost. A surface's mapper that calls this
 * before it draws makes the pass peel once more: it gives one pixel of the first peel's back the least alpha there is.
 */
#ifndef KeepPeeling_h
#define KeepPeeling_h

#include "OpenGLFunctions.h"
#include "PeelingPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace nephoscope
{

class KeepPeeling
{
public:
  void BeforeDrawing(vtkOpenGLRenderWindow* window, vtkProp* prop)
  {
    vtkDualDepthPeelingPass* pass = peelingPass(prop);
    const unsigned int buffers = pass ? pass->GetActiveDrawBuffers() : 0;
    if (buffers == buffersOfPeels && this->IsFirst)
    {
      vtkOpenGLState* state = window->GetState();
      const vtkOpenGLState::ScopedglEnableDisable savedTest(state, GL_SCISSOR_TEST);
      const vtkOpenGLState::ScopedglScissor savedBox(state);
      state->vtkglEnable(GL_SCISSOR_TEST);
      state->vtkglScissor(0, 0, 1, 1);
      const float least[4] = { 0, 0, 0, 1.0f / 255 };
      glClearBufferfv(GL_COLOR, 0, least); // fragments that follow are drawn with GL_MAX
    }
    this->IsFirst = buffers == buffersOfFirstStage;
  }

private:
  static constexpr unsigned int buffersOfFirstStage = 2, buffersOfPeels = 3;
  bool IsFirst = false;
};

} // namespace nephoscope

#endif
