// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatTree.h"

#include "MortonCode.h"
#include "SplatClasses.h"
#include "SplatSamples.h"
#include "SplatSummary.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
constexpr double flatShare = 0.02; // of the longest edge, as for samples
constexpr double straight = 1e-4;  // cells: bends below it are rounding

template <typename Body>
void forAll(std::size_t count, Body body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      body(static_cast<std::size_t>(i));
    }
  });
}

SplatVector toDouble(const std::array<float, 3>& v)
{
  return { { v[0], v[1], v[2] } };
}

std::array<float, 3> toFloat(const SplatVector& v)
{
  return { { static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]) } };
}

// The greatest singular value, by power iteration on J J^T from above: its trace bounds it.
double longestAxis(const SplatMatrix& j)
{
  SplatVector v = { { 0.61, 0.55, 0.57 } };
  double longest = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    const SplatVector rows = { { Dot(j[0], v), Dot(j[1], v), Dot(j[2], v) } };
    v = Times(j, rows);
    longest = Length(v);
    for (double& e : v)
    {
      e /= longest > 0.0 ? longest : 1.0;
    }
  }
  return std::sqrt(longest);
}
}

/** Merges neighbours in the order of their codes, level by level, until one is left. */
class SplatTreeBuilder
{
public:
  SplatTreeBuilder(SplatTree& tree, const SplatSamples& samples, const SplatClasses& classes,
    const std::vector<std::array<float, 4>>& vectors)
    : Tree(tree)
    , Samples(samples)
    , Classes(classes)
    , Vectors(vectors)
    , OnLattice(samples.Dimensions[0] > 0)
  {
  }

  void Build()
  {
    this->Tree.Clear();
    this->Tree.LeafCount = this->Classes.Samples.size();
    if (this->Tree.IsEmpty())
    {
      return;
    }
    this->FindLeaves();
    for (int level = 0; level <= mortonLevels && this->Items.size() > 1; ++level)
    {
      this->Merge(level);
    }
    this->Tree.RootNumber = this->Items[0].Splat;
  }

private:
  struct Item
  {
    std::uint64_t Code;
    std::int32_t Splat;
  };

  // Neighbours in one block: [Begin, next group's Begin).
  struct Group
  {
    std::uint32_t Begin;
    std::uint32_t Size;
  };

  std::size_t SampleOf(std::int32_t leaf) const
  {
    return static_cast<std::size_t>(this->Classes.Samples[static_cast<std::size_t>(leaf)]);
  }

  MortonIndex LatticeIndex(std::int32_t leaf) const
  {
    const auto nx = this->Samples.Dimensions[0], ny = this->Samples.Dimensions[1];
    const vtkIdType id = this->Samples.Ids[this->SampleOf(leaf)];
    return { { static_cast<std::uint32_t>(id % nx), static_cast<std::uint32_t>(id / nx % ny),
      static_cast<std::uint32_t>(id / nx / ny) } };
  }

  // Cubic blocks around the leaves.
  void FindSpace()
  {
    SplatVector high{};
    this->Corner.fill(std::numeric_limits<double>::infinity());
    high.fill(-this->Corner[0]);
    for (const std::int32_t sample : this->Classes.Samples)
    {
      const auto& p = this->Samples.Positions[static_cast<std::size_t>(sample)];
      for (std::size_t c = 0; c < 3; ++c)
      {
        this->Corner[c] = std::min<double>(this->Corner[c], p[c]);
        high[c] = std::max<double>(high[c], p[c]);
      }
    }
    double edge = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      edge = std::max(edge, high[c] - this->Corner[c]);
    }
    this->BlocksPerLength = edge > 0.0 ? ((1 << mortonLevels) - 1) / edge : 0.0;
  }

  MortonIndex SpaceIndex(std::int32_t leaf) const
  {
    const auto& p = this->Samples.Positions[this->SampleOf(leaf)];
    MortonIndex index;
    for (std::size_t c = 0; c < 3; ++c)
    {
      index[c] = static_cast<std::uint32_t>((p[c] - this->Corner[c]) * this->BlocksPerLength);
    }
    return index;
  }

  void FindLeaves()
  {
    if (!this->OnLattice)
    {
      this->FindSpace();
    }
    this->Items.resize(this->Tree.LeafCount);
    forAll(this->Items.size(), [&](std::size_t i) {
      const auto leaf = static_cast<std::int32_t>(i);
      this->Items[i] = { MortonCode(this->OnLattice ? this->LatticeIndex(leaf) : this->SpaceIndex(leaf)), leaf };
    });
    vtkSMPTools::Sort(this->Items.begin(), this->Items.end(), [](const Item& a, const Item& b) {
      return a.Code != b.Code ? a.Code < b.Code : a.Splat < b.Splat;
    });
  }

  SplatVector VectorOf(std::int32_t leaf) const
  {
    if (this->Vectors.empty())
    {
      return {};
    }
    const auto& v = this->Vectors[static_cast<std::size_t>(leaf)];
    return { { v[0], v[1], v[2] } };
  }

  SplatBranch BranchOf(const Item& item) const
  {
    if (!this->Tree.IsLeaf(item.Splat))
    {
      return this->Branches[static_cast<std::size_t>(item.Splat) - this->Tree.LeafCount];
    }
    const std::size_t sample = this->SampleOf(item.Splat);
    const auto& color = this->Classes.Colors[static_cast<std::size_t>(item.Splat)];
    const auto& j = this->Samples.JacobianOf(sample);
    const MortonIndex index = IndexOfMortonCode(item.Code);
    return BranchOfLeaf({ { color[0], color[1], color[2], color[3] } },
      this->VectorOf(item.Splat),
      toDouble(this->Samples.Positions[sample]), { { toDouble(j[0]), toDouble(j[1]), toDouble(j[2]) } },
      { { double(index[0]), double(index[1]), double(index[2]) } });
  }

  SplatBlock BlockOf(std::uint64_t code, int level) const
  {
    const MortonIndex index = IndexOfMortonCode(code >> (3 * level) << (3 * level));
    SplatBlock block;
    for (std::size_t c = 0; c < 3; ++c)
    {
      block.First[c] = index[c];
      block.Size[c] = std::min<double>(1u << level, this->Samples.Dimensions[c] - block.First[c]);
    }
    return block;
  }

  // How far the nodes below are from their places on a straight lattice.
  SplatVector BendOf(const SplatBranch& branch, const SplatBlock& block, const Group& group) const
  {
    const SplatMatrix toCells = Inverse(WithoutFlatColumns(branch.Jacobian, flatShare));
    const SplatVector center = PlaceOfBlock(branch, block);
    SplatVector bend{};
    for (std::uint32_t i = group.Begin; i < group.Begin + group.Size; ++i)
    {
      const SplatBranch child = this->BranchOf(this->Items[i]);
      const SplatVector apart = Times(toCells, Minus(child.Place, center));
      const SplatVector expected = Minus(child.Index, block.Center());
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double off = std::abs(apart[c] - expected[c]);
        bend[c] = std::max(bend[c], (off > straight ? off : 0.0) + child.Bend[c]);
      }
    }
    return bend;
  }

  void MakeNode(const Group& group, int level, std::size_t number, std::uint32_t firstChild)
  {
    SplatBranch branch;
    for (std::uint32_t i = 0; i < group.Size; ++i)
    {
      const Item& item = this->Items[group.Begin + i];
      branch = Join(branch, this->BranchOf(item));
      this->Tree.Children[firstChild + i] = item.Splat;
    }
    SplatSummary splat;
    if (this->OnLattice)
    {
      const SplatBlock block = this->BlockOf(this->Items[group.Begin].Code, level);
      branch.Bend = this->BendOf(branch, block, group);
      splat = SummarizeLattice(branch, block, flatShare);
    }
    else
    {
      splat = SummarizeScattered(branch);
    }
    this->Branches[number] = branch;
    SplatTreeNode& node = this->Tree.NodeList[number];
    node.Position = toFloat(splat.Place);
    for (std::size_t c = 0; c < 3; ++c)
    {
      node.Jacobian[c] = toFloat(splat.Jacobian[c]);
      node.Color[c] = static_cast<float>(splat.Color[c]);
    }
    node.Color[3] = static_cast<float>(splat.Extinction);
    node.Vector = toFloat(splat.Vector);
    node.GreatestError = static_cast<float>(splat.GreatestError);
    node.RootMeanSquareError = static_cast<float>(splat.RootMeanSquareError);
    node.GreatestVectorError = static_cast<float>(splat.GreatestVectorError);
    node.RootMeanSquareVectorError = static_cast<float>(splat.RootMeanSquareVectorError);
    node.LongestEdge = static_cast<float>(longestAxis(splat.Jacobian));
    node.Span = static_cast<float>(splat.Span);
    node.FirstChild = firstChild;
  }

  std::vector<Group> FindGroups(int level) const
  {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      if (i > 0 && (this->Items[i].Code >> (3 * level)) == (this->Items[i - 1].Code >> (3 * level)))
      {
        ++groups.back().Size;
      }
      else
      {
        groups.push_back({ static_cast<std::uint32_t>(i), 1 });
      }
    }
    return groups;
  }

  void Merge(int level)
  {
    const std::vector<Group> groups = this->FindGroups(level);
    if (groups.size() == this->Items.size())
    {
      return;
    }
    // The numbers of new nodes and of their children.
    std::vector<std::uint32_t> numbers(groups.size()), firstChildren(groups.size());
    std::size_t nodes = this->Branches.size(), children = this->Tree.Children.size();
    for (std::size_t g = 0; g < groups.size(); ++g)
    {
      numbers[g] = static_cast<std::uint32_t>(nodes);
      firstChildren[g] = static_cast<std::uint32_t>(children);
      nodes += groups[g].Size > 1 ? 1 : 0;
      children += groups[g].Size > 1 ? groups[g].Size : 0;
    }
    this->Branches.resize(nodes);
    this->Tree.NodeList.resize(nodes);
    this->Tree.Children.resize(children);
    std::vector<Item> merged(groups.size());
    forAll(groups.size(), [&](std::size_t g) {
      merged[g] = this->Items[groups[g].Begin];
      if (groups[g].Size > 1)
      {
        this->MakeNode(groups[g], level, numbers[g], firstChildren[g]);
        merged[g].Splat = static_cast<std::int32_t>(this->Tree.LeafCount + numbers[g]);
      }
    });
    this->Items.swap(merged);
  }

  SplatTree& Tree;
  const SplatSamples& Samples;
  const SplatClasses& Classes;
  const std::vector<std::array<float, 4>>& Vectors;
  const bool OnLattice;
  SplatVector Corner{};
  double BlocksPerLength = 0.0;
  std::vector<Item> Items;
  std::vector<SplatBranch> Branches; // of the nodes
};

void SplatTree::Build(const SplatSamples& samples, const SplatClasses& classes,
  const std::vector<std::array<float, 4>>& vectors)
{
  SplatTreeBuilder(*this, samples, classes, vectors).Build();
}

void SplatTree::AppendColors(std::vector<std::array<float, 4>>& colors) const
{
  for (const SplatTreeNode& node : this->NodeList)
  {
    const auto count = static_cast<float>(this->EndChildren(node) - this->BeginChildren(node));
    std::array<float, 4> mean{ { 0, 0, 0, colors[static_cast<std::size_t>(*this->BeginChildren(node))][3] } };
    for (const std::int32_t* child = this->BeginChildren(node); child != this->EndChildren(node); ++child)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        mean[c] += colors[static_cast<std::size_t>(*child)][c] / count;
      }
    }
    colors.push_back(mean);
  }
}

void SplatTree::AppendVectors(std::vector<std::array<float, 4>>& vectors) const
{
  for (const SplatTreeNode& node : this->NodeList)
  {
    const float phase = vectors[static_cast<std::size_t>(*this->BeginChildren(node))][3];
    vectors.push_back({ { node.Vector[0], node.Vector[1], node.Vector[2], phase } });
  }
}

} // namespace nephoscope
