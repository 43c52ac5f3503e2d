// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlowVolumePolygon.h"

#include "vtkActor.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkImplicitCylinderRepresentation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPVRenderView.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderer.h"
#include "vtkSMNewWidgetRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstring>
#include <map>
#include <memory>
#include <vector>

namespace nephoscope
{
namespace
{
constexpr const char* widgetName = "ImplicitCylinderWidgetRepresentation";
constexpr double lineWidth = 3.0; // pixels

using Numbers = std::vector<double>;

Numbers NumbersOf(vtkSMProxy* proxy, const char* property)
{
  return vtkSMPropertyHelper(proxy, property, true).GetDoubleArray();
}

// What the panel shows, also before it is applied.
Numbers ShownNumbersOf(vtkSMProxy* proxy, const char* property)
{
  vtkSMPropertyHelper helper(proxy, property, true);
  helper.SetUseUnchecked(true);
  return helper.GetDoubleArray();
}

// The Flow Volume that a widget moves: that has the same centre and radius.
vtkSMProxy* FlowVolumeOf(vtkSMProxy* widget)
{
  vtkNew<vtkSMProxyIterator> sources;
  sources->SetSession(widget->GetSession());
  sources->SetModeToOneGroup();
  for (sources->Begin("sources"); !sources->IsAtEnd(); sources->Next())
  {
    vtkSMProxy* source = sources->GetProxy();
    if (std::strcmp(source->GetXMLName(), "FlowVolume") == 0 &&
      ShownNumbersOf(source, "Center") == NumbersOf(widget, "Center") &&
      ShownNumbersOf(source, "Radius") == NumbersOf(widget, "Radius"))
    {
      return source;
    }
  }
  return nullptr;
}

// One widget in one view.
class Polygon
{
public:
  Polygon(vtkSMRenderViewProxy* view, vtkSMProxy* widget)
    : View(view)
    , Widget(widget)
  {
    this->Source->GeneratePolygonOff();
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetColor(1.0, 0.5, 0.0);
    this->Actor->GetProperty()->SetLineWidth(lineWidth);
    this->Actor->GetProperty()->LightingOff();
    this->Actor->PickableOff();
    this->Actor->UseBoundsOff();
    this->Actor->VisibilityOff();
    this->renderer()->AddActor(this->Actor);
    for (const unsigned long event : { vtkCommand::PropertyModifiedEvent,
           vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent })
    {
      this->Tags.push_back(widget->AddObserver(event, this, &Polygon::Update));
    }
    this->Update(nullptr, 0, nullptr);
  }

  ~Polygon()
  {
    for (const unsigned long tag : this->Tags)
    {
      if (this->Widget)
      {
        this->Widget->RemoveObserver(tag);
      }
    }
    if (vtkRenderer* renderer = this->View ? this->renderer() : nullptr)
    {
      renderer->RemoveActor(this->Actor);
    }
  }

  Polygon(const Polygon&) = delete;
  void operator=(const Polygon&) = delete;

private:
  vtkRenderer* renderer() const
  {
    auto* view = vtkPVRenderView::SafeDownCast(this->View->GetClientSideObject());
    return view ? view->GetNonCompositedRenderer() : nullptr;
  }

  void Update(vtkObject*, unsigned long, void*)
  {
    if (!this->Flow)
    {
      this->Flow = FlowVolumeOf(this->Widget);
      if (!this->Flow)
      {
        return; // the widget of another filter
      }
      this->HideCylinder();
    }
    const Numbers center = NumbersOf(this->Widget, "Center"),
                  radius = NumbersOf(this->Widget, "Radius");
    this->Actor->SetVisibility(
      vtkSMPropertyHelper(this->Widget, "Visibility", true).GetAsInt() != 0);
    if (center.size() == 3 && radius.size() == 1)
    {
      const Numbers normal = this->NormalAt(center);
      this->Source->SetCenter(center.data());
      this->Source->SetRadius(radius[0]);
      this->Source->SetNormal(normal.data());
      this->Source->SetNumberOfSides(
        vtkSMPropertyHelper(this->Flow, "NumberOfSides", true).GetAsInt());
    }
  }

  // Across the flow there, as the filter turns it, or as the panel says.
  Numbers NormalAt(const Numbers& center)
  {
    vtkSMPropertyHelper toFlow(this->Flow, "NormalToFlow", true);
    toFlow.SetUseUnchecked(true);
    if (toFlow.GetAsInt() != 0)
    {
      if (center != this->FlowAt)
      {
        this->Preview(center);
        this->Flow->UpdatePropertyInformation(this->Flow->GetProperty("PreviewNormal"));
        this->FlowAt = center;
      }
      const Numbers normal = NumbersOf(this->Flow, "PreviewNormal");
      if (normal.size() == 3 && vtkMath::Norm(normal.data()) > 0.0)
      {
        return normal;
      }
    }
    const Numbers axis = NumbersOf(this->Widget, "Axis");
    return axis.size() == 3 && vtkMath::Norm(axis.data()) > 0.0 ? axis : Numbers{ 0.0, 0.0, 1.0 };
  }

  // Past the property, which would have ParaView drop the data of the smoke that is shown until the
  // next Apply.
  void Preview(const Numbers& center)
  {
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this->Flow) << "SetPreviewCenter"
           << center[0] << center[1] << center[2] << vtkClientServerStream::End;
    this->Flow->GetSession()->ExecuteStream(this->Flow->GetLocation(), stream);
  }

  // The arrow and the ball in the middle stay: they are what is dragged.
  void HideCylinder()
  {
    auto* widget = vtkSMNewWidgetRepresentationProxy::SafeDownCast(this->Widget.Get());
    vtkSMProxy* prop = widget ? widget->GetRepresentationProxy() : nullptr;
    if (auto* cylinder = prop
        ? vtkImplicitCylinderRepresentation::SafeDownCast(prop->GetClientSideObject())
        : nullptr)
    {
      for (vtkProperty* look :
        { cylinder->GetCylinderProperty(), cylinder->GetSelectedCylinderProperty(),
          cylinder->GetEdgesProperty(), cylinder->GetOutlineProperty() })
      {
        look->SetOpacity(0.0);
      }
    }
  }

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkSMProxy> Widget;
  vtkWeakPointer<vtkSMProxy> Flow;
  vtkNew<vtkRegularPolygonSource> Source;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  Numbers FlowAt;
  std::vector<unsigned long> Tags;
};

// All widgets of a view, as long as that lives.
class PolygonsOfView
{
public:
  explicit PolygonsOfView(vtkSMRenderViewProxy* view)
    : View(view)
  {
    view->AddObserver(vtkCommand::PropertyModifiedEvent, this, &PolygonsOfView::OnModified);
    view->AddObserver(vtkCommand::DeleteEvent, this, &PolygonsOfView::OnDelete);
  }

private:
  void OnModified(vtkObject*, unsigned long, void* name)
  {
    if (!name || std::strcmp(static_cast<const char*>(name), "HiddenRepresentations") != 0)
    {
      return;
    }
    std::map<vtkSMProxy*, std::unique_ptr<Polygon>> present;
    const vtkSMPropertyHelper hidden(this->View.Get(), "HiddenRepresentations", true);
    for (unsigned int i = 0; i < hidden.GetNumberOfElements(); ++i)
    {
      vtkSMProxy* widget = hidden.GetAsProxy(i);
      if (widget && std::strcmp(widget->GetXMLName(), widgetName) == 0)
      {
        auto& known = this->Polygons[widget];
        present[widget] = known ? std::move(known) : std::make_unique<Polygon>(this->View, widget);
      }
    }
    this->Polygons = std::move(present);
  }

  void OnDelete(vtkObject*, unsigned long, void*) { delete this; }

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  std::map<vtkSMProxy*, std::unique_ptr<Polygon>> Polygons;
};
}

void DrawPolygonsOfWidgets(vtkSMProxy* view)
{
  if (auto* renderView = vtkSMRenderViewProxy::SafeDownCast(view))
  {
    new PolygonsOfView(renderView); // deletes itself
  }
}

} // namespace nephoscope
