// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumVolume
 * @brief The prop of representations of a medium
 *
 * It differs from vtkPVLODVolume in that it draws without a scalar array: the representation then
 * gives the mapper a uniform one; and its bounds can be less than those of the mapper.
 */
#ifndef vtkMediumVolume_h
#define vtkMediumVolume_h

#include "vtkBoundingBox.h"                    // for SeenBounds
#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkPVLODVolume.h"

class VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkMediumVolume : public vtkPVLODVolume
{
public:
  static vtkMediumVolume* New();
  vtkTypeMacro(vtkMediumVolume, vtkPVLODVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override;

  /**
   * Bounds in data coordinates, outside of which the medium is faint: a camera that is reset need
   * not see it. By default not valid: the bounds are those of the mapper.
   */
  void SetSeenBounds(const double bounds[6]) { this->SeenBounds.SetBounds(bounds); }
  /** Those of the mapper, as far as they are seen. */
  double* GetBounds() override;
  using Superclass::GetBounds;

protected:
  vtkMediumVolume() = default;
  ~vtkMediumVolume() override = default;

private:
  vtkBoundingBox SeenBounds;
  vtkMediumVolume(const vtkMediumVolume&) = delete;
  void operator=(const vtkMediumVolume&) = delete;
};

#endif
