// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatTree.h"

#include "BlockOrder.h"
#include "OwnThreads.h"
#include "SplatBlocks.h"
#include "SplatClasses.h"
#include "SplatSamples.h"
#include "SplatSummary.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
std::array<float, 3> ToFloat(const Vector3& v)
{
  return { { static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]) } };
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
    , ByVolume(!vectors.empty())
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
    for (int level = 0; level < this->Blocks.GetNumberOfLevels() && this->Items.size() > 1; ++level)
    {
      this->Merge(level);
    }
    while (this->Items.size() > 1) // samples in one place, too many for one node at every level
    {
      this->Merge(this->Blocks.GetNumberOfLevels() - 1);
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

  void FindLeaves()
  {
    const SplatBlocks blocks(this->Samples, this->Classes);
    this->Blocks = blocks.GetOrder();
    this->Items.resize(this->Tree.LeafCount);
    ForAll(this->Items.size(), [&](std::size_t i) {
      const auto leaf = static_cast<std::int32_t>(i);
      this->Items[i] = { this->Blocks.CodeOf(blocks.IndexOf(this->SampleOf(leaf))), leaf };
    });
    vtkSMPTools::Sort(this->Items.begin(), this->Items.end(), [](const Item& a, const Item& b) {
      return a.Code != b.Code ? a.Code < b.Code : a.Splat < b.Splat;
    });
  }

  Vector3 VectorOf(std::int32_t leaf) const
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
    const double share = std::max(this->Samples.ShareOf(sample), 1e-6f); // in the extinction
    return BranchOfLeaf({ { color[0], color[1], color[2], color[3] / share } },
      this->VectorOf(item.Splat), ToDouble(this->Samples.Positions[sample]), ToDouble(j), share,
      this->ByVolume);
  }

  void MakeNode(const Group& group, std::size_t number, std::uint32_t firstChild)
  {
    SplatBranch branch;
    std::vector<SplatBranch> below;
    for (std::uint32_t i = 0; i < group.Size; ++i)
    {
      const Item& item = this->Items[group.Begin + i];
      below.push_back(this->BranchOf(item));
      branch = Join(branch, below.back());
      this->Tree.Children[firstChild + i] = item.Splat;
    }
    const SplatSummary splat = Summarize(branch, below.begin(), below.end());
    this->Branches[number] = branch;
    SplatTreeNode& node = this->Tree.NodeList[number];
    node.Position = ToFloat(splat.Place);
    for (std::size_t c = 0; c < 3; ++c)
    {
      node.Jacobian[c] = ToFloat(splat.Jacobian[c]);
      node.Color[c] = static_cast<float>(splat.Color[c]);
    }
    node.Color[3] = static_cast<float>(splat.Extinction);
    node.Vector = ToFloat(splat.Vector);
    node.GreatestError = static_cast<float>(splat.GreatestError);
    node.RootMeanSquareError = static_cast<float>(splat.RootMeanSquareError);
    node.GreatestVectorError = static_cast<float>(splat.GreatestVectorError);
    node.RootMeanSquareVectorError = static_cast<float>(splat.RootMeanSquareVectorError);
    node.LongestEdge = static_cast<float>(LargestStretch(splat.Jacobian));
    node.Span = static_cast<float>(splat.Span);
    node.FirstChild = firstChild;
  }

  std::vector<Group> FindGroups(int level) const
  {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      // More than eight are samples in one place: the error of a node costs the square of their
      // number.
      if (i > 0 && groups.back().Size < 8 &&
        this->Blocks.BlockOf(this->Items[i].Code, level) ==
          this->Blocks.BlockOf(this->Items[i - 1].Code, level))
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
    ForAll(groups.size(), [&](std::size_t g) {
      merged[g] = this->Items[groups[g].Begin];
      if (groups[g].Size > 1)
      {
        this->MakeNode(groups[g], numbers[g], firstChildren[g]);
        merged[g].Splat = static_cast<std::int32_t>(this->Tree.LeafCount + numbers[g]);
      }
    });
    this->Items.swap(merged);
  }

  SplatTree& Tree;
  const SplatSamples& Samples;
  const SplatClasses& Classes;
  const std::vector<std::array<float, 4>>& Vectors;
  const bool ByVolume; // nodes are where their samples are, and not only the medium of those:
                       // vectors are there too
  BlockOrder Blocks{ { { 1, 1, 1 } }, { { 1.0, 1.0, 1.0 } } };
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
    std::array<float, 4> mean{ { 0, 0, 0,
      colors[static_cast<std::size_t>(*this->BeginChildren(node))][3] } };
    for (const std::int32_t* child = this->BeginChildren(node); child != this->EndChildren(node);
         ++child)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        mean[c] += colors[static_cast<std::size_t>(*child)][c] / count;
      }
    }
    colors.push_back(mean);
  }
}

void SplatTree::AppendVectors(
  std::vector<std::array<float, 4>>& vectors, double periodsPerSpeed) const
{
  const auto speed = [](const auto& v) { return std::hypot(v[0], v[1], v[2]); };
  for (const SplatTreeNode& node : this->NodeList)
  {
    const std::array<float, 4>& child =
      vectors[static_cast<std::size_t>(*this->BeginChildren(node))];
    const double phase = child[3] + (speed(node.Vector) - speed(child)) * periodsPerSpeed;
    vectors.push_back({ { node.Vector[0], node.Vector[1], node.Vector[2],
      static_cast<float>(phase - std::floor(phase)) } });
  }
}

} // namespace nephoscope
