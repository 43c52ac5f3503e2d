// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstCamera.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPVArrayInformation.h"
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
constexpr double farOff =
  30.0; // scales and places that differ by this factor are not of one picture
constexpr double regional =
  0.2; // further from the axis than this part of their extent, data are on one side of the globe
constexpr double part = 0.02;    // of the globe's size: smaller things do not belong to it
constexpr double roughly = 0.02; // bounds of displays, and of the data that they show
constexpr double small =
  8.0; // of this part of a picture not much is seen, where there is nothing else

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

vtkSMProxy* SourceOf(vtkSMProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  return input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr;
}

// The box around what a display shows; not valid where there is nothing.
vtkBoundingBox BoxOf(vtkSMProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source = vtkSMSourceProxy::SafeDownCast(SourceOf(display));
  return source && source->GetObjectsCreated()
    ? vtkBoundingBox(source->GetDataInformation(input.GetOutputPort())->GetBounds())
    : vtkBoundingBox();
}

// Without extent where there is nothing.
Sphere SphereAround(const vtkBoundingBox& box)
{
  Sphere shown{ { 0, 0, 0 }, 0 };
  if (box.IsValid())
  {
    box.GetCenter(shown.Center.data());
    shown.Radius = 0.5 * box.GetDiagonalLength();
  }
  return shown;
}

Sphere ShownBy(vtkSMProxy* display)
{
  return SphereAround(BoxOf(display));
}

bool Suits(const Sphere& seen, const Sphere& shown)
{
  const double apart =
    std::sqrt(vtkMath::Distance2BetweenPoints(seen.Center.data(), shown.Center.data()));
  return shown.Radius > 0.0 && shown.Radius < farOff * seen.Radius &&
    seen.Radius < farOff * shown.Radius && apart < farOff * (seen.Radius + shown.Radius);
}

bool IsVisible(vtkSMProxy* display)
{
  return vtkSMPropertyHelper(display, "Visibility", true).GetAsInt() != 0;
}

vtkBoundingBox BoxOfAll(vtkSMProxy* view)
{
  vtkBoundingBox box;
  const vtkSMPropertyHelper all(view, "Representations");
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    if (all.GetAsProxy(i) && IsVisible(all.GetAsProxy(i)))
    {
      box.AddBox(BoxOf(all.GetAsProxy(i)));
    }
  }
  return box;
}

// Whether a camera is as Reset Camera leaves it: that keeps the direction, and says nothing of what
// somebody wants to see.
bool IsReset(vtkCamera* camera, const Sphere& shown)
{
  const Sphere seen = SeenBy(camera);
  const double distance =
    shown.Radius / std::sin(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  const double apart =
    std::sqrt(vtkMath::Distance2BetweenPoints(seen.Center.data(), shown.Center.data()));
  return apart < roughly * shown.Radius &&
    std::abs(camera->GetDistance() - distance) < roughly * distance;
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

// Whether Globe Grid has put the data on a globe.
bool IsGlobe(vtkSMProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source = vtkSMSourceProxy::SafeDownCast(SourceOf(display));
  vtkPVArrayInformation* projection = source && source->GetObjectsCreated()
    ? source->GetDataInformation(input.GetOutputPort())
        ->GetArrayInformation("GlobeGridProjection", vtkDataObject::FIELD)
    : nullptr;
  return projection && projection->GetComponentRange(0)[1] == 0.0;
}

// As ParaView's cameras look at first: at the pole of a globe.
bool LooksDown(vtkCamera* camera)
{
  const double *along = camera->GetDirectionOfProjection(), *up = camera->GetViewUp();
  return along[2] < -0.999999 && up[1] > 0.999999;
}

// Where the eye is above the middle of the data; above all longitudes at a place in middle
// latitudes.
std::array<double, 3> EyeAbove(const Sphere& shown)
{
  const double length = vtkMath::Norm(shown.Center.data());
  if (length > regional * shown.Radius)
  {
    return { shown.Center[0] / length, shown.Center[1] / length, shown.Center[2] / length };
  }
  const double longitude = vtkMath::RadiansFromDegrees(-75.0),
               latitude = vtkMath::RadiansFromDegrees(25.0);
  return { std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
    std::sin(latitude) };
}

// Turns the camera so that it looks down there, with north above.
void LookFromAbove(vtkSMRenderViewProxy* view, const Sphere& shown)
{
  const auto above = EyeAbove(shown);
  const bool atPole = std::abs(above[2]) > 0.99;
  const double up[3] = { 0.0, atPole ? 1.0 : 0.0, atPole ? 0.0 : 1.0 };
  std::array<double, 3> eye;
  for (std::size_t k = 0; k < 3; ++k)
  {
    eye[k] = shown.Center[k] + 4.0 * shown.Radius * above[k];
  }
  vtkSMPropertyHelper(view, "CameraFocalPoint").Set(shown.Center.data(), 3);
  vtkSMPropertyHelper(view, "CameraPosition").Set(eye.data(), 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(up, 3);
  view->UpdateVTKObjects();
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
    if (other && other != display && IsVisible(other) && SourceOf(other) != SourceOf(display) &&
      test(ShownBy(other)))
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
    const bool isMine = this->Display && Has(view, this->Display) && IsVisible(this->Display);
    if (isMine && this->Turns())
    {
      const vtkBoundingBox all = BoxOfAll(view);
      LookFromAbove(view, SphereAround(all));
      Reset(view, all);
    }
    else if (isMine && this->IsWhereItWas() && this->IsNotSeen())
    {
      Reset(view, BoxOf(this->Display));
    }
    view->RemoveObserver(this->End);
    view->RemoveObserver(this->Tag);
    delete this;
  }

  void OnDelete(vtkObject*, unsigned long, void*) { delete this; }

  static void Reset(vtkSMRenderViewProxy* view, const vtkBoundingBox& box)
  {
    double bounds[6];
    box.GetBounds(bounds);
    view->ResetCamera(bounds);
  }

  // A globe, with what belongs to it, is not looked at from above its pole unless somebody has
  // turned the camera there.
  bool Turns()
  {
    vtkCamera* camera = this->View->GetActiveCamera();
    const Sphere mine = ShownBy(this->Display);
    const bool hasStrangers = AnyOther(this->View, this->Display, [&mine](const Sphere& other) {
      const double apart =
        std::sqrt(vtkMath::Distance2BetweenPoints(other.Center.data(), mine.Center.data()));
      return other.Radius > 0.0 &&
        (apart > mine.Radius || other.Radius < part * mine.Radius ||
          mine.Radius < part * other.Radius);
    });
    return !hasStrangers && IsGlobe(this->Display) && LooksDown(camera) &&
      (this->IsWhereItWas() || IsReset(camera, SphereAround(BoxOfAll(this->View))));
  }

  // But for other outputs of the same source.
  bool IsAlone()
  {
    return !AnyOther(
      this->View, this->Display, [](const Sphere& other) { return other.Radius > 0.0; });
  }

  bool IsNotSeen()
  {
    const Sphere shown = ShownBy(this->Display);
    return !Suits(this->Seen, shown) || (this->IsAlone() && IsSmall(this->Seen, shown));
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

void ResetCameraWhereShown(vtkSMProxy* display)
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
      const bool shallTurn = LooksDown(view->GetActiveCamera()) && IsGlobe(display);
      if (shallTurn ||
        ((!Suits(seen, shown) || IsSmall(seen, shown)) && AnyOther(view, display, suitsCamera)))
      {
        new Watch(view, display); // deletes itself
      }
    }
  }
}

} // namespace nephoscope
