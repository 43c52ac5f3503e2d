// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The colour and opacity functions of a volume property as one piecewise-linear function, in float.
 *
 * Nodes stand at every control point of either function, and further ones where a function is
 * curved between control points (midpoint, sharpness, colour spaces other than RGB), so that the
 * table follows it to within 1/2000 (of opacity: 1/2000 of itself). Where there are more than 16
 * nodes, JoinIntervals leaves out those that straight lines do not need: colours may then depart by
 * half a step of an 8-bit display, 1/510, opacity by no more than before.
 * Values are kept separately left and right of each node: a jump stays a jump. Colours of a
 * discretised lookup with fewer than 256 values are kept as its steps. With indexed (categorical)
 * colours each scalar has that of the nearest annotated value.
 *
 * Interval k lies between node k-1 and node k; interval 0 is all that lies below the first node and
 * interval n all that lies above the last, both constant.
 */
#ifndef nephoscope_TransferFunctionTable_h
#define nephoscope_TransferFunctionTable_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <array>
#include <vector>

class vtkVolumeProperty;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT TransferFunctionTable
{
public:
  using Value = std::array<float, 4>; ///< red, green, blue, opacity (unscaled)
  struct Interval
  {
    Value Low, High; ///< limits at its two ends, from inside
  };

  enum class Channels
  {
    ColorAndOpacity,
    Color,  ///< opacity 1
    Opacity ///< colour 0
  };

  /** Builds the table; nodes are expressed in scalars normalised by `range`. */
  void Build(vtkVolumeProperty* property, const double range[2],
    Channels channels = Channels::ColorAndOpacity);

  /** Multiplies the opacities. */
  void ScaleOpacity(double factor);

  std::vector<float> Nodes;  ///< ascending, at least one
  std::vector<float> Widths; ///< of the interval above each node; more exact than a difference of
                             ///< nodes; 0 for the last
  std::vector<Interval> Intervals; ///< Nodes.size() + 1

  /** Interval that contains s. A node belongs to the interval above it. */
  std::size_t FindInterval(float s) const;
  Value Evaluate(float s) const;
  float GreatestOpacity() const;
  /** True when opacity is zero everywhere in [low, high]: nothing there can be seen. */
  bool IsTransparent(float low, float high) const;
  /**
   * The longest range [low, high) in which opacity is zero; empty (low > high) if there is none.
   */
  std::array<float, 2> LongestTransparentRange() const;

private:
  std::vector<int>
    OpaqueIntervals; ///< how many of the intervals before this one are not transparent
};

} // namespace nephoscope

#endif
