// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkDualDepthPeelingPass ends with the first peel that puts nothing into the back. In front of
 * what is opaque the first peel never does, so that where nothing but opaque things is behind, all
 * surfaces but the front one are lost. A surface's mapper that calls this before it draws makes the
 * pass peel once more: it gives one pixel of the first peel's back the least alpha there is.
 */
#ifndef nephoscope_KeepPeeling_h
#define nephoscope_KeepPeeling_h

#include "OpenGLFunctions.h"
#include "PeelingPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>

namespace nephoscope
{

class KeepPeeling
{
public:
  void BeforeDrawing(vtkOpenGLRenderWindow* window, vtkProp* prop)
  {
    vtkDualDepthPeelingPass* pass = PeelingPass(prop);
    const unsigned int buffers = pass ? pass->GetActiveDrawBuffers() : 0;
    if (buffers == buffersOfPeels && this->IsFirst)
    {
      vtkOpenGLState* state = window->GetState();
      const vtkOpenGLState::ScopedglEnableDisable savedTest(state, GL_SCISSOR_TEST);
      const vtkOpenGLState::ScopedglScissor savedBox(state);
      state->vtkglEnable(GL_SCISSOR_TEST);
      state->vtkglScissor(0, 0, 1, 1);
      float pixel[4] = { 0, 0, 0, 0 };
      ReadFirstPixel(state, pixel); // what others have drawn there stays
      pixel[3] = std::max(pixel[3], 1.0f / 255);
      glClearBufferfv(GL_COLOR, 0, pixel); // fragments that follow are drawn with GL_MAX
    }
    this->IsFirst = buffers == buffersOfFirstStage;
  }

private:
  static void ReadFirstPixel(vtkOpenGLState* state, float pixel[4])
  {
    GLint target = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    state->PushReadFramebufferBinding();
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(target));
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel);
    state->PopReadFramebufferBinding();
  }

  static constexpr unsigned int buffersOfFirstStage = 2, buffersOfPeels = 3;
  bool IsFirst = false;
};

} // namespace nephoscope

#endif
