// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMFlowVolumeInitializationHelper
 * @brief puts the generating polygon of a new Flow Volume into the flow
 *
 * ParaView's domains know the bounds of the data but not the flow inside. This class requests a
 * position from the server before the panel appears, and sets Center, Radius and Normal, unless a
 * script has set them.
 */
#ifndef vtkSMFlowVolumeInitializationHelper_h
#define vtkSMFlowVolumeInitializationHelper_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkSMFlowVolumeInitializationHelper
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMFlowVolumeInitializationHelper* New();
  vtkTypeMacro(vtkSMFlowVolumeInitializationHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTime) override;

protected:
  vtkSMFlowVolumeInitializationHelper() = default;
  ~vtkSMFlowVolumeInitializationHelper() override = default;

private:
  vtkSMFlowVolumeInitializationHelper(const vtkSMFlowVolumeInitializationHelper&) = delete;
  void operator=(const vtkSMFlowVolumeInitializationHelper&) = delete;
};

#endif
