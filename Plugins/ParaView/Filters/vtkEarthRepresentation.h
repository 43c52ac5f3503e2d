// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkEarthRepresentation
 * @brief a surface in the colours of the point array Earth, unless it is coloured by another one
 *
 * ParaView shows a scalar bar for every array chosen for colouring, even automatically; colours of
 * a picture have none.
 */
#ifndef vtkEarthRepresentation_h
#define vtkEarthRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkEarthRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkEarthRepresentation* New();
  vtkTypeMacro(vtkEarthRepresentation, vtkGeometryRepresentationWithFaces);

protected:
  vtkEarthRepresentation() = default;
  ~vtkEarthRepresentation() override = default;

  void UpdateColoringParameters() override;

private:
  vtkEarthRepresentation(const vtkEarthRepresentation&) = delete;
  void operator=(const vtkEarthRepresentation&) = delete;
};

#endif
