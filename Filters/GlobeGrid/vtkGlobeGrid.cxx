// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGlobeGrid.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGlobeGrid);
