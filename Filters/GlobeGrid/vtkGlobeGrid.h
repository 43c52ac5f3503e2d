// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkGlobeGrid_h
#define vtkGlobeGrid_h

#include "vtkNephoscopeFiltersGlobeGridModule.h" // for export macro
#include "vtkStructuredGridAlgorithm.h"

class VTKNEPHOSCOPEFILTERSGLOBEGRID_EXPORT vtkGlobeGrid : public vtkStructuredGridAlgorithm
{
public:
  static vtkGlobeGrid* New();
  vtkTypeMacro(vtkGlobeGrid, vtkStructuredGridAlgorithm);

protected:
  vtkGlobeGrid() = default;
  ~vtkGlobeGrid() override = default;

private:
  vtkGlobeGrid(const vtkGlobeGrid&) = delete;
  void operator=(const vtkGlobeGrid&) = delete;
};

#endif
