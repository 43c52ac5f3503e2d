// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankMeasures.h"

#include "Ranks.h"

#include <vector>

namespace nephoscope
{
namespace
{
// Several intervals at once; an empty one must not count.
void ReduceRanges(double* ranges, int count)
{
  auto controller = OtherRanks();
  if (!controller)
  {
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    double* range = ranges + 2 * i;
    const bool empty = range[0] > range[1];
    const double low = empty ? VTK_DOUBLE_MAX : range[0];
    const double high = empty ? -VTK_DOUBLE_MAX : range[1];
    controller->AllReduce(&low, range, 1, vtkCommunicator::MIN_OP);
    controller->AllReduce(&high, range + 1, 1, vtkCommunicator::MAX_OP);
  }
}
} // namespace

MediumBounds ReduceOverRanks(const MediumBounds& mine)
{
  MediumBounds all = mine;
  ReduceRanges(all.data(), 3);
  return all;
}

MediumReduction ReductionOverRanks()
{
  const auto sum = [](double* numbers, int count) {
    const std::vector<double> mine(numbers, numbers + count);
    if (auto controller = OtherRanks())
    {
      controller->AllReduce(mine.data(), numbers, count, vtkCommunicator::SUM_OP);
    }
  };
  return { sum, [](const MediumBounds& mine) { return ReduceOverRanks(mine); } };
}

MediumMeasures ReduceOverRanks(const MediumMeasures& mine)
{
  MediumMeasures all = mine;
  if (auto controller = OtherRanks())
  {
    std::vector<double> sums = { mine.Volume, mine.FiniteVolume, mine.ScalarIntegral,
      mine.OpacityIntegral, mine.Silhouettes };
    const std::vector<double>& pixels = mine.Projections.GetPixels();
    sums.insert(sums.end(), pixels.begin(), pixels.end());
    std::vector<double> allSums(sums.size());
    controller->AllReduce(
      sums.data(), allSums.data(), static_cast<vtkIdType>(sums.size()), vtkCommunicator::SUM_OP);
    all.Volume = allSums[0];
    all.FiniteVolume = allSums[1];
    all.ScalarIntegral = allSums[2];
    all.OpacityIntegral = allSums[3];
    all.Silhouettes = allSums[4];
    all.Projections.GetPixels().assign(allSums.begin() + 5, allSums.end());
    controller->AllReduce(mine.Reach.data(), all.Reach.data(), 8, vtkCommunicator::MAX_OP);
    ReduceRange(all.ScalarRange);
  }
  return all;
}

void ReduceRange(double range[2])
{
  ReduceRanges(range, 1);
}

} // namespace nephoscope
