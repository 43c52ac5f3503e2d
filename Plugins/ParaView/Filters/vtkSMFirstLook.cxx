// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMFirstLook.h"

#include "ActiveSourceArrays.h"
#include "ClassesOfSuite.h"
#include "DeletedInputs.h"
#include "FirstCamera.h"
#include "FirstColors.h"
#include "FlowVolumePolygon.h"
#include "SunConnection.h"
#include "ValuesInDomains.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkRankMessages.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkWeakPointer.h"

#include <string>

vtkStandardNewMacro(vtkSMFirstLook);

namespace
{
// The hint of the source for one of its ports.
vtkPVXMLElement* FindHint(vtkSMProxy* source, int port, const std::string& name)
{
  vtkPVXMLElement* hints = source->GetHints();
  for (unsigned int i = 0; hints && i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(i);
    int itsPort = port;
    hint->GetScalarAttribute("port", &itsPort);
    if (name == hint->GetName() && itsPort == port)
    {
      return hint;
    }
  }
  return nullptr;
}

bool IsEmpty(vtkSMSourceProxy* source, int port)
{
  vtkPVDataInformation* data = source->GetDataInformation(port);
  return data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0;
}

constexpr const char* solidColorIsChosen = "NephoscopeSolidColor"; // of displays
constexpr const char* arrayIsChosen = "NephoscopeColorArray";

// One level of a grid, or polygons: a volume would draw nothing.
bool IsSheet(vtkPVDataInformation* data)
{
  const int* extent = data->GetExtent();
  return data->DataSetTypeIsA("vtkPolyData") ||
    (data->DataSetTypeIsA("vtkStructuredGrid") &&
      (extent[0] == extent[1] || extent[2] == extent[3] || extent[4] == extent[5]));
}

void PrepareDisplay(vtkSMPVRepresentationProxy* display);

// Waits for the first data of a source whose Apply has failed, and then gives its display the looks
// of a first one, if nobody else has.
class FirstData
{
public:
  FirstData(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port)
    : Display(display)
    , Source(source)
    , Port(port)
    , Type(vtkSMPropertyHelper(display, "Representation", true).GetAsString())
  {
    this->Observe(source, &FirstData::OnData);
  }

private:
  void Observe(vtkSMProxy* proxy, void (FirstData::*onUpdate)(vtkObject*, unsigned long, void*))
  {
    this->Observed = proxy;
    this->Tag = proxy->AddObserver(vtkCommand::UpdateDataEvent, this, onUpdate);
    this->End = proxy->AddObserver(vtkCommand::DeleteEvent, this, &FirstData::OnDelete);
  }

  void Ignore()
  {
    this->Observed->RemoveObserver(this->End);
    this->Observed->RemoveObserver(this->Tag);
  }

  // The view is in the midst of an update: what is changed now it would draw without one.
  void OnData(vtkObject*, unsigned long, void*)
  {
    if (this->Display && IsEmpty(this->Source, this->Port))
    {
      return;
    }
    this->Ignore();
    vtkSMViewProxy* view = this->Display ? vtkSMViewProxy::FindView(this->Display) : nullptr;
    if (view)
    {
      this->Observe(view, &FirstData::OnView);
      return;
    }
    this->Prepare();
    delete this;
  }

  void OnView(vtkObject* caller, unsigned long, void*)
  {
    this->Ignore();
    this->Prepare();
    vtkSMViewProxy::SafeDownCast(caller)->Update();
    delete this;
  }

  void OnDelete(vtkObject*, unsigned long, void*) { delete this; }

  void Prepare()
  {
    if (this->Display && this->Source &&
      this->Type == vtkSMPropertyHelper(this->Display, "Representation", true).GetAsString())
    {
      vtkPVXMLElement* hint = FindHint(this->Source, this->Port, "RepresentationType");
      this->Display->SetRepresentationType(
        hint ? hint->GetAttributeOrEmpty("type") : this->Type.c_str());
      PrepareDisplay(this->Display);
    }
  }

  vtkWeakPointer<vtkSMPVRepresentationProxy> Display;
  vtkWeakPointer<vtkSMSourceProxy> Source;
  vtkWeakPointer<vtkSMProxy> Observed;
  int Port;
  std::string Type;
  unsigned long Tag = 0;
  unsigned long End = 0;
};

void PrepareDisplay(vtkSMPVRepresentationProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  const int port = source ? static_cast<int>(input.GetOutputPort()) : 0;
  vtkPVXMLElement* hint = source ? FindHint(source, port, "NephoscopeFirstLook") : nullptr;
  if (hint && IsEmpty(source, port))
  {
    new FirstData(display, source, port); // deletes itself
  }
  else if (hint)
  {
    if (std::string(hint->GetAttributeOrEmpty("sheet")) == "Surface" &&
      IsSheet(source->GetDataInformation(port)))
    {
      display->SetRepresentationType("Surface");
    }
    nephoscope::ColorFirst(display, source, port, hint->GetAttributeOrDefault("color", "active"));
    if (const char* preset = hint->GetAttribute("preset"))
    {
      nephoscope::ColorByPreset(display, source, port, preset);
    }
    display->UpdateVTKObjects();
    nephoscope::ResetCameraWhereShown(display);
  }
}

// Whoever chooses Solid Color, or an array, keeps it in other representations.
void NoteColoring(vtkSMPVRepresentationProxy* display)
{
  const bool hasArray = display->GetUsingScalarColoring();
  display->SetAnnotation(hasArray ? arrayIsChosen : solidColorIsChosen, "yes");
  display->RemoveAnnotation(hasArray ? solidColorIsChosen : arrayIsChosen);
}

// The texture multiplies the colour of the surface: in that of a colour map clouds would be blue or
// brown.
void WhitenCloud(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port)
{
  if (!display->HasAnnotation(arrayIsChosen))
  {
    nephoscope::WhitenContour(display, source, port);
    display->RemoveAnnotation(solidColorIsChosen); // nobody has
  }
}

// Arrays keep ParaView's own colours until one of the suite's representations draws them, or a
// display shows what one of its filters has made.
void UsePreset(vtkSMPVRepresentationProxy* display)
{
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  if (!source || display->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  const int port = static_cast<int>(input.GetOutputPort());
  const std::string type = vtkSMPropertyHelper(display, "Representation", true).GetAsString();
  if (type == "Cell Compositing" || type == "Textured Splats" || type == "Cloud Texture" ||
    nephoscope::IsOfSuite(source->GetVTKClassName()) ||
    nephoscope::HasLight(source->GetDataInformation(port)) ||
    source->GetDataInformation(port)->GetArrayInformation(
      "GlobeGridProjection", vtkDataObject::FIELD))
  {
    nephoscope::UsePresetOfArray(display, source, port);
  }
}

// What a display is coloured by. A change of any other property leaves colours that somebody has
// chosen.
bool IsOfColoring(const std::string& property)
{
  return property == "ColorArrayName" || property == "LookupTable" ||
    property == "ScalarOpacityFunction" || property == "Representation";
}

// As ParaView does for Volume: a medium of one colour says nothing about its data.
void OnDisplayProperty(vtkObject* caller, unsigned long, void*, void* data)
{
  auto* display = vtkSMPVRepresentationProxy::SafeDownCast(caller);
  const char* property =
    static_cast<const char*>(data); // null for those of displays inside this one
  if (display && property && IsOfColoring(property))
  {
    UsePreset(display);
  }
  if (display && property && std::string(property) == "ColorArrayName")
  {
    NoteColoring(display);
  }
  if (!display || !property || std::string(property) != "Representation" ||
    display->HasAnnotation(solidColorIsChosen) ||
    display->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  const std::string type = vtkSMPropertyHelper(display, "Representation", true).GetAsString();
  const vtkSMPropertyHelper input(display, "Input", true);
  auto* source =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  const int port = source ? static_cast<int>(input.GetOutputPort()) : 0;
  const bool hasArray = display->GetUsingScalarColoring();
  if (source && !hasArray && (type == "Cell Compositing" || type == "Textured Splats"))
  {
    nephoscope::ColorFirst(display, source, port, "active");
  }
  else if (source && hasArray && type == "Cloud Texture")
  {
    WhitenCloud(display, source, port);
  }
}

void OnRegistered(vtkObject*, unsigned long, void*, void* data)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  vtkSMProxy* proxy = registered ? registered->Proxy : nullptr;
  if (proxy && registered->GroupName && std::string(registered->GroupName) == "views")
  {
    nephoscope::DrawPolygonsOfWidgets(proxy);
    vtkRankMessages::Follow(proxy);
    return;
  }
  if (vtkSMPVRepresentationProxy::SafeDownCast(proxy))
  {
    nephoscope::OutliveOptionalInputs(proxy);
  }
  if (proxy)
  {
    nephoscope::KeepValuesInDomains(proxy);
    if (nephoscope::IsOfSuite(proxy->GetVTKClassName()) && vtkSMSourceProxy::SafeDownCast(proxy))
    {
      nephoscope::OutliveOptionalInputs(proxy);
      vtkRankMessages::Follow(proxy);
    }
  }
  if (!proxy || !registered->GroupName || !registered->ProxyName ||
    proxy->GetSessionProxyManager()->GetInLoadXMLState())
  {
    return;
  }
  if (auto* display = vtkSMPVRepresentationProxy::SafeDownCast(proxy))
  {
    PrepareDisplay(display);
    UsePreset(display);
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(OnDisplayProperty);
    display->AddObserver(vtkCommand::PropertyModifiedEvent, command);
  }
  else if (std::string(registered->GroupName) == "sources")
  {
    nephoscope::ConnectToSun(proxy);
    if (nephoscope::IsOfSuite(proxy->GetVTKClassName()))
    {
      nephoscope::ForgetArraysOfActiveSource(proxy);
    }
  }
}
}

void vtkSMFirstLook::Load()
{
  static bool isLoaded = false;
  if (!isLoaded && vtkSMProxyManager::IsInitialized())
  {
    isLoaded = true;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(OnRegistered);
    vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
  }
}
