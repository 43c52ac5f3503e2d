// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Items thrown into buckets by several threads: counted, then filled. Within a bucket they lie in
 * no particular order; who wants one sorts them, and the buckets can be sorted in parallel.
 */
#ifndef nephoscope_Buckets_h
#define nephoscope_Buckets_h

#include "ProgressLoop.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace nephoscope
{

template <typename Item>
class Buckets
{
public:
  /** visit(i, add) must make the same calls of add(bucket, item) both times. False when stopped. */
  template <typename Visit>
  bool Fill(std::size_t elements, std::size_t buckets, const Progress& progress, Visit visit)
  {
    std::vector<std::atomic<std::uint32_t>> counts(buckets);
    if (!ForEachIndex(elements, progress.Part(0, 0.4), [&](std::size_t i) {
          visit(i, [&](std::size_t bucket, const Item&) {
            counts[bucket].fetch_add(1, std::memory_order_relaxed);
          });
        }))
    {
      return false;
    }
    this->First.resize(buckets + 1);
    this->First[0] = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
    {
      this->First[bucket + 1] =
        this->First[bucket] + counts[bucket].exchange(0, std::memory_order_relaxed);
    }
    this->Items.reset(
      new Item[this->First.back()]); // not set to anything: the threads that fill it touch it first
    return ForEachIndex(elements, progress.Part(0.4, 1), [&](std::size_t i) {
      visit(i, [&](std::size_t bucket, const Item& item) {
        this->Items[this->First[bucket] + counts[bucket].fetch_add(1, std::memory_order_relaxed)] =
          item;
      });
    });
  }

  /** work(begin, end) on the items of every bucket, in parallel. False when stopped. */
  template <typename Work>
  bool ForEach(const Progress& progress, Work work)
  {
    return ForEachIndex(this->First.size() - 1, progress,
      [&](std::size_t bucket) { work(this->Begin(bucket), this->End(bucket)); });
  }

  Item* Begin(std::size_t bucket) { return this->Items.get() + this->First[bucket]; }
  Item* End(std::size_t bucket) { return this->Items.get() + this->First[bucket + 1]; }

private:
  std::vector<std::size_t> First;
  std::unique_ptr<Item[]> Items;
};

} // namespace nephoscope

#endif
