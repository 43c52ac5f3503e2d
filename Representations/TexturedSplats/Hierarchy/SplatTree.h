// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The hierarchy of splats (LaurHanrahan1991): a tree whose nodes are splats that represent
 * everything below them, with the same mass, emission, centre of mass and covariance.
 *
 * On a structured grid nodes are blocks of samples in its indices: of 2^l to a side, or, where its
 * cells are flat, of about equal edges in the world (BlockOrder.h). Elsewhere they are blocks of
 * space. Blocks with one visible sample are that sample. Leaves are numbered as the splats of the
 * classes, nodes follow them.
 *
 * It is the same whatever the number of threads and the order of the input. Memory: 104 bytes for
 * each node and 4 for each leaf; a full grid has a node for 7 leaves, one of flat cells one for
 * each. While it is built: 400 bytes for each node, 32 for each leaf.
 */
#ifndef nephoscope_SplatTree_h
#define nephoscope_SplatTree_h

#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

struct SplatClasses;
struct SplatSamples;

struct SplatTreeNode
{
  using Float3 = std::array<float, 3>;

  Float3 Position;
  std::array<Float3, 3> Jacobian; // columns
  std::array<float, 4> Color;     // and extinction
  Float3 Vector;
  // Deviations of extinction (or emission) and of vectors below; infinite if the node cannot be
  // drawn.
  float GreatestError, RootMeanSquareError;
  float GreatestVectorError, RootMeanSquareVectorError;
  float LongestEdge; // the longest half axis of the kernel over its radius
  float Span;        // edge in those of the leaves
  std::uint32_t
    FirstChild; // of the tree's list of children, which goes on to that of the next node
};

class SplatTree
{
public:
  /** `vectors`: (x, y, z, anything) of every splat of the classes; empty if there are none. */
  void Build(const SplatSamples& samples, const SplatClasses& classes,
    const std::vector<std::array<float, 4>>& vectors);
  void Clear() { *this = SplatTree(); }

  bool IsEmpty() const { return this->LeafCount == 0; }
  std::size_t Leaves() const { return this->LeafCount; }
  const std::vector<SplatTreeNode>& Nodes() const
  {
    return this->NodeList;
  } ///< children before their parents
  std::int32_t Root() const { return this->RootNumber; }

  bool IsLeaf(std::int32_t splat) const
  {
    return static_cast<std::size_t>(splat) < this->LeafCount;
  }
  const SplatTreeNode& Node(std::int32_t splat) const
  {
    return this->NodeList[static_cast<std::size_t>(splat) - this->LeafCount];
  }
  const std::int32_t* BeginChildren(const SplatTreeNode& node) const
  {
    return this->Children.data() + node.FirstChild;
  }
  const std::int32_t* EndChildren(const SplatTreeNode& node) const
  {
    const bool last = &node == &this->NodeList.back();
    return this->Children.data() + (last ? this->Children.size() : (&node)[1].FirstChild);
  }

  /**
   * To (red, green, blue, seed) of the leaves those of the nodes: the mean colour of their
   * children, and the seed of the first.
   */
  void AppendColors(std::vector<std::array<float, 4>>& colors) const;
  /**
   * To (x, y, z, phase) of the leaves those of the nodes: their mean vector, and the phase of their
   * first child. If patterns of speed 1 have moved by `periodsPerSpeed`, a node has moved at its
   * own speed.
   */
  void AppendVectors(
    std::vector<std::array<float, 4>>& vectors, double periodsPerSpeed = 0.0) const;

private:
  friend class SplatTreeBuilder;
  std::size_t LeafCount = 0;
  std::int32_t RootNumber = 0;
  std::vector<SplatTreeNode> NodeList;
  std::vector<std::int32_t> Children;
};

} // namespace nephoscope

#endif
