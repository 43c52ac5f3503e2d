// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatClasses.h"

#include "CellExtinction.h"
#include "SplatSamples.h"
#include "TransferFunctionTable.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{

namespace
{
// A fraction of the greatest extinction: samples with no more are transparent. The table of the
// transfer function holds no smaller share, so that at the foot of a ramp there is rounding in
// place of 0. On a lattice those on a ray add up to this share of the ray's length at the greatest
// extinction, by the ripple of the kernel 1.006 times as much: where a ray through nothing but the
// densest medium has an optical depth of t, alpha is at most 1.006e-6 t too small.
constexpr float leastShare = 1e-6f;

std::vector<float> Interpolated(vtkDataSet* data, const ScalarSelection& dense,
  const double range[2], const TransferFunctionTable& extinction)
{
  std::vector<float> values(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkUnsignedCharArray* ghosts = data->GetPointGhostArray();
  vtkSMPTools::For(0, data->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const bool hidden = ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT);
      values[static_cast<std::size_t>(i)] =
        hidden ? std::numeric_limits<float>::quiet_NaN() : Normalized(dense, i, range);
    }
  });
  return InterpolateExtinction(data, values, extinction);
}
}

SplatClasses ClassifySplats(vtkDataSet* data, const SplatSamples& samples,
  const ScalarSelection& scalars, const ScalarSelection& opacity, vtkVolumeProperty* property,
  bool keepTransparent, bool interpolate, bool asScalars)
{
  const ScalarSelection& dense = opacity.Array ? opacity : scalars;
  double range[2], denseRange[2];
  FindRange(data, scalars, range);
  FindRange(data, dense, denseRange);
  TransferFunctionTable color, extinction;
  color.Build(property, range, TransferFunctionTable::Channels::Color);
  extinction.Build(property, denseRange, TransferFunctionTable::Channels::Opacity);
  const std::vector<float> ofCells = interpolate && !dense.OnCells && data->GetNumberOfCells() > 0
    ? Interpolated(data, dense, denseRange, extinction)
    : std::vector<float>();
  const float rate = static_cast<float>(1.0 / property->GetScalarOpacityUnitDistance());

  std::vector<std::array<float, 4>> all(samples.Size(), { { 0, 0, 0, -1 } });
  vtkSMPTools::For(0, static_cast<vtkIdType>(all.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      const float s = Normalized(scalars, samples.Ids[at], range);
      const float d = Normalized(dense, samples.Ids[at], denseRange);
      if (std::isfinite(s) && std::isfinite(d))
      {
        all[at] = asScalars ? TransferFunctionTable::Value{ { s, s, s, 0 } } : color.Evaluate(s);
        all[at][3] = rate *
          (ofCells.empty() ? extinction.Evaluate(d)[3]
                           : ofCells[static_cast<std::size_t>(samples.Ids[at])]);
      }
    }
  });
  float greatest = 0.0f;
  for (const auto& look : all)
  {
    greatest = std::max(greatest, look[3]);
  }
  SplatClasses classes;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i][3] >= 0.0f && all[i][3] <= leastShare * greatest)
    {
      all[i][3] = 0.0f;
    }
    else if (all[i][3] > 0.0f)
    {
      all[i][3] *= samples.ShareOf(i);
    }
    classes.NumberWithoutValue += all[i][3] < 0.0f ? 1 : 0;
    if (all[i][3] > (keepTransparent ? -1.0f : 0.0f)) // without a value: -1
    {
      classes.Samples.push_back(static_cast<std::int32_t>(i));
      classes.Colors.push_back(all[i]);
    }
  }
  return classes;
}

} // namespace nephoscope
