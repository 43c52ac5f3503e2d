// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatCut.h"

#include "SplatMatrix.h"
#include "SplatTree.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double aroundEye = 1.3; // of the kernel's reach: the eye is in it, or it fills the view

SplatVector toDouble(const std::array<float, 3>& v)
{
  return { { v[0], v[1], v[2] } };
}

// The length of a ray of this direction (of any length) in a cell: 1 / |J^-1 e|.
double thickness(const SplatMatrix& j, const SplatVector& direction)
{
  const SplatVector rows[3] = { Cross(j[1], j[2]), Cross(j[2], j[0]), Cross(j[0], j[1]) };
  const SplatVector cells = { { Dot(rows[0], direction), Dot(rows[1], direction), Dot(rows[2], direction) } };
  return std::abs(Dot(j[0], rows[0])) * Length(direction) / Length(cells);
}

struct Range
{
  std::uint32_t Begin, End;
};

/** Selects nodes of a tree by a test that says which to go below. */
template <typename GoesBelow>
class Descent
{
public:
  Descent(const SplatTree& tree, GoesBelow goesBelow)
    : Tree(tree)
    , Below(goesBelow)
  {
  }

  std::vector<std::int32_t> Find() const
  {
    std::vector<std::int32_t> front{ this->Tree.Root() };
    while (front.size() < enoughParts && this->Widen(front))
    {
    }
    std::vector<std::vector<std::int32_t>> parts(front.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(front.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto part = static_cast<std::size_t>(i);
        this->Descend(front[part], parts[part]);
      }
    });
    std::vector<std::int32_t> cut;
    for (const auto& part : parts)
    {
      cut.insert(cut.end(), part.begin(), part.end());
    }
    return cut;
  }

private:
  static constexpr std::size_t enoughParts = 256;

  bool GoBelow(std::int32_t splat) const
  {
    return !this->Tree.IsLeaf(splat) && this->Below(this->Tree.Node(splat));
  }

  // Replaces those that are not drawn by their children; false if there were none.
  bool Widen(std::vector<std::int32_t>& front) const
  {
    std::vector<std::int32_t> wider;
    for (const std::int32_t splat : front)
    {
      if (this->GoBelow(splat))
      {
        const SplatTreeNode& node = this->Tree.Node(splat);
        wider.insert(wider.end(), this->Tree.BeginChildren(node), this->Tree.EndChildren(node));
      }
      else
      {
        wider.push_back(splat);
      }
    }
    const bool changed = wider.size() != front.size();
    front.swap(wider);
    return changed;
  }

  void Descend(std::int32_t splat, std::vector<std::int32_t>& cut) const
  {
    if (!this->GoBelow(splat))
    {
      cut.push_back(splat);
      return;
    }
    const SplatTreeNode& node = this->Tree.Node(splat);
    for (const std::int32_t* child = this->Tree.BeginChildren(node); child != this->Tree.EndChildren(node); ++child)
    {
      this->Descend(*child, cut);
    }
  }

  const SplatTree& Tree;
  GoesBelow Below;
};

template <typename GoesBelow>
std::vector<std::int32_t> descend(const SplatTree& tree, GoesBelow goesBelow)
{
  return Descent<GoesBelow>(tree, goesBelow).Find();
}

/** The least tolerance that leaves no more than so many splats. */
class Budget
{
public:
  Budget(const SplatTree& tree, const SplatCutRule& rule, const SplatCutView& view)
    : Tree(tree)
  {
    this->FindErrors(rule, view);
  }

  // Errors, ascending as floats do, are counted by their bits in two steps.
  float Tolerance(std::size_t most) const
  {
    const std::uint32_t high = this->FirstThatFits(most, [](std::uint32_t bits) { return bits >> 16; });
    const std::uint32_t bits = this->FirstThatFits(most, [&](std::uint32_t b) {
      return (b >> 16) == high ? b & 0xffffu : ((b >> 16) < high ? 0u : 0xffffu);
    });
    const std::uint32_t all = high << 16 | bits;
    float tolerance;
    std::memcpy(&tolerance, &all, sizeof(tolerance));
    return std::min(tolerance, std::numeric_limits<float>::max()); // nodes of infinite error cannot be drawn
  }

private:
  // The least error on the way to each node: it is gone below if that is above the tolerance. Parents stand behind their children.
  void FindErrors(const SplatCutRule& rule, const SplatCutView& view)
  {
    const auto& nodes = this->Tree.Nodes();
    this->Errors.resize(nodes.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(nodes.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto n = static_cast<std::size_t>(i);
        this->Errors[n] = SplatError(nodes[n], rule, view);
      }
    });
    for (std::size_t n = nodes.size(); n-- > 0;)
    {
      for (const std::int32_t* c = this->Tree.BeginChildren(nodes[n]); c != this->Tree.EndChildren(nodes[n]); ++c)
      {
        if (!this->Tree.IsLeaf(*c))
        {
          float& below = this->Errors[static_cast<std::size_t>(*c) - this->Tree.Leaves()];
          below = std::min(below, this->Errors[n]);
        }
      }
    }
  }

  template <typename Digit>
  std::uint32_t FirstThatFits(std::size_t most, Digit digitOf) const
  {
    std::vector<std::size_t> added(1 << 16, 0); // splats more by going below nodes of this error
    for (std::size_t n = 0; n < this->Errors.size(); ++n)
    {
      std::uint32_t bits;
      std::memcpy(&bits, &this->Errors[n], sizeof(bits));
      const SplatTreeNode& node = this->Tree.Nodes()[n];
      added[digitOf(bits)] +=
        static_cast<std::size_t>(this->Tree.EndChildren(node) - this->Tree.BeginChildren(node)) - 1;
    }
    std::size_t splats = 1;
    for (std::uint32_t digit = 0xffff; digit > 0; --digit)
    {
      splats += added[digit];
      if (splats > most)
      {
        return digit;
      }
    }
    return 0;
  }

  const SplatTree& Tree;
  std::vector<float> Errors;
};
}

float SplatError(const SplatTreeNode& node, const SplatCutRule& rule, const SplatCutView& view)
{
  const double error = rule.RootMeanSquare ? node.RootMeanSquareError : node.GreatestError;
  const double vector = rule.RootMeanSquare ? node.RootMeanSquareVectorError : node.GreatestVectorError;
  if (std::isinf(error))
  {
    return infinity;
  }
  SplatVector ray = { { view.Eye[0], view.Eye[1], view.Eye[2] } };
  const double reach = rule.KernelRadius * node.LongestEdge;
  double pixel = view.Pixel;
  if (view.Eye[3] != 0)
  {
    ray = Minus(toDouble(node.Position), ray);
    const double distance = Length(ray);
    if (distance < aroundEye * reach)
    {
      return infinity;
    }
    pixel *= distance;
  }
  if (reach < pixel)
  {
    return 0.0f;
  }
  double sum = rule.Vector * vector;
  if (rule.OfImage)
  {
    const SplatMatrix j = { { toDouble(node.Jacobian[0]), toDouble(node.Jacobian[1]), toDouble(node.Jacobian[2]) } };
    sum = sum * node.Span + rule.Extinction * error * thickness(j, ray);
  }
  else
  {
    sum = std::max(sum, rule.Extinction * error);
  }
  return static_cast<float>(sum);
}

std::vector<std::int32_t> CutSplatTree(
  const SplatTree& tree, const SplatCutRule& rule, const SplatCutView& view, double* tolerance)
{
  std::vector<std::int32_t> cut = descend(
    tree, [&](const SplatTreeNode& node) { return SplatError(node, rule, view) > rule.Tolerance; });
  if (tolerance)
  {
    *tolerance = rule.Tolerance;
  }
  if (rule.MostSplats > 0 && cut.size() > rule.MostSplats)
  {
    const float least = Budget(tree, rule, view).Tolerance(rule.MostSplats);
    cut = descend(tree, [&](const SplatTreeNode& node) { return SplatError(node, rule, view) > least; });
    if (tolerance)
    {
      *tolerance = least;
    }
  }
  return cut;
}

} // namespace nephoscope
