// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutNumbering.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
constexpr std::size_t numberOfBuckets = 64; // each sorted by one thread

struct Entry
{
  PointCut Cut;
  std::size_t Batch;
  std::size_t Place;

  bool operator<(const Entry& other) const { return this->Cut < other.Cut; }
};

// The cuts of a batch by bucket: places, and where each bucket begins among them.
struct Sorted
{
  std::vector<std::size_t> Places;
  std::vector<std::size_t> Begins;
};

std::size_t BucketOf(const PointCut& cut, vtkIdType numberOfPoints)
{
  const double share = static_cast<double>(cut.First) / static_cast<double>(numberOfPoints);
  return std::min(
    static_cast<std::size_t>(share * static_cast<double>(numberOfBuckets)), numberOfBuckets - 1);
}

Sorted SortIntoBuckets(const std::vector<PointCut>& cuts, vtkIdType numberOfPoints)
{
  Sorted sorted;
  sorted.Begins.assign(numberOfBuckets + 1, 0);
  for (const PointCut& cut : cuts)
  {
    ++sorted.Begins[BucketOf(cut, numberOfPoints) + 1];
  }
  for (std::size_t b = 0; b < numberOfBuckets; ++b)
  {
    sorted.Begins[b + 1] += sorted.Begins[b];
  }
  std::vector<std::size_t> next = sorted.Begins;
  sorted.Places.resize(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    sorted.Places[next[BucketOf(cuts[i], numberOfPoints)]++] = i;
  }
  return sorted;
}

// Sorts a bucket of all batches; returns each cut once, and numbers the cuts from 0 within the
// bucket.
std::vector<PointCut> NumberBucket(std::size_t bucket, const std::vector<SplitBatch>& batches,
  const std::vector<Sorted>& sorted, std::vector<std::vector<vtkIdType>>& numbers)
{
  std::vector<Entry> entries;
  for (std::size_t b = 0; b < batches.size(); ++b)
  {
    for (std::size_t i = sorted[b].Begins[bucket]; i < sorted[b].Begins[bucket + 1]; ++i)
    {
      const std::size_t place = sorted[b].Places[i];
      entries.push_back({ batches[b].Cuts[place], b, place });
    }
  }
  std::sort(entries.begin(), entries.end());
  std::vector<PointCut> cuts;
  for (const Entry& entry : entries)
  {
    if (cuts.empty() || !(cuts.back() == entry.Cut))
    {
      cuts.push_back(entry.Cut);
    }
    numbers[entry.Batch][entry.Place] = static_cast<vtkIdType>(cuts.size()) - 1;
  }
  return cuts;
}
}

CutNumbering::CutNumbering(const std::vector<SplitBatch>& batches, vtkIdType numberOfPoints)
  : Numbers(batches.size())
{
  const auto count = static_cast<vtkIdType>(batches.size());
  std::vector<Sorted> sorted(batches.size());
  vtkSMPTools::For(0, count, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType b = begin; b < end; ++b)
    {
      sorted[b] = SortIntoBuckets(batches[b].Cuts, numberOfPoints);
      this->Numbers[b].resize(batches[b].Cuts.size());
    }
  });
  std::vector<std::vector<PointCut>> buckets(numberOfBuckets);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(numberOfBuckets), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        buckets[k] = NumberBucket(static_cast<std::size_t>(k), batches, sorted, this->Numbers);
      }
    });
  std::vector<vtkIdType> offsets;
  for (const std::vector<PointCut>& bucket : buckets)
  {
    offsets.push_back(static_cast<vtkIdType>(this->Cuts.size()));
    this->Cuts.insert(this->Cuts.end(), bucket.begin(), bucket.end());
  }
  vtkSMPTools::For(0, count, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType b = begin; b < end; ++b)
    {
      for (std::size_t i = 0; i < batches[b].Cuts.size(); ++i)
      {
        this->Numbers[b][i] += offsets[BucketOf(batches[b].Cuts[i], numberOfPoints)];
      }
    }
  });
}

} // namespace nephoscope
