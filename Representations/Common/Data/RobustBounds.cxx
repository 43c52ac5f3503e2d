// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RobustBounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
constexpr double share = 0.1; // of the weight, on either side of the bulk
constexpr double shrinkage = 4.0;

bool IsEmpty(const MediumBounds& box)
{
  return box[0] > box[1];
}

double DiagonalOf(const MediumBounds& box)
{
  return std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
}

void SumOver(const MediumReduction& over, double* numbers, int count)
{
  if (over.Sum)
  {
    over.Sum(numbers, count);
  }
}

bool Counts(const WeightedPlace& p)
{
  return p.Weight > 0.0 && std::isfinite(p.Weight + p.Place[0] + p.Place[1] + p.Place[2]);
}

// The weight below the two numbers of every axis, and all of it last.
std::array<double, 7> WeightsBelow(
  const std::vector<WeightedPlace>& places, const MediumBounds& box, const MediumReduction& over)
{
  std::array<double, 7> weights{};
  for (const WeightedPlace& p : places)
  {
    const double weight = Counts(p) ? p.Weight : 0.0;
    for (std::size_t i = 0; i < 6; ++i)
    {
      weights[i] += p.Place[i / 2] <= box[i] ? weight : 0.0;
    }
    weights[6] += weight;
  }
  SumOver(over, weights.data(), 7);
  return weights;
}

// By bisection, which takes the same steps on all processes. Empty where nothing has a weight.
MediumBounds BulkOf(
  const std::vector<WeightedPlace>& places, const MediumBounds& all, const MediumReduction& over)
{
  constexpr int steps = 128; // enough for a bulk that is 1e-38 of the bounds
  MediumBounds low, high;
  for (std::size_t i = 0; i < 6; ++i)
  {
    low[i] = all[i / 2 * 2];
    high[i] = all[i / 2 * 2 + 1];
  }
  bool open = true;
  for (int step = 0; step < steps && open; ++step)
  {
    MediumBounds middle;
    std::transform(low.begin(), low.end(), high.begin(), middle.begin(),
      [](double a, double b) { return 0.5 * a + 0.5 * b; });
    const std::array<double, 7> weights = WeightsBelow(places, middle, over);
    if (!(weights[6] > 0.0))
    {
      return NoMediumBounds;
    }
    open = false;
    for (std::size_t i = 0; i < 6; ++i)
    {
      const bool above = weights[i] < (i % 2 ? 1.0 - share : share) * weights[6];
      open = open || (low[i] < middle[i] && middle[i] < high[i]);
      (above ? low : high)[i] = middle[i];
    }
  }
  return { { low[0], high[1], low[2], high[3], low[4], high[5] } };
}

double ShareOutside(
  const std::vector<WeightedPlace>& places, const MediumBounds& box, const MediumReduction& over)
{
  double numbers[2] = {};
  for (const WeightedPlace& p : places)
  {
    const double number = Counts(p) ? p.Number : 0.0;
    numbers[0] += HoldsPlace(box, p.Place) ? 0.0 : number;
    numbers[1] += number;
  }
  SumOver(over, numbers, 2);
  return numbers[0] / numbers[1];
}

MediumBounds Widened(const MediumBounds& box, double margin)
{
  return { { box[0] - margin, box[1] + margin, box[2] - margin, box[3] + margin, box[4] - margin,
    box[5] + margin } };
}
} // namespace

double WeightOfCell(double volume, double length)
{
  const double fullness = length > 0.0 ? volume / (length * length * length) : 0.0;
  return volume * fullness * fullness *
    fullness; // of splats even the thinnest have a fiftieth of their length: 4e-4
}

bool HoldsPlace(const MediumBounds& b, const double x[3])
{
  return x[0] >= b[0] && x[0] <= b[1] && x[1] >= b[2] && x[1] <= b[3] && x[2] >= b[4] &&
    x[2] <= b[5];
}

MediumBounds RobustBounds(const std::vector<WeightedPlace>& places,
  const std::function<MediumBounds(const MediumBounds& box)>& boundsWithin,
  const MediumReduction& over)
{
  const auto boundsOver = [&](const MediumBounds& box) {
    return over.Bounds ? over.Bounds(boundsWithin(box)) : boundsWithin(box);
  };
  const MediumBounds all = boundsOver(WholeMedium);
  const MediumBounds bulk = IsEmpty(all) ? all : BulkOf(places, all, over);
  if (IsEmpty(bulk) || !(shrinkage * DiagonalOf(bulk) < DiagonalOf(all)))
  {
    return all;
  }
  const MediumBounds kept = boundsOver(Widened(bulk, DiagonalOf(bulk)));
  const bool farther = !IsEmpty(kept) && shrinkage * DiagonalOf(kept) <= DiagonalOf(all);
  return farther && ShareOutside(places, kept, over) <= share ? kept : all;
}

MediumBounds RobustBoundsOfPlaces(vtkIdType count,
  const std::function<bool(vtkIdType number, double* place)>& place, const MediumReduction& over)
{
  const SampleChoice choice(count, enoughPlaces);
  std::vector<WeightedPlace> places;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto standing =
      static_cast<double>(choice.Standing()); // processes choose from different numbers
    WeightedPlace one = { {}, standing, standing };
    if (choice.Takes(i) && place(i, one.Place))
    {
      places.push_back(one);
    }
  }
  const auto boundsWithin = [&](const MediumBounds& box) {
    MediumBounds bounds = NoMediumBounds;
    double x[3];
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (place(i, x) && HoldsPlace(box, x))
      {
        ExtendBounds(bounds, x);
      }
    }
    return bounds;
  };
  return RobustBounds(places, boundsWithin, over);
}

} // namespace nephoscope
