// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingRepresentation.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCellCompositingRepresentation);
