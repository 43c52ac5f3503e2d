// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The one window whose graphics resources a mapper holds. */
#ifndef ResourceWindow_h
#define ResourceWindow_h

#include "vtkOpenGLRenderWindow.h"

namespace nephoscope
{

class ResourceWindow
{
public:
  vtkOpenGLRenderWindow* Get() const { return this->Window; }

  /** Before resources are made in a window: the mapper releases those it has in another one. */
  template <typename Mapper>
  void Enter(vtkOpenGLRenderWindow* window, Mapper* mapper)
  {
    if (this->Window && this->Window != window)
    {
      vtkOpenGLRenderWindow* other = this->Window;
      other->PushContext();
      mapper->ReleaseGraphicsResources(other);
      other->PopContext();
      window->MakeCurrent();
    }
    this->Window = window;
  }

  /** True if resources are to be released: another window's release is none of ours. */
  bool Leave(vtkWindow* window)
  {
    const bool ours = window && window == this->Window;
    this->Window = ours ? nullptr : this->Window;
    return ours;
  }

private:
  vtkOpenGLRenderWindow* Window = nullptr;
};

} // namespace nephoscope

#endif
