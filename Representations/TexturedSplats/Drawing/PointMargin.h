// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * While points of several pixels are drawn: a viewport that is larger than the image, because a
 * point is left out when its centre is outside of the viewport.
 */
#ifndef nephoscope_PointMargin_h
#define nephoscope_PointMargin_h

#include "OpenGLFunctions.h"

#include "vtkOpenGLState.h"

namespace nephoscope
{

class PointMargin
{
public:
  PointMargin(vtkOpenGLState* state, int width, int height, int margin)
    : State(state)
    , Size{ width, height }
    , WasEnabled(glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE)
  {
    state->vtkglViewport(-margin, -margin, width + 2 * margin, height + 2 * margin);
    glEnable(GL_PROGRAM_POINT_SIZE);
  }
  ~PointMargin()
  {
    if (!this->WasEnabled)
    {
      glDisable(GL_PROGRAM_POINT_SIZE);
    }
    this->State->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  }
  PointMargin(const PointMargin&) = delete;
  void operator=(const PointMargin&) = delete;

private:
  vtkOpenGLState* State;
  int Size[2];
  bool WasEnabled;
};

} // namespace nephoscope

#endif
