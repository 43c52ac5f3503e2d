// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumVolume
 * @brief The prop of representations of a medium
 *
 * It differs from vtkPVLODVolume in that it draws without a scalar array: the representation then gives the mapper
 * a uniform one.
 */
#ifndef vtkMediumVolume_h
#define vtkMediumVolume_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkPVLODVolume.h"

class VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkMediumVolume : public vtkPVLODVolume
{
public:
  static vtkMediumVolume* New();
  vtkTypeMacro(vtkMediumVolume, vtkPVLODVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override;

protected:
  vtkMediumVolume() = default;
  ~vtkMediumVolume() override = default;

private:
  vtkMediumVolume(const vtkMediumVolume&) = delete;
  void operator=(const vtkMediumVolume&) = delete;
};

#endif
