// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Colour and extinction of every sample, by the transfer functions of a volume property. */
#ifndef nephoscope_SplatClasses_h
#define nephoscope_SplatClasses_h

#include "ScalarSelection.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataSet;
class vtkVolumeProperty;

namespace nephoscope
{

struct SplatSamples;

/**
 * Visible samples with their appearance: red, green, blue, and extinction per unit length of the
 * world, times their shares.
 */
struct SplatClasses
{
  std::vector<std::int32_t> Samples;        ///< numbers of the samples, ascending
  std::vector<std::array<float, 4>> Colors; ///< one for each of them, or with `asScalars` the
                                            ///< scalar three times; none after FreeColors
  std::size_t NumberWithoutValue = 0;       ///< of the samples left out: a value is not finite

  void FreeColors() { std::vector<std::array<float, 4>>().swap(this->Colors); }
};

/**
 * `scalars.Array` gives the colour, `opacity.Array`, or the same one if it is null, the extinction.
 * Values that are not finite are not seen, nor samples with at most a millionth of the greatest
 * extinction. `keepTransparent`: samples without extinction stay too, for their vectors.
 * `interpolate`: samples at points have together the extinction of the cells between them
 * (CellExtinction.h). `asScalars`: shaders find the colour.
 */
SplatClasses ClassifySplats(vtkDataSet* data, const SplatSamples& samples,
  const ScalarSelection& scalars, const ScalarSelection& opacity, vtkVolumeProperty* property,
  bool keepTransparent, bool interpolate, bool asScalars = false);

} // namespace nephoscope

#endif
