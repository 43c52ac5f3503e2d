// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a dataset has no velocity field.
#ifndef nephoscope_VelocityProblem_h
#define nephoscope_VelocityProblem_h

#include "VelocityFields.h"

class vtkDataSet;

namespace nephoscope
{
// A sentence that names what is wrong and its remedy; empty if nothing is.
std::string VelocityProblem(vtkDataSet* data, const VelocityArray& array);
}

#endif
