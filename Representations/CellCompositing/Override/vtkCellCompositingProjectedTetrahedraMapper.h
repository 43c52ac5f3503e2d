// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingProjectedTetrahedraMapper
 * @brief A vtkProjectedTetrahedraMapper that draws with vtkCellCompositingMapper
 *
 * Cells of all types are drawn, and no visibility sort is needed: SetVisibilitySort is accepted and
 * has no effect.
 *
 * @sa vtkCellCompositingOverride vtkCellCompositingMapper
 */
#ifndef vtkCellCompositingProjectedTetrahedraMapper_h
#define vtkCellCompositingProjectedTetrahedraMapper_h

#include "vtkNephoscopeRepresentationsCellCompositingModule.h"
#include "vtkOpenGLProjectedTetrahedraMapper.h" // ParaView sets properties that only this class has

#include <memory>

class vtkCellCompositingMapper;

namespace nephoscope
{
class CellsInPlace;
}

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT vtkCellCompositingProjectedTetrahedraMapper
  : public vtkOpenGLProjectedTetrahedraMapper
{
public:
  static vtkCellCompositingProjectedTetrahedraMapper* New();
  vtkTypeMacro(vtkCellCompositingProjectedTetrahedraMapper, vtkOpenGLProjectedTetrahedraMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mapper that draws. Input, scalars and clipping planes are those of this mapper; every other
   * setting may be changed.
   */
  vtkCellCompositingMapper* GetCellCompositingMapper();

  bool IsSupported(vtkRenderWindow* window) override;
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkCellCompositingProjectedTetrahedraMapper();
  ~vtkCellCompositingProjectedTetrahedraMapper() override;
  void ReportReferences(vtkGarbageCollector* collector) override;

private:
  vtkCellCompositingProjectedTetrahedraMapper(
    const vtkCellCompositingProjectedTetrahedraMapper&) = delete;
  void operator=(const vtkCellCompositingProjectedTetrahedraMapper&) = delete;

  std::unique_ptr<nephoscope::CellsInPlace> Cells;
};

#endif
