// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How much of a medium lies behind each place of three coarse pictures, seen along the axes: tells
 * one that fills its bounds from a small dense one.
 */
#ifndef nephoscope_MediumProjections_h
#define nephoscope_MediumProjections_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <array>
#include <vector>

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT MediumProjections
{
public:
  static constexpr int Side = 32; ///< pixels along an edge

  enum Quantity
  {
    VOLUME, ///< where the scalar is finite
    SCALAR, ///< integrals over the volume
    OPACITY,
    NUMBER_OF_QUANTITIES
  };
  using Amounts = std::array<double, NUMBER_OF_QUANTITIES>;

  /**
   * Spreads amounts evenly over a box in the frame, both given by lower and upper bounds along each
   * axis.
   */
  void Add(
    const std::array<double, 6>& frame, const std::array<double, 6>& box, const Amounts& amounts);

  /**
   * How much more a ray through the mean opaque place meets than if the opacity were spread over
   * all that the medium covers: 1 where it is, about 5 for a Gaussian whose standard deviation is
   * an eighth of the bounds. It is the least of the three directions: a layer that fills its bounds
   * as seen from above counts as spread. The opacity is that of the opacity function or, as a ramp,
   * of the scalar over its range.
   */
  double Localization() const;
  double Localization(const double scalarRange[2]) const;

  /** All numbers, to be scaled or summed over processes. */
  std::vector<double>& GetPixels() { return this->Pixels; }
  const std::vector<double>& GetPixels() const { return this->Pixels; }

private:
  double Localization(const Amounts& opacityOf) const;

  static constexpr int Size = Side * Side;
  std::vector<double> Pixels =
    std::vector<double>(3 * NUMBER_OF_QUANTITIES * Size, 0.0); // by axis, quantity, row
};

} // namespace nephoscope

#endif
