// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// How small the blanked cells of datasets are.
#ifndef nephoscope_BlankedCells_h
#define nephoscope_BlankedCells_h

#include <vector>

class vtkDataSet;

namespace nephoscope
{
// The least of those above 0; 0 if there is none.
double SmallestSize(const std::vector<double>& sizes);

// The size of the smallest cell that is blanked, itself or by a point: the cube root of the volume
// of its bounds. 0 if there is none.
double SmallestBlankedCell(const std::vector<vtkDataSet*>& sets);
}

#endif
