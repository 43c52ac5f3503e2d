// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies every array of the input, of whatever type, to the order of the output.
#ifndef nephoscope_CarryArrays_h
#define nephoscope_CarryArrays_h

#include "GridOrder.h"

class vtkDataSetAttributes;

namespace nephoscope
{
class LonLatLevelGrid;

void CarryPointArrays(const LonLatLevelGrid& grid, const GridOrder& order, const int extent[6],
  vtkDataSetAttributes* output);
void CarryCellArrays(const LonLatLevelGrid& grid, const GridOrder& order, const int extent[6],
  vtkDataSetAttributes* output);
}

#endif
