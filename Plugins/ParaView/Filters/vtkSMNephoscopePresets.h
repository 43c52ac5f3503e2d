// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMNephoscopePresets
 * @brief   puts the project's presets in ParaView's list, and makes them the first choice for
 *          fields of the weather
 *
 * The presets are those of Plugins/Presets. Load() runs when the plugin is loaded: it adds those
 * that are not in the list yet, and tells ParaView's settings, with the lowest priority, which
 * array begins with which preset; settings that a user has saved for an array take precedence.
 */
#ifndef vtkSMNephoscopePresets_h
#define vtkSMNephoscopePresets_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkObject.h"

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkSMNephoscopePresets : public vtkObject
{
public:
  static vtkSMNephoscopePresets* New();
  vtkTypeMacro(vtkSMNephoscopePresets, vtkObject);

  static void Load();

protected:
  vtkSMNephoscopePresets() = default;
  ~vtkSMNephoscopePresets() override = default;

private:
  vtkSMNephoscopePresets(const vtkSMNephoscopePresets&) = delete;
  void operator=(const vtkSMNephoscopePresets&) = delete;
};

#endif
