// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatOrder.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace nephoscope
{
namespace
{
constexpr std::size_t digits = 2048; // 11 bits: three passes over 32
constexpr int bitsPerPass = 11;
constexpr std::size_t blocks = 16; // whatever the number of threads, so that the result is the same

// The bits of a float, made to grow with it.
std::uint32_t Sortable(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

struct Keyed
{
  std::uint32_t Key;
  std::int32_t Item;
};

double SquareDistance(const std::array<float, 3>& p, const SplatEye& eye, const SplatMetric& metric)
{
  const Vector3 d = { { p[0] - eye[0], p[1] - eye[1], p[2] - eye[2] } };
  return Dot(d, Times(metric, d));
}

template <typename Body>
void ForBlocks(std::size_t count, Body body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType b = begin; b < end; ++b)
    {
      const auto block = static_cast<std::size_t>(b);
      body(block, block * count / blocks, (block + 1) * count / blocks);
    }
  });
}

// One pass: items go to the places that the counts of their digit, in this block and those before
// it, give them.
void SortByDigit(const std::vector<Keyed>& from, std::vector<Keyed>& to, int shift)
{
  std::vector<std::array<std::uint32_t, digits>> places(blocks);
  const auto digitOf = [shift](const Keyed& k) { return (k.Key >> shift) & (digits - 1); };
  ForBlocks(from.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
    places[block].fill(0);
    for (std::size_t i = begin; i < end; ++i)
    {
      ++places[block][digitOf(from[i])];
    }
  });
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit < digits; ++digit)
  {
    for (std::size_t block = 0; block < blocks; ++block)
    {
      next += std::exchange(places[block][digit], next);
    }
  }
  ForBlocks(from.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      to[places[block][digitOf(from[i])]++] = from[i];
    }
  });
}
}

std::vector<std::int32_t> SortKeys(std::vector<std::uint32_t>& keys)
{
  std::vector<Keyed> items(keys.size()), other(keys.size());
  ForBlocks(keys.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      items[i] = { keys[i], static_cast<std::int32_t>(i) };
    }
  });
  for (int shift = 0; shift < 32; shift += bitsPerPass)
  {
    SortByDigit(items, other, shift);
    items.swap(other);
  }
  std::vector<std::int32_t> order(items.size());
  ForBlocks(items.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      order[i] = items[i].Item;
    }
  });
  return order;
}

std::size_t CountNear(const std::vector<std::array<float, 3>>& positions,
  const std::vector<std::int32_t>& samples, const std::vector<std::int32_t>& order,
  const SplatEye& eye, double distance, const SplatMetric& metric)
{
  if (eye[3] == 0)
  {
    return 0;
  }
  const auto first = std::partition_point(order.begin(), order.end(), [&](std::int32_t item) {
    const auto& p = positions[static_cast<std::size_t>(samples[static_cast<std::size_t>(item)])];
    return SquareDistance(p, eye, metric) > distance * distance;
  });
  return static_cast<std::size_t>(order.end() - first);
}

std::vector<std::int32_t> OrderSplats(const std::vector<std::array<float, 3>>& positions,
  const std::vector<std::int32_t>& samples, const SplatEye& eye, const SplatMetric& metric)
{
  const Vector3 towards = Times(metric, { { eye[0], eye[1], eye[2] } });
  std::vector<std::uint32_t> keys(samples.size());
  ForBlocks(keys.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const auto& p = positions[static_cast<std::size_t>(samples[i])];
      double nearness;
      if (eye[3] == 0)
      {
        nearness = p[0] * towards[0] + p[1] * towards[1] + p[2] * towards[2];
      }
      else
      {
        nearness = -SquareDistance(p, eye, metric);
      }
      keys[i] = Sortable(static_cast<float>(nearness));
    }
  });
  return SortKeys(keys);
}

} // namespace nephoscope
