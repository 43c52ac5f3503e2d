// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The one window that graphics resources are in. Names of OpenGL objects mean something else in
 * every other context, so all that has such objects keeps one of these, and releases them when it
 * says so: always in the context of that window.
 *
 *     Enter(window)    before objects are made; those in another window are released first
 *     Leave(window)    from ReleaseGraphicsResources, which props and renderers call with
 *                      whatever window is theirs
 *     by itself        when the window closes, whether or not it knows the mapper, and when the
 *                      owner of this object goes
 *
 * It is declared after all that it releases, so that it goes first.
 */
#ifndef nephoscope_ResourceWindow_h
#define nephoscope_ResourceWindow_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <functional>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT ResourceWindow
{
public:
  using Releaser = std::function<void(vtkWindow*)>;

  /** `release` is called with the window, in its context; at most once after each Enter. */
  explicit ResourceWindow(Releaser release);
  ~ResourceWindow();
  ResourceWindow(const ResourceWindow&) = delete;
  ResourceWindow& operator=(const ResourceWindow&) = delete;

  /** The window that has the resources, or null. */
  vtkOpenGLRenderWindow* Get() const;

  void Enter(vtkOpenGLRenderWindow* window);
  /** Another window's release is none of ours. */
  void Leave(vtkWindow* window);

private:
  class Registered;
  vtkSmartPointer<Registered> Resources;
};

} // namespace nephoscope

#endif
