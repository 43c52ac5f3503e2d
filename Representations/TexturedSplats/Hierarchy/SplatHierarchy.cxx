// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatHierarchy.h"

#include "SplatClasses.h"
#include "SplatRanges.h"
#include "SplatSamples.h"
#include "SplatVectorScene.h"
#include "ViewState.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nephoscope
{
namespace
{
auto AsTuple(const SplatErrorRule& r)
{
  return std::make_tuple(r.As, r.OfImage, r.Extinction, r.Vector, r.KernelRadius);
}

auto AsTuple(const SplatCutRule& r)
{
  return std::make_tuple(r.Tolerance, r.Blend, r.MostSplats);
}

auto AsTuple(const SplatCutView& v)
{
  return std::make_tuple(v.Eye, v.Pixel, v.ToWorld);
}
}

SplatCutView FindCutView(const ViewState& state, vtkMatrix4x4* modelToWorld, int pixelsHigh)
{
  const double perUnit = std::abs(state.ViewToDevice->GetElement(1, 1)) * pixelsHigh / 2;
  return { state.EyeModel, 1 / perUnit, LinearPart(modelToWorld) };
}

void SplatHierarchy::Invalidate()
{
  *this = SplatHierarchy();
}

bool SplatHierarchy::Update(const SplatSamples& samples, const SplatClasses& classes,
  SplatVectorScene& vectors, const std::string& vectorArrayName)
{
  if (!this->Nodes.IsEmpty() && vectorArrayName == this->VectorArrayName)
  {
    return false;
  }
  this->VectorArrayName = vectorArrayName;
  this->Build(samples, classes,
    vectorArrayName.empty() ? std::vector<std::array<float, 4>>()
                            : vectors.GetVectors().Pack(classes, {}));
  return true;
}

void SplatHierarchy::Build(const SplatSamples& samples, const SplatClasses& classes,
  const std::vector<std::array<float, 4>>& vectors)
{
  this->Nodes.Build(samples, classes, vectors);
  this->Places.clear();
  this->Places.reserve(this->Nodes.Leaves() + this->Nodes.Nodes().size());
  for (const std::int32_t sample : classes.Samples)
  {
    this->Places.push_back(samples.Positions[static_cast<std::size_t>(sample)]);
  }
  for (const SplatTreeNode& node : this->Nodes.Nodes())
  {
    this->Places.push_back(node.Position);
  }
  this->Selected = false;
}

bool SplatHierarchy::Select(const SplatSamples& samples, const SplatClasses& classes,
  const SplatErrorRule& errors, const SplatCutRule& rule, const SplatCutView& view)
{
  const bool sameErrors = this->Selected && AsTuple(errors) == AsTuple(this->LastErrors) &&
    AsTuple(view) == AsTuple(this->LastView);
  if (sameErrors && AsTuple(rule) == AsTuple(this->LastRule))
  {
    return false;
  }
  if (!this->Nodes.IsEmpty())
  {
    if (!sameErrors)
    {
      this->Errors = FindSplatErrors(this->Nodes, samples, classes, errors, view);
    }
    this->Drawn = CutSplatTree(this->Nodes, this->Errors, rule);
  }
  this->LastErrors = errors;
  this->LastRule = rule;
  this->LastView = view;
  this->Selected = true;
  return true;
}

double SplatHierarchy::LongestDrawn(const SplatSamples& samples) const
{
  double longest = samples.LongestEdge;
  for (const std::int32_t splat : this->Drawn.Splats)
  {
    if (!this->Nodes.IsLeaf(splat))
    {
      longest = std::max<double>(longest, this->Nodes.Node(splat).LongestEdge);
    }
  }
  return longest;
}

} // namespace nephoscope
