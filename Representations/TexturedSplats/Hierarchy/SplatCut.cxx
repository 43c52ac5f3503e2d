// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatCut.h"

#include "SplatTree.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
struct Part
{
  std::int32_t Splat;
  float Weight;
};

/**
 * Selects nodes of a tree by a test that says how much of each is drawn instead of what lies below.
 */
class Descent
{
public:
  Descent(const SplatTree& tree, const std::vector<float>& errors, double tolerance, double blend)
    : Tree(tree)
    , Errors(errors)
    , Tolerance(tolerance)
    , Full((1 - blend) * tolerance)
  {
  }

  SplatCut Find() const
  {
    // What is drawn in the front stays there; the others are looked into in parallel.
    std::vector<Part> front{ { this->Tree.Root(), 1.0f } };
    while (front.size() < enoughParts && this->Widen(front))
    {
    }
    std::vector<std::vector<Part>> parts(front.size());
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(front.size()), 1, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto part = static_cast<std::size_t>(i);
          this->Descend(front[part], parts[part]);
        }
      });
    SplatCut cut;
    cut.Tolerance = this->Tolerance;
    for (const auto& part : parts)
    {
      for (const Part& item : part)
      {
        cut.Splats.push_back(item.Splat);
        cut.Weights.push_back(item.Weight);
      }
    }
    if (std::all_of(cut.Weights.begin(), cut.Weights.end(), [](float w) { return w == 1.0f; }))
    {
      cut.Weights.clear();
    }
    return cut;
  }

private:
  static constexpr std::size_t enoughParts = 256;

  // The share of a splat that is reached: 0 to 1.
  float ShareOf(std::int32_t splat) const
  {
    if (this->Tree.IsLeaf(splat))
    {
      return 1.0f;
    }
    const double error = this->Errors[static_cast<std::size_t>(splat) - this->Tree.Leaves()];
    if (error <= this->Full)
    {
      return 1.0f;
    }
    if (error >= this->Tolerance)
    {
      return 0.0f;
    }
    const double share = (this->Tolerance - error) / (this->Tolerance - this->Full);
    return static_cast<float>(share * share * (3 - 2 * share));
  }

  template <typename Draw, typename Descend>
  void Divide(const Part& item, Draw draw, Descend descend) const
  {
    const float share = this->ShareOf(item.Splat);
    if (share > 0.0f)
    {
      draw(Part{ item.Splat, item.Weight * share });
    }
    if (share < 1.0f)
    {
      const SplatTreeNode& node = this->Tree.Node(item.Splat);
      for (const std::int32_t* c = this->Tree.BeginChildren(node);
           c != this->Tree.EndChildren(node); ++c)
      {
        descend(Part{ *c, item.Weight * (1.0f - share) });
      }
    }
  }

  // Replaces those that are not drawn at all by their children; false if there were none.
  bool Widen(std::vector<Part>& front) const
  {
    std::vector<Part> wider;
    bool changed = false;
    for (const Part& item : front)
    {
      if (this->ShareOf(item.Splat) > 0.0f)
      {
        wider.push_back(item);
        continue;
      }
      changed = true;
      this->Divide(
        item, [](const Part&) {}, [&](const Part& child) { wider.push_back(child); });
    }
    front.swap(wider);
    return changed;
  }

  void Descend(const Part& item, std::vector<Part>& cut) const
  {
    this->Divide(
      item, [&](const Part& part) { cut.push_back(part); },
      [&](const Part& child) { this->Descend(child, cut); });
  }

  const SplatTree& Tree;
  const std::vector<float>& Errors;
  double Tolerance, Full;
};

/**
 * The least tolerance that leaves no more than so many splats. A node is gone below if the least
 * error on the way to it, its own included, is above `full` = (1 - blend) tolerance, and is drawn
 * all the same if its own is below the tolerance.
 */
double FindTolerance(
  const SplatTree& tree, const std::vector<float>& errors, double blend, std::size_t most)
{
  struct Step
  {
    float Error;
    std::uint32_t Children;
  };
  const auto& nodes = tree.Nodes();
  std::vector<Step> steps(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;) // parents stand behind their children
  {
    steps[n].Error = n + 1 == nodes.size() ? errors[n] : std::min(errors[n], steps[n].Error);
    steps[n].Children =
      static_cast<std::uint32_t>(tree.EndChildren(nodes[n]) - tree.BeginChildren(nodes[n]));
    for (const std::int32_t* c = tree.BeginChildren(nodes[n]); c != tree.EndChildren(nodes[n]); ++c)
    {
      if (!tree.IsLeaf(*c))
      {
        steps[static_cast<std::size_t>(*c) - tree.Leaves()].Error = steps[n].Error;
      }
    }
  }
  vtkSMPTools::Sort(
    steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.Error > b.Error; });
  // With `full` at the error of a step those before it are gone below, and of those the ones within
  // the tolerance are drawn too.
  constexpr double rounding = 1e-9;
  const auto toleranceAt = [&](std::size_t i) {
    return steps[i].Error / (1 - blend) * (1 + rounding);
  };
  double tolerance = std::numeric_limits<float>::max(); // nodes of infinite error cannot be drawn
  std::size_t splats = 1, first = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const bool next = i == 0 || steps[i].Error < steps[i - 1].Error;
    if (next && std::isfinite(steps[i].Error))
    {
      while (first < i && steps[first].Error >= toleranceAt(i))
      {
        ++first;
      }
      if (splats + (i - first) > most)
      {
        return tolerance;
      }
      tolerance = toleranceAt(i);
    }
    splats += steps[i].Children - 1;
  }
  return splats <= most ? 0 : tolerance;
}
}

SplatCut CutSplatTree(
  const SplatTree& tree, const std::vector<float>& errors, const SplatCutRule& rule)
{
  SplatCut cut = Descent(tree, errors, rule.Tolerance, rule.Blend).Find();
  if (rule.MostSplats > 0 && cut.Splats.size() > rule.MostSplats)
  {
    const double least =
      std::max(rule.Tolerance, FindTolerance(tree, errors, rule.Blend, rule.MostSplats));
    cut = Descent(tree, errors, least, rule.Blend).Find();
  }
  return cut;
}

} // namespace nephoscope
