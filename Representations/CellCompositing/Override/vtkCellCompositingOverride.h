// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingOverride
 * @brief Lets VTK's object factories create Cell Compositing instead of VTK's mappers for
 *        unstructured grids
 *
 * While the override is on, vtkProjectedTetrahedraMapper::New() returns a
 * vtkCellCompositingProjectedTetrahedraMapper. Existing mappers do not change.
 * vtkUnstructuredGridVolumeRayCastMapper::New() returns a vtkCellCompositingRayCastMapper if VTK
 * was built with VTK_ALL_NEW_OBJECT_FACTORY; other builds do not ask the factories for this class,
 * and nephoscope.override_vtk() replaces the name in Python instead.
 *
 * The override is off by default. The environment variable NEPHOSCOPE_OVERRIDE_VTK=1 turns it on in
 * ParaView when the plugin is loaded, and in Python at `import nephoscope`.
 */
#ifndef vtkCellCompositingOverride_h
#define vtkCellCompositingOverride_h

#include "vtkNephoscopeRepresentationsCellCompositingModule.h"
#include "vtkObject.h"

class VTKNEPHOSCOPEREPRESENTATIONSCELLCOMPOSITING_EXPORT vtkCellCompositingOverride
  : public vtkObject
{
public:
  static vtkCellCompositingOverride* New();
  vtkTypeMacro(vtkCellCompositingOverride, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether VTK creates Cell Compositing. There is one state for the whole process. Default: off.
   */
  static void SetEnabled(bool enabled);
  static bool GetEnabled();
  static void EnabledOn() { SetEnabled(true); }
  static void EnabledOff() { SetEnabled(false); }
  ///@}

  /**
   * Turns the override on if the environment variable NEPHOSCOPE_OVERRIDE_VTK is set to anything
   * but 0 or an empty string.
   */
  static void ReadEnvironment();

  /** SetEnabled for ParaView's settings, which the environment variable precedes. */
  void SetEnabledInSettings(bool enabled);

protected:
  vtkCellCompositingOverride() = default;
  ~vtkCellCompositingOverride() override = default;

private:
  vtkCellCompositingOverride(const vtkCellCompositingOverride&) = delete;
  void operator=(const vtkCellCompositingOverride&) = delete;
};

#endif
