// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Which nodes of the hierarchy of splats are drawn in a view: those whose error is small enough, as near to the root as possible. */
#ifndef SplatCut_h
#define SplatCut_h

#include "SplatOrder.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class SplatTree;
struct SplatTreeNode;

/** When a node is drawn instead of what lies below it. */
struct SplatCutRule
{
  double Tolerance = 0;       ///< the greatest error
  bool OfImage = true;        ///< errors are optical depths along the ray, else values of the opacity function
  bool RootMeanSquare = false; ///< deviations below the node in the mean, else the greatest
  double Extinction = 1;      ///< factor on that of the nodes, for OfImage; else from it to the opacity function
  double Vector = 0;          ///< optical depth, or else share of the greatest speed, of a vector of length 1
  double KernelRadius = 1;     ///< cells
  std::size_t MostSplats = 0; ///< the tolerance grows until there are no more, except around the eye; 0: as many as there are
};

/** The view, in the coordinates of the nodes. */
struct SplatCutView
{
  SplatEye Eye{ { 0, 0, 0, 1 } };
  double Pixel = 0; ///< size of one at a distance of 1, in a parallel projection everywhere
};

/**
 * The error of a node in a view; infinite around the eye, where only leaves can be drawn, and 0 for a node smaller than a pixel. An optical
 * depth is the deviation times the length of the ray in the node's cell.
 */
float SplatError(const SplatTreeNode& node, const SplatCutRule& rule, const SplatCutView& view);

/**
 * The numbers of the splats to draw, in the order of the tree. `tolerance`, where given, receives the tolerance that was needed. The
 * same whatever the number of threads.
 */
std::vector<std::int32_t> CutSplatTree(const SplatTree& tree, const SplatCutRule& rule,
  const SplatCutView& view, double* tolerance = nullptr);

} // namespace nephoscope

#endif
