// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMExampleColoring
 * @brief colours the clouds of the example when they are first shown
 *
 * ParaView gives structured data a solid colour at first, whatever representation the hints of their source ask for. Load, which the plugin
 * calls once, listens for displays of Clouds over the Globe and has them coloured by the active scalars.
 */
#ifndef vtkSMExampleColoring_h
#define vtkSMExampleColoring_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkObject.h"

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkSMExampleColoring : public vtkObject
{
public:
  static vtkSMExampleColoring* New();
  vtkTypeMacro(vtkSMExampleColoring, vtkObject);

  static void Load();

protected:
  vtkSMExampleColoring() = default;
  ~vtkSMExampleColoring() override = default;

private:
  vtkSMExampleColoring(const vtkSMExampleColoring&) = delete;
  void operator=(const vtkSMExampleColoring&) = delete;
};

#endif
