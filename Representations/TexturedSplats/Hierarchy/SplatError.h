// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The error of the nodes of the splat hierarchy, in a view, relative to the samples that they
 * represent.
 */
#ifndef nephoscope_SplatError_h
#define nephoscope_SplatError_h

#include "SplatOrder.h"

#include <cstddef>
#include <vector>

namespace nephoscope
{

class SplatTree;
struct SplatClasses;
struct SplatSamples;

/** Definition of the error of a node. */
struct SplatErrorRule
{
  enum class Measure
  {
    Greatest, ///< deviation of a sample, LaurHanrahan1991, or that in the mean square if it is more
    RootMeanSquare, ///< over the node
    Picture         ///< root of the sum of squares over pixels; of the data: as RootMeanSquare
  };
  Measure As = Measure::Picture;
  bool OfImage =
    true; ///< errors are optical depths along the ray, else values of the opacity function
  double Extinction =
    1; ///< factor on that of the nodes, for OfImage; else from it to the opacity function
  double Vector =
    0; ///< optical depth, or else share of the greatest speed, of a vector of length 1
  double KernelRadius = 1; ///< cells
};

/** The view, in the coordinates of the nodes. */
struct SplatCutView
{
  SplatEye Eye{ { 0, 0, 0, 1 } };
  double Pixel =
    0; ///< size of one at a distance of 1, in a parallel projection everywhere; in the world
  SplatMatrix ToWorld{ { { { 1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, 0, 1 } } } }; ///< but for a rotation
};

/**
 * Errors of all nodes of the tree: infinite around the eye, where only leaves can be drawn, and 0
 * for a node smaller than a pixel; the error grows and falls steadily on the way there.
 *
 * Error of the image: a node and those below it are gaussians on the screen; the squares of their
 * differences add up from level to level. It is thus seen from which side parts may be put
 * together: those one behind the other make no error.
 *
 * The same whatever the number of threads.
 */
std::vector<float> FindSplatErrors(const SplatTree& tree, const SplatSamples& samples,
  const SplatClasses& classes, const SplatErrorRule& rule, const SplatCutView& view);

} // namespace nephoscope

#endif
