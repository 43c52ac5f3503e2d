// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingOverride.h"

#include "vtkCellCompositingProjectedTetrahedraMapper.h"
#include "vtkCellCompositingRayCastMapper.h"

#include "vtkCollectionRange.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace
{
const char* const projectedTetrahedra = "vtkProjectedTetrahedraMapper";
const char* const rayCast = "vtkUnstructuredGridVolumeRayCastMapper";

VTK_CREATE_CREATE_FUNCTION(vtkCellCompositingProjectedTetrahedraMapper)
VTK_CREATE_CREATE_FUNCTION(vtkCellCompositingRayCastMapper)

class CellCompositingFactory : public vtkObjectFactory
{
public:
  vtkTypeMacro(CellCompositingFactory, vtkObjectFactory);

  static CellCompositingFactory* New()
  {
    auto* factory = new CellCompositingFactory;
    factory->InitializeObjectBase();
    return factory;
  }

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override
  {
    return "Nephoscope: Cell Compositing in place of VTK's mappers";
  }

private:
  CellCompositingFactory()
  {
    this->RegisterOverride(projectedTetrahedra, "vtkCellCompositingProjectedTetrahedraMapper",
      "Exact ray integrals", true,
      vtkObjectFactoryCreatevtkCellCompositingProjectedTetrahedraMapper);
    this->RegisterOverride(rayCast, "vtkCellCompositingRayCastMapper", "Exact ray integrals", true,
      vtkObjectFactoryCreatevtkCellCompositingRayCastMapper);
  }
};

/** The factory while the override is on, and the factories that it silences. */
struct OverrideState
{
  vtkSmartPointer<vtkObjectFactory> Factory;
  std::vector<std::pair<vtkSmartPointer<vtkObjectFactory>, const char*>> Silenced;
};

OverrideState& StateOfOverride()
{
  static OverrideState state;
  return state;
}

bool Overrides(vtkObjectFactory* factory, const std::string& className)
{
  for (int i = 0; i < factory->GetNumberOfOverrides(); ++i)
  {
    if (className == factory->GetClassOverrideName(i) && factory->GetEnableFlag(i))
    {
      return true;
    }
  }
  return false;
}

// VTK asks factories in the order of their registration, so that those of VTK itself would answer
// first.
void SilenceOthers(OverrideState& state, const char* className)
{
  for (vtkObjectFactory* factory : vtk::Range(vtkObjectFactory::GetRegisteredFactories()))
  {
    if (factory != state.Factory && Overrides(factory, className))
    {
      state.Silenced.emplace_back(factory, className);
      factory->SetEnableFlag(false, className, nullptr);
    }
  }
}

void TurnOn(OverrideState& state)
{
  state.Factory = vtk::TakeSmartPointer(CellCompositingFactory::New());
  vtkObjectFactory::RegisterFactory(state.Factory);
  SilenceOthers(state, projectedTetrahedra);
  SilenceOthers(state, rayCast);
}

bool EnvironmentAsks()
{
  const char* value = std::getenv("NEPHOSCOPE_OVERRIDE_VTK");
  return value && *value && std::string(value) != "0";
}

void TurnOff(OverrideState& state)
{
  for (const auto& [factory, className] : state.Silenced)
  {
    factory->SetEnableFlag(true, className, nullptr);
  }
  vtkObjectFactory::UnRegisterFactory(state.Factory);
  state = OverrideState{};
}
}

vtkStandardNewMacro(vtkCellCompositingOverride);

void vtkCellCompositingOverride::SetEnabled(bool enabled)
{
  if (enabled != GetEnabled())
  {
    (enabled ? TurnOn : TurnOff)(StateOfOverride());
  }
}

bool vtkCellCompositingOverride::GetEnabled()
{
  return StateOfOverride().Factory != nullptr;
}

void vtkCellCompositingOverride::ReadEnvironment()
{
  if (EnvironmentAsks())
  {
    SetEnabled(true);
  }
}

void vtkCellCompositingOverride::SetEnabledInSettings(bool enabled)
{
  SetEnabled(enabled || EnvironmentAsks());
}

void vtkCellCompositingOverride::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << (GetEnabled() ? "On" : "Off") << "\n";
}
