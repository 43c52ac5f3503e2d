// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The distance of each cell of a grid from the next visible one: the number of cells that a ray may
 * skip.
 */
#ifndef nephoscope_ClearDistances_h
#define nephoscope_ClearDistances_h

#include "ChessboardGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace nephoscope
{

/**
 * In moves of a chess king, up to 255; 0: the cell itself can be seen. `visible` has a number other
 * than 0 for cells that can be seen.
 * Two sweeps, forwards and backwards, each with the half of the 26 neighbours that it has passed.
 */
inline std::vector<std::uint8_t> FindClearDistances(
  const ChessboardGrid& grid, const std::vector<std::uint8_t>& visible)
{
  const std::int64_t size[3] = { grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1 };
  std::vector<std::uint8_t> distances(visible.size());
  std::transform(visible.begin(), visible.end(), distances.begin(),
    [](std::uint8_t v) { return std::uint8_t(v ? 0 : 255); });
  const auto number = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return i + size[0] * (j + size[1] * k);
  };
  const auto sweep = [&](bool forwards) {
    const std::int64_t count = grid.NumberOfCells();
    const int passed = forwards ? -1 : 1;
    for (std::int64_t n = 0; n < count; ++n)
    {
      const std::int64_t cell = forwards ? n : count - 1 - n;
      std::uint8_t& distance = distances[static_cast<std::size_t>(cell)];
      if (distance == 0)
      {
        continue;
      }
      const std::array<int, 3> c = grid.CellIndex(cell);
      const auto look = [&](int di, int dj, int dk) {
        const std::int64_t i = c[0] + di, j = c[1] + dj, k = c[2] + dk;
        if (i >= 0 && i < size[0] && j >= 0 && j < size[1] && k >= 0 && k < size[2])
        {
          const std::uint8_t next = distances[static_cast<std::size_t>(number(i, j, k))];
          distance = std::min<std::uint8_t>(distance, next == 255 ? next : std::uint8_t(next + 1));
        }
      };
      look(passed, 0, 0);
      for (int di = -1; di <= 1; ++di)
      {
        look(di, passed, 0);
        for (int dj = -1; dj <= 1; ++dj)
        {
          look(di, dj, passed);
        }
      }
    }
  };
  sweep(true);
  sweep(false);
  return distances;
}

} // namespace nephoscope

#endif
