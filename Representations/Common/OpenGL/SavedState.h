// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** A guard for the OpenGL state that drawing changes. */
#ifndef nephoscope_SavedState_h
#define nephoscope_SavedState_h

#include "OpenGLFunctions.h"

#include "vtkOpenGLState.h"

namespace nephoscope
{

/**
 * Restores the state when its scope ends; VTK itself has no guard for the blend equation, which
 * peeling sets.
 */
class SavedState
{
public:
  explicit SavedState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , ScissorBox(state)
    , Scissor(state, GL_SCISSOR_TEST)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , Culling(state, GL_CULL_FACE)
    , DepthMask(state)
    , DepthFunction(state)
    , BlendFunction(state)
  {
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->BlendEquation[0]);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->BlendEquation[1]);
  }
  ~SavedState()
  {
    this->State->vtkglBlendEquationSeparate(static_cast<unsigned int>(this->BlendEquation[0]),
      static_cast<unsigned int>(this->BlendEquation[1]));
  }
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor ScissorBox;
  vtkOpenGLState::ScopedglEnableDisable Scissor, Blend, DepthTest, Culling;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunction;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction;
  GLint BlendEquation[2];
};

} // namespace nephoscope

#endif
