// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Steps that points and images have in common. */
#ifndef nephoscope_VdbReading_h
#define nephoscope_VdbReading_h

#include "VdbGrids.h"

class vtkDataSetAttributes;

namespace nephoscope
{

struct VdbRead
{
  std::vector<openvdb::GridBase::Ptr> Grids; ///< in the order of the request
  std::string Error;
};

VdbRead ReadGrids(const VdbRequest& request);

/**
 * An error if so many bytes are more than the limit; `what` needs them, and `remedy` ends the
 * sentence.
 */
std::string CheckMemory(
  double bytes, double limit, const std::string& what, const std::string& remedy);

/** Bytes of a voxel's values in the arrays. */
double BytesOfValues(const VdbRequest& request);

/** The first scalars and the first vectors become the active ones; density before others. */
void ChooseActiveArrays(vtkDataSetAttributes* arrays);

} // namespace nephoscope

#endif
