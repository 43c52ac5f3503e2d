// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The hierarchy of a mapper's splats and its cut in the last view; each is rebuilt only when its
 * sources change.
 */
#ifndef nephoscope_SplatHierarchy_h
#define nephoscope_SplatHierarchy_h

#include "SplatCut.h"
#include "SplatError.h"
#include "SplatTree.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMatrix4x4;

namespace nephoscope
{

struct SplatClasses;
class SplatVectorScene;
struct SplatSamples;
struct ViewState;

SplatCutView FindCutView(const ViewState& state, vtkMatrix4x4* modelToWorld, int pixelsHigh);

class SplatHierarchy
{
public:
  /** Samples, classes or vectors have changed. */
  void Invalidate();

  /**
   * Makes the tree, with the vectors of that name (empty: none), where there is none; true if it
   * made it.
   */
  bool Update(const SplatSamples& samples, const SplatClasses& classes, SplatVectorScene& vectors,
    const std::string& vectorArrayName);

  /**
   * Finds what is drawn of the samples and classes that the tree was made from; true if that has
   * changed.
   */
  bool Select(const SplatSamples& samples, const SplatClasses& classes,
    const SplatErrorRule& errors, const SplatCutRule& rule, const SplatCutView& view);

  const SplatTree& Tree() const { return this->Nodes; }
  /** The splats to draw. */
  const std::vector<std::int32_t>& Cut() const { return this->Drawn.Splats; }
  /** Weights of their extinction, or empty: all 1. */
  const std::vector<float>& Weights() const { return this->Drawn.Weights; }
  /** Places of leaves and nodes, by their numbers. */
  const std::vector<std::array<float, 3>>& Positions() const { return this->Places; }
  /** The greatest stretch of a Jacobian of what is drawn, that of the samples at least. */
  double LongestDrawn(const SplatSamples& samples) const;
  double DrawnTolerance() const { return this->Drawn.Tolerance; }

private:
  void Build(const SplatSamples& samples, const SplatClasses& classes,
    const std::vector<std::array<float, 4>>& vectors);

  SplatTree Nodes;
  std::string VectorArrayName;
  std::vector<std::array<float, 3>> Places;
  std::vector<float> Errors; // of the nodes
  SplatCut Drawn;
  bool Selected = false;
  SplatErrorRule LastErrors;
  SplatCutRule LastRule;
  SplatCutView LastView;
};

} // namespace nephoscope

#endif
