// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingVolume
 * @brief The prop of the Cell Compositing representation
 *
 * It differs from vtkPVLODVolume in that it draws without a scalar array: the representation then gives the mapper
 * a uniform one.
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

protected:
  vtkCellCompositingVolume() = default;
  ~vtkCellCompositingVolume() override = default;

private:
  vtkCellCompositingVolume(const vtkCellCompositingVolume&) = delete;
  void operator=(const vtkCellCompositingVolume&) = delete;
};

#endif
