// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Strongly connected components of a relation, in topological order, without recursion (Pearce2016, after Tarjan1972).
 *
 * Where the relation is "is behind", an order can place a tetrahedron that is a component by itself; in a greater component each
 * tetrahedron hides another and is hidden itself.
 */
#ifndef StrongComponents_h
#define StrongComponents_h

#include "ProgressLoop.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace nephoscope
{

class StrongComponents
{
public:
  /**
   * next(node, cursor) returns the next node that must come before `node`, or -1; `cursor` starts at 0 and is next's own.
   * emit(begin, end) takes the nodes of a component; those that must come before them have been emitted. False when stopped.
   */
  template <typename Next, typename Emit>
  bool Find(std::size_t n, const Progress& progress, Next next, Emit emit)
  {
    this->Rank.assign(n, 0);
    this->Index = 1;
    this->Component = static_cast<std::uint32_t>(-1);
    this->Steps = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (this->Rank[i] == 0 && !this->Visit(static_cast<std::int32_t>(i), next, emit, progress))
      {
        return false;
      }
    }
    return progress.Report(1);
  }

  /** After Find: equal for two nodes of one component, different for others. */
  std::uint32_t GetComponent(std::int32_t node) const
  {
    return this->Rank[static_cast<std::size_t>(node)];
  }

private:
  struct Step
  {
    std::int32_t Node;
    std::int32_t Cursor;
    std::uint32_t OwnRank; // Rank falls below it where the node is not the first of its component
  };
  std::vector<std::uint32_t>
    Rank; // 0: not visited; then the least index reached; then, from above, the component
  std::vector<Step> Path;
  std::vector<std::int32_t> Open; // visited, component not complete
  std::uint32_t Index = 1, Component = 0;
  std::size_t Steps = 0;

  std::uint32_t& RankOf(std::int32_t node) { return this->Rank[static_cast<std::size_t>(node)]; }

  void Begin(std::int32_t node)
  {
    this->RankOf(node) = this->Index;
    this->Path.push_back({ node, 0, this->Index++ });
  }

  template <typename Next, typename Emit>
  bool Visit(std::int32_t root, Next& next, Emit& emit, const Progress& progress)
  {
    this->Begin(root);
    while (!this->Path.empty())
    {
      if ((++this->Steps & 0x3ffff) == 0 && // some 10 ms; a node takes about four steps
        !progress.Report(std::min(1.0, 0.25 * double(this->Steps) / double(this->Rank.size()))))
      {
        return false;
      }
      Step& top = this->Path.back();
      const std::int32_t other = next(top.Node, top.Cursor);
      if (other < 0)
      {
        this->Finish(top, emit);
        continue;
      }
      if (this->RankOf(other) == 0)
      {
        this->Begin(other);
      }
      else
      {
        this->Lower(top.Node, this->RankOf(other));
      }
    }
    return true;
  }

  // Ranks of complete components are greater than all indices.
  void Lower(std::int32_t node, std::uint32_t rank)
  {
    this->RankOf(node) = std::min(this->RankOf(node), rank);
  }

  template <typename Emit>
  void Finish(const Step& step, Emit& emit)
  {
    const Step done = step;
    this->Path.pop_back();
    if (this->RankOf(done.Node) == done.OwnRank)
    {
      std::size_t first = this->Open.size();
      while (first > 0 && this->RankOf(this->Open[first - 1]) >= done.OwnRank)
      {
        --first;
      }
      this->Open.push_back(done.Node);
      for (std::size_t i = first; i < this->Open.size(); ++i)
      {
        this->RankOf(this->Open[i]) = this->Component;
      }
      --this->Component;
      this->Index = done.OwnRank;
      emit(this->Open.data() + first, this->Open.data() + this->Open.size());
      this->Open.resize(first);
    }
    else
    {
      this->Open.push_back(done.Node);
    }
    if (!this->Path.empty())
    {
      this->Lower(this->Path.back().Node, this->RankOf(done.Node));
    }
  }
};

} // namespace nephoscope

#endif
