// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMNephoscopePresets.h"

#include "NephoscopePresets.h" // made by CMake: PRESETS, PRESETS_OF_ARRAYS

#include "vtkObjectFactory.h"
#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionPresets.h"

vtkStandardNewMacro(vtkSMNephoscopePresets);

namespace
{
constexpr double lowestPriority = -1.0; // below ParaView's own settings and the user's
}

void vtkSMNephoscopePresets::Load()
{
  auto* presets = vtkSMTransferFunctionPresets::GetInstance();
  for (const auto& preset : PRESETS)
  {
    if (!presets->HasPreset(preset.name))
    {
      presets->AddPreset(preset.name, std::string(preset.json));
    }
  }
  vtkSMSettings::GetInstance()->AddCollectionFromString(PRESETS_OF_ARRAYS, lowestPriority);
}
