// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHazeSource
 * @brief the haze of a view as a source in the pipeline, without data
 *
 * Its representation, vtkHazeRepresentation, has the settings: hiding it switches the haze off.
 */
#ifndef vtkHazeSource_h
#define vtkHazeSource_h

#include "vtkNephoscopeParaViewHazeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKNEPHOSCOPEPARAVIEWHAZE_EXPORT vtkHazeSource : public vtkPolyDataAlgorithm
{
public:
  static vtkHazeSource* New();
  vtkTypeMacro(vtkHazeSource, vtkPolyDataAlgorithm);

protected:
  vtkHazeSource();
  ~vtkHazeSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    return 1;
  }

private:
  vtkHazeSource(const vtkHazeSource&) = delete;
  void operator=(const vtkHazeSource&) = delete;
};

#endif
