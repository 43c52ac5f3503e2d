// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingRayCastMapper
 * @brief A vtkUnstructuredGridVolumeRayCastMapper that draws with vtkCellCompositingMapper
 *
 * Sample distances, number of threads, ray cast function and integrator are accepted and have no
 * effect: every pixel has the exact integral.
 *
 * @sa vtkCellCompositingOverride vtkCellCompositingMapper
 */
#ifndef vtkCellCompositingRayCastMapper_h
#define vtkCellCompositingRayCastMapper_h

#include "vtkNephoscopeRepresentationsCellCompositingModule.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"

#include <memory>

class vtkCellCompositingMapper;

namespace nephoscope
{
class CellsInPlace;
}

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT vtkCellCompositingRayCastMapper
  : public vtkUnstructuredGridVolumeRayCastMapper
{
public:
  static vtkCellCompositingRayCastMapper* New();
  vtkTypeMacro(vtkCellCompositingRayCastMapper, vtkUnstructuredGridVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mapper that draws. Input, scalars and clipping planes are those of this mapper; every other
   * setting may be changed.
   */
  vtkCellCompositingMapper* GetCellCompositingMapper();

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkCellCompositingRayCastMapper();
  ~vtkCellCompositingRayCastMapper() override;
  void ReportReferences(vtkGarbageCollector* collector) override;

private:
  vtkCellCompositingRayCastMapper(const vtkCellCompositingRayCastMapper&) = delete;
  void operator=(const vtkCellCompositingRayCastMapper&) = delete;

  std::unique_ptr<nephoscope::CellsInPlace> Cells;
};

#endif
