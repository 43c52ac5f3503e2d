// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingVolume
 * @brief The prop of the Cell Compositing representation
 *
 * It differs from vtkPVLODVolume in two ways. It draws without a scalar array (the representation then gives the mapper
 * a uniform one), and it stays out of the depth peeling pass, whose framebuffers can not take sorted, blended cells:
 * when that pass asks it to draw, it waits for the overlay stage, which comes next on the real framebuffer and still
 * has the opaque depth.
 */
#ifndef vtkCellCompositingVolume_h
#define vtkCellCompositingVolume_h

#include "vtkNephoscopeParaViewRepresentationsModule.h" // for export macro
#include "vtkPVLODVolume.h"

class VTKNEPHOSCOPEPARAVIEWREPRESENTATIONS_EXPORT vtkCellCompositingVolume : public vtkPVLODVolume
{
public:
  static vtkCellCompositingVolume* New();
  vtkTypeMacro(vtkCellCompositingVolume, vtkPVLODVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  vtkCellCompositingVolume() = default;
  ~vtkCellCompositingVolume() override = default;

private:
  vtkCellCompositingVolume(const vtkCellCompositingVolume&) = delete;
  void operator=(const vtkCellCompositingVolume&) = delete;

  int Draw(vtkViewport* viewport);
  bool Postponed = false;
};

#endif
