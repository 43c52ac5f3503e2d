// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours for the array that colours the vectors, where the user has given no colour map for it.
 */
#ifndef nephoscope_SplatVectorColors_h
#define nephoscope_SplatVectorColors_h

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"

#include <array>
#include <string>

class vtkDataSet;

namespace nephoscope
{

/**
 * Stores the range of an array (of magnitudes, if it has components) over all ranks with the data.
 * Collective.
 */
void StoreVectorColorRange(vtkDataSet* data, bool onCells, const std::string& array);

/**
 * ParaView's own default, from blue over white to red, over the stored range. Rebuilt only for
 * another range.
 */
class DefaultVectorColors
{
public:
  vtkColorTransferFunction* Over(vtkDataSet* data);

private:
  vtkNew<vtkColorTransferFunction> Function;
  std::array<double, 2> Range{ { 0.0, 0.0 } };
};

} // namespace nephoscope

#endif
