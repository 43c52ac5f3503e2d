// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells evenly chosen from data that may be spread over ranks.
#ifndef nephoscope_EvenChoice_h
#define nephoscope_EvenChoice_h

#include "VelocityField.h"

#include <cstddef>
#include <vector>

class vtkBoundingBox;
class vtkDataObject;

namespace nephoscope
{
class FlowVolumeExchange;

// The middles of about `most` cells, or of all if there are fewer: those with the smallest hashes
// of their middles. `box` is that of the data of all ranks.
// The same middles in the same order on every rank, however the data are divided, and for the same
// cells as an image, a grid or a list; every n-th cell of a grid would lie in few of its planes. To
// be called by all ranks.
std::vector<Vector3> EvenlyChosenMiddles(vtkDataObject* data, const vtkBoundingBox& box,
  std::size_t most, const FlowVolumeExchange& exchange);
}

#endif
