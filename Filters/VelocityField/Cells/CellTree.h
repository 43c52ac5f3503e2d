// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A tree of boxes over the cells of any mesh: which cells may hold a position. Plain C++17.
#ifndef nephoscope_CellTree_h
#define nephoscope_CellTree_h

#include "GridBoxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace nephoscope
{
// The cells in the order of a space-filling curve (Morton1966) of their centres; eight of them
// share a box, eight boxes a larger one, and so on.
class CellTree
{
public:
  bool IsEmpty() const { return this->Levels.empty(); }

  // Cells without a volume to look in may have the box Box{}: they are left out.
  void Build(const std::vector<Box>& cells)
  {
    Box all;
    for (const Box& box : cells)
    {
      all.AddBox(box);
    }
    struct Key
    {
      std::uint64_t Code;
      std::int64_t Cell;
    };
    std::vector<Key> keys;
    keys.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (cells[i].Low[0] <= cells[i].High[0])
      {
        keys.push_back({ Code(cells[i], all), static_cast<std::int64_t>(i) });
      }
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return a.Code < b.Code || (a.Code == b.Code && a.Cell < b.Cell);
    });
    this->Cells.clear();
    this->Levels.assign(1, {});
    for (const Key& key : keys)
    {
      this->Cells.push_back(key.Cell);
      this->Levels[0].push_back(cells[static_cast<std::size_t>(key.Cell)]);
    }
    while (this->Levels.back().size() > BRANCH)
    {
      const std::vector<Box>& children = this->Levels.back();
      std::vector<Box> parents((children.size() + BRANCH - 1) / BRANCH);
      for (std::size_t i = 0; i < children.size(); ++i)
      {
        parents[i / BRANCH].AddBox(children[i]);
      }
      this->Levels.push_back(std::move(parents));
    }
  }

  // Calls `found(cell)` with every cell whose box holds the position, until it returns true.
  template <typename Found>
  bool ForEachCell(const Vector3& x, const Found& found) const
  {
    const std::size_t top = this->Levels.size() - 1;
    return this->Descend(top, 0, this->Levels[top].size(), x, found);
  }

  // Calls `look(cell)`, which tells the square of the distance of the nearest thing seen so far,
  // with every cell whose box is not farther.
  template <typename Look>
  void ForEachNear(const Vector3& x, const Look& look) const
  {
    const std::size_t top = this->Levels.size() - 1;
    double reach = std::numeric_limits<double>::max();
    this->DescendNear(top, 0, this->Levels[top].size(), x, reach, look);
  }

private:
  static constexpr std::size_t BRANCH = 8;

  static std::uint64_t Code(const Box& box, const Box& all)
  {
    std::uint64_t code = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double length = all.High[a] - all.Low[a];
      const double middle = 0.5 * (box.Low[a] + box.High[a]) - all.Low[a];
      const double fraction = length > 0.0 ? std::clamp(middle / length, 0.0, 1.0) : 0.0;
      code |= Spread(static_cast<std::uint64_t>(fraction * 2097151.0)) << a;
    }
    return code;
  }

  // Every bit of 21 to every third place.
  static std::uint64_t Spread(std::uint64_t bits)
  {
    bits = (bits | bits << 32) & 0x001f00000000ffffULL;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
    bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
    return (bits | bits << 2) & 0x1249249249249249ULL;
  }

  template <typename Found>
  bool Descend(std::size_t level, std::size_t begin, std::size_t end, const Vector3& x,
    const Found& found) const
  {
    const std::vector<Box>& boxes = this->Levels[level];
    for (std::size_t i = begin; i < end; ++i)
    {
      if (!boxes[i].Holds(x))
      {
        continue;
      }
      const bool done = level == 0
        ? found(this->Cells[i])
        : this->Descend(level - 1, BRANCH * i,
            std::min(BRANCH * (i + 1), this->Levels[level - 1].size()), x, found);
      if (done)
      {
        return true;
      }
    }
    return false;
  }

  template <typename Look>
  void DescendNear(std::size_t level, std::size_t begin, std::size_t end, const Vector3& x,
    double& reach, const Look& look) const
  {
    std::array<std::pair<double, std::size_t>, BRANCH> order;
    for (std::size_t i = begin; i < end; ++i)
    {
      order[i - begin] = { this->Levels[level][i].Distance2(x), i };
    }
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(end - begin));
    for (std::size_t n = 0; n < end - begin && order[n].first <= reach; ++n)
    {
      const std::size_t i = order[n].second;
      if (level == 0)
      {
        reach = std::min(reach, look(this->Cells[i]));
        continue;
      }
      const std::size_t last = std::min(BRANCH * (i + 1), this->Levels[level - 1].size());
      this->DescendNear(level - 1, BRANCH * i, last, x, reach, look);
    }
  }

  std::vector<std::int64_t> Cells;
  std::vector<std::vector<Box>> Levels;
};
}

#endif
