// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstCamera.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double farOff = 30.0; // scales and places that differ by this factor are not of one picture
constexpr double small = 8.0;   // of this part of a picture not much is seen, where there is nothing else

struct Sphere
{
  std::array<double, 3> Center;
  double Radius;
};

// What a camera is turned to.
Sphere SeenBy(vtkCamera* camera)
{
  Sphere seen;
  camera->GetFocalPoint(seen.Center.data());
  seen.Radius = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return seen;
}

// Of what a display shows; without extent where there is nothing.
Sphere ShownBy(vtkSMProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  vtkBoundingBox box;
  if (source && source->GetObjectsCreated())
  {
    box = vtkBoundingBox(source->GetDataInformation(input.GetOutputPort())->GetBounds());
  }
  Sphere shown{ { 0, 0, 0 }, 0 };
  if (box.IsValid())
  {
    box.GetCenter(shown.Center.data());
    shown.Radius = 0.5 * box.GetDiagonalLength();
  }
  return shown;
}

bool Suits(const Sphere& seen, const Sphere& shown)
{
  const double apart = std::sqrt(vtkMath::Distance2BetweenPoints(seen.Center.data(), shown.Center.data()));
  return shown.Radius > 0.0 && shown.Radius < farOff * seen.Radius && seen.Radius < farOff * shown.Radius &&
    apart < farOff * (seen.Radius + shown.Radius);
}

bool IsVisible(vtkSMProxy* display)
{
  return vtkSMPropertyHelper(display, "Visibility", true).GetAsInt() != 0;
}

bool Has(vtkSMProxy* view, vtkSMProxy* display)
{
  const vtkSMPropertyHelper all(view, "Representations");
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    if (all.GetAsProxy(i) == display)
    {
      return true;
    }
  }
  return false;
}

bool IsSmall(const Sphere& seen, const Sphere& shown)
{
  return small * shown.Radius < seen.Radius;
}

// Whether any other display holds for a test of what it shows.
template <typename Test>
bool AnyOther(vtkSMProxy* view, vtkSMProxy* display, Test test)
{
  const vtkSMPropertyHelper all(view, "Representations");
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* other = all.GetAsProxy(i);
    if (other && other != display && IsVisible(other) && test(ShownBy(other)))
    {
      return true;
    }
  }
  return false;
}

// Waits for the next update of one view.
class Watch
{
public:
  Watch(vtkSMRenderViewProxy* view, vtkSMProxy* display)
    : View(view)
    , Display(display)
    , Seen(SeenBy(view->GetActiveCamera()))
  {
    view->GetActiveCamera()->GetPosition(this->Eye.data());
    this->Tag = view->AddObserver(vtkCommand::UpdateDataEvent, this, &Watch::OnUpdate);
    this->End = view->AddObserver(vtkCommand::DeleteEvent, this, &Watch::OnDelete);
  }

private:
  void OnUpdate(vtkObject*, unsigned long, void*)
  {
    vtkSMRenderViewProxy* view = this->View;
    if (this->Display && Has(view, this->Display) && IsVisible(this->Display) && this->IsWhereItWas() && this->IsNotSeen())
    {
      double bounds[6];
      const vtkSMPropertyHelper input(this->Display.Get(), "Input");
      vtkSMSourceProxy::SafeDownCast(input.GetAsProxy())->GetDataInformation(input.GetOutputPort())->GetBounds(bounds);
      view->ResetCamera(bounds);
    }
    view->RemoveObserver(this->End);
    view->RemoveObserver(this->Tag);
    delete this;
  }

  void OnDelete(vtkObject*, unsigned long, void*) { delete this; }

  bool IsNotSeen()
  {
    const Sphere shown = ShownBy(this->Display);
    const bool alone = !AnyOther(this->View, this->Display, [](const Sphere& other) { return other.Radius > 0.0; });
    return !Suits(this->Seen, shown) || (alone && IsSmall(this->Seen, shown));
  }

  bool IsWhereItWas()
  {
    vtkCamera* camera = this->View->GetActiveCamera();
    std::array<double, 3> eye;
    camera->GetPosition(eye.data());
    const Sphere seen = SeenBy(camera);
    return eye == this->Eye && seen.Center == this->Seen.Center && seen.Radius == this->Seen.Radius;
  }

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkSMProxy> Display;
  Sphere Seen;
  std::array<double, 3> Eye;
  unsigned long Tag = 0;
  unsigned long End = 0;
};
}

void resetCameraWhereShown(vtkSMProxy* display)
{
  const Sphere shown = ShownBy(display);
  vtkNew<vtkSMProxyIterator> views;
  views->SetSession(display->GetSession());
  views->SetModeToOneGroup();
  for (views->Begin("views"); shown.Radius > 0.0 && !views->IsAtEnd(); views->Next())
  {
    auto* view = vtkSMRenderViewProxy::SafeDownCast(views->GetProxy());
    if (view && view->GetActiveCamera())
    {
      const Sphere seen = SeenBy(view->GetActiveCamera());
      const auto suitsCamera = [&](const Sphere& other) { return Suits(seen, other); };
      if ((!Suits(seen, shown) || IsSmall(seen, shown)) && AnyOther(view, display, suitsCamera))
      {
        new Watch(view, display); // deletes itself
      }
    }
  }
}

} // namespace nephoscope
