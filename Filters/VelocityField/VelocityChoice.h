// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which array of a dataset is its velocity.
#ifndef nephoscope_VelocityChoice_h
#define nephoscope_VelocityChoice_h

#include "VelocityFields.h"

#include <string>

class vtkDataObject;
class vtkInformation;

namespace nephoscope
{
// The array that `wanted` (an entry of INPUT_ARRAYS_TO_PROCESS) names. Without a name:
// DisplayVelocity, else the active vectors, else the only array of three components; each on points
// before cells, in any block of the data.
// False, and a sentence in `problem` with the remedy, if there is none.
VTKNEPHOSCOPEFILTERSVELOCITYFIELD_EXPORT bool ChooseVelocity(
  vtkDataObject* data, vtkInformation* wanted, VelocityArray& choice, std::string& problem);
}

#endif
