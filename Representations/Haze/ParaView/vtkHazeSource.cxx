// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHazeSource.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHazeSource);

vtkHazeSource::vtkHazeSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkHazeSource::~vtkHazeSource() = default;
