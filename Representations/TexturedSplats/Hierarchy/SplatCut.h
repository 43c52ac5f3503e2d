// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which nodes of the hierarchy of splats are drawn in a view: those whose error is small enough, as
 * near to the root as possible.
 */
#ifndef nephoscope_SplatCut_h
#define nephoscope_SplatCut_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class SplatTree;

/** When a node is drawn instead of what lies below it. */
struct SplatCutRule
{
  double Tolerance = 0; ///< the greatest error
  /**
   * Share of the tolerance, 0 to less than 1, over which a node fades in: one whose error is no
   * more than (1 - Blend) Tolerance is drawn alone, others together with what lies below, both
   * fainter. 0: a level comes at once.
   */
  double Blend = 0;
  std::size_t MostSplats = 0; ///< the tolerance grows until there are no more, except around the
                              ///< eye; 0: as many as there are
};

struct SplatCut
{
  std::vector<std::int32_t> Splats; ///< to draw, in the order of the tree
  std::vector<float> Weights;       ///< of their extinction; empty: all 1
  double Tolerance = 0;             ///< that was needed
};

/** `errors`: of the tree's nodes. The same whatever the number of threads. */
SplatCut CutSplatTree(
  const SplatTree& tree, const std::vector<float>& errors, const SplatCutRule& rule);

} // namespace nephoscope

#endif
