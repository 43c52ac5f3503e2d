// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ResourceWindow.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <utility>

namespace nephoscope
{

/**
 * What windows of VTK keep of resources, and call in their own context before they close, has no
 * header that is installed. Texture objects have it built in: this one has no texture.
 */
class ResourceWindow::Registered : public vtkTextureObject
{
public:
  static Registered* New();
  vtkTypeMacro(Registered, vtkTextureObject);

  // Called by anybody, the superclass makes the context current and calls again; called by the
  // window, it does not.
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    if (!this->Asking)
    {
      this->Asking = true;
      this->Superclass::ReleaseGraphicsResources(window);
      this->Asking = false;
    }
    if (vtkOpenGLRenderWindow* own = std::exchange(this->Window, nullptr))
    {
      this->Release(own);
    }
  }

  Releaser Release;
  vtkOpenGLRenderWindow* Window = nullptr;

protected:
  Registered() = default;
  ~Registered() override = default;

private:
  bool Asking = false;
};

vtkStandardNewMacro(ResourceWindow::Registered);

ResourceWindow::ResourceWindow(Releaser release)
  : Resources(vtkSmartPointer<Registered>::New())
{
  this->Resources->Release = std::move(release);
}

ResourceWindow::~ResourceWindow()
{
  this->Leave(this->Get());
}

vtkOpenGLRenderWindow* ResourceWindow::Get() const
{
  return this->Resources->Window;
}

void ResourceWindow::Enter(vtkOpenGLRenderWindow* window)
{
  if (this->Get() == window)
  {
    return;
  }
  this->Leave(this->Get());
  this->Resources->SetContext(window); // which makes it current
  this->Resources->Window = window;
  window->MakeCurrent();
}

void ResourceWindow::Leave(vtkWindow* window)
{
  if (window && window == this->Get())
  {
    this->Resources->ReleaseGraphicsResources(window);
  }
}

} // namespace nephoscope
