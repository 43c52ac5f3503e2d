// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes around blocks of cells of a curvilinear grid, boxes around those, and so on: which cells
// may hold a position.
// Plain C++17.
#ifndef nephoscope_GridBoxes_h
#define nephoscope_GridBoxes_h

#include "GridCell.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace nephoscope
{
struct Box
{
  Vector3 Low{ { std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
    std::numeric_limits<double>::max() } };
  Vector3 High{ { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
    std::numeric_limits<double>::lowest() } };

  template <typename Coordinate>
  void AddPoint(const Coordinate* point)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], static_cast<double>(point[c]));
      this->High[c] = std::max(this->High[c], static_cast<double>(point[c]));
    }
  }

  void AddBox(const Box& box)
  {
    this->AddPoint(box.Low.data());
    this->AddPoint(box.High.data());
  }

  // With a margin for rounding.
  bool Holds(const Vector3& x) const
  {
    bool holds = true;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double margin =
        1e-8 * (this->High[c] - this->Low[c]) + 1e-15 * (std::abs(this->High[c]) + std::abs(x[c]));
      holds = holds && x[c] >= this->Low[c] - margin && x[c] <= this->High[c] + margin;
    }
    return holds;
  }

  // Square of the distance; 0 inside.
  double Distance2(const Vector3& x) const
  {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double beyond = std::max({ this->Low[c] - x[c], x[c] - this->High[c], 0.0 });
      sum += beyond * beyond;
    }
    return sum;
  }
};

class GridBoxes
{
public:
  template <typename Coordinate>
  void Build(const Coordinate* points, const GridSize& size)
  {
    this->CellLevel = BoxLevel{ { size.Cells(0), size.Cells(1), size.Cells(2) }, {} };
    BoxLevel level = this->CellLevel.Parent();
    level.ForEach([&](const std::array<int, 3>& block, Box& box) {
      // The points of a block of cells, the far ends included.
      std::array<int, 3> end;
      for (std::size_t a = 0; a < 3; ++a)
      {
        end[a] = std::min(BRANCH * (block[a] + 1), size.Cells(a));
      }
      std::array<int, 3> p;
      for (p[2] = BRANCH * block[2]; p[2] <= end[2]; ++p[2])
      {
        for (p[1] = BRANCH * block[1]; p[1] <= end[1]; ++p[1])
        {
          p[0] = BRANCH * block[0];
          const Coordinate* row = points + 3 * size.PointId(p);
          for (; p[0] <= end[0]; ++p[0], row += 3)
          {
            box.AddPoint(row);
          }
        }
      }
    });
    this->Levels = { std::move(level) };
    while (this->Levels.back().Boxes.size() > 1)
    {
      BoxLevel parent = this->Levels.back().Parent();
      parent.ForEach([&](const std::array<int, 3>& block, Box& box) {
        this->Levels.back().ForEachChild(
          block, [&](const std::array<int, 3>&, const Box& child) { box.AddBox(child); });
      });
      this->Levels.push_back(std::move(parent));
    }
  }

  // Calls `found(block)` with the index of every lowest block whose box holds the position, until
  // it returns true.
  template <typename Found>
  bool ForEachBlock(const Vector3& x, const Found& found) const
  {
    return this->Descend(this->Levels.size() - 1, { 0, 0, 0 }, x, found);
  }

  // Calls `found(cell)` with the cells of a lowest block, until it returns true.
  template <typename Found>
  bool ForEachCell(const std::array<int, 3>& block, const Found& found) const
  {
    return this->CellLevel.AnyChild(block, found);
  }

  // Cells, or blocks, along each axis of a block.
  static constexpr int BRANCH = 4;

private:
  struct BoxLevel
  {
    std::array<int, 3> Size{};
    std::vector<Box> Boxes;

    BoxLevel Parent() const
    {
      BoxLevel parent;
      std::size_t count = 1;
      for (std::size_t a = 0; a < 3; ++a)
      {
        parent.Size[a] = (this->Size[a] + BRANCH - 1) / BRANCH;
        count *= static_cast<std::size_t>(parent.Size[a]);
      }
      parent.Boxes.resize(count);
      return parent;
    }

    std::size_t Id(const std::array<int, 3>& b) const
    {
      const auto row = static_cast<std::size_t>(this->Size[0]);
      const auto column = static_cast<std::size_t>(this->Size[1]);
      return static_cast<std::size_t>(b[0]) +
        row * (static_cast<std::size_t>(b[1]) + column * static_cast<std::size_t>(b[2]));
    }

    template <typename Function>
    void ForEach(const Function& function)
    {
      std::array<int, 3> b;
      for (b[2] = 0; b[2] < this->Size[2]; ++b[2])
      {
        for (b[1] = 0; b[1] < this->Size[1]; ++b[1])
        {
          for (b[0] = 0; b[0] < this->Size[0]; ++b[0])
          {
            function(b, this->Boxes[this->Id(b)]);
          }
        }
      }
    }

    template <typename Function>
    bool AnyChild(const std::array<int, 3>& parent, const Function& holds) const
    {
      std::array<int, 3> end;
      for (std::size_t a = 0; a < 3; ++a)
      {
        end[a] = std::min(BRANCH * (parent[a] + 1), this->Size[a]);
      }
      std::array<int, 3> b;
      for (b[2] = BRANCH * parent[2]; b[2] < end[2]; ++b[2])
      {
        for (b[1] = BRANCH * parent[1]; b[1] < end[1]; ++b[1])
        {
          for (b[0] = BRANCH * parent[0]; b[0] < end[0]; ++b[0])
          {
            if (holds(b))
            {
              return true;
            }
          }
        }
      }
      return false;
    }

    template <typename Function>
    void ForEachChild(const std::array<int, 3>& parent, const Function& function) const
    {
      this->AnyChild(parent, [&](const std::array<int, 3>& b) {
        function(b, this->Boxes[this->Id(b)]);
        return false;
      });
    }
  };

  template <typename Found>
  bool Descend(
    std::size_t level, const std::array<int, 3>& block, const Vector3& x, const Found& found) const
  {
    const BoxLevel& here = this->Levels[level];
    if (!here.Boxes[here.Id(block)].Holds(x))
    {
      return false;
    }
    if (level == 0)
    {
      return found(block);
    }
    return this->Levels[level - 1].AnyChild(block,
      [&](const std::array<int, 3>& child) { return this->Descend(level - 1, child, x, found); });
  }

  BoxLevel CellLevel; // sizes only
  std::vector<BoxLevel> Levels;
};
}

#endif
