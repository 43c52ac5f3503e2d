// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkCellCompositingRepresentation_h
#define vtkCellCompositingRepresentation_h

#include "vtkNephoscopeParaViewRepresentationsModule.h" // for export macro
#include "vtkVolumeRepresentation.h"

class VTKNEPHOSCOPEPARAVIEWREPRESENTATIONS_EXPORT vtkCellCompositingRepresentation
  : public vtkVolumeRepresentation
{
public:
  static vtkCellCompositingRepresentation* New();
  vtkTypeMacro(vtkCellCompositingRepresentation, vtkVolumeRepresentation);

protected:
  vtkCellCompositingRepresentation() = default;
  ~vtkCellCompositingRepresentation() override = default;

private:
  vtkCellCompositingRepresentation(const vtkCellCompositingRepresentation&) = delete;
  void operator=(const vtkCellCompositingRepresentation&) = delete;
};

#endif
