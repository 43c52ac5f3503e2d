// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedIntervals.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace nephoscope
{
namespace
{
using Value = TransferFunctionTable::Value;
using Interval = TransferFunctionTable::Interval;

struct Place
{
  double X, Y;
};

double Slope(const Place& a, const Place& b)
{
  return (b.Y - a.Y) / (b.X - a.X);
}

/** The steepest line that passes between `low` and `high` at every x, ascending. */
class SteepestLine
{
public:
  /** At the x of the call before, both limits count. False: the line does not reach `low`. */
  bool Add(double x, double low, double high)
  {
    if (this->At(x) < low)
    {
      return false;
    }
    if (high < this->At(x))
    {
      this->TurnDownTo({ x, high });
    }
    this->AddLow({ x, low });
    return true;
  }

  double At(double x) const
  {
    return this->HasSlope
      ? this->Right.Y + Slope(this->Lows[this->Left], this->Right) * (x - this->Right.X)
      : std::numeric_limits<double>::infinity();
  }

private:
  // The slope only falls: lows to the left of the one that the line touches are never touched
  // again.
  void TurnDownTo(const Place& high)
  {
    if (this->Lows.empty())
    {
      return; // a single place has no slope
    }
    while (this->Left + 1 < this->Lows.size() && this->Lows[this->Left + 1].X < high.X &&
      Slope(this->Lows[this->Left + 1], high) <= Slope(this->Lows[this->Left], high))
    {
      ++this->Left;
    }
    this->Right = high;
    this->HasSlope = true;
  }

  void AddLow(const Place& low)
  {
    if (!this->Lows.empty() && this->Lows.back().X == low.X)
    {
      if (low.Y <= this->Lows.back().Y)
      {
        return;
      }
      this->Lows.pop_back();
    }
    while (this->Lows.size() > this->Left + 1 &&
      Slope(this->Lows[this->Lows.size() - 2], this->Lows.back()) <= Slope(this->Lows.back(), low))
    {
      this->Lows.pop_back();
    }
    this->Lows.push_back(low);
  }

  std::vector<Place> Lows; // from `Left` on, their upper hull
  std::size_t Left = 0;    // the low that the line touches
  Place Right = { 0, 0 };  // the high that it touches
  bool HasSlope = false;
};

/** The lines of one channel. */
class Lines
{
public:
  bool Add(double x, double low, double high)
  {
    return this->Rising.Add(x, low, high) && this->Falling.Add(x, -high, -low);
  }
  double Middle(double x) const { return 0.5 * (this->Rising.At(x) - this->Falling.At(x)); }

private:
  SteepestLine Rising, Falling; // the second upside down
};

/** Intervals that are joined, and the lines that pass all their ends. */
class Run
{
public:
  Run(double colorTolerance, double opacityTolerance)
    : ColorTolerance(colorTolerance)
    , OpacityTolerance(opacityTolerance)
  {
  }

  /** True if one line per channel passes this end too. */
  bool Add(double x, const Value& value)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const auto [low, high] = this->Limits(value, c);
      if (!this->Channels[c].Add(x, low, high))
      {
        return false;
      }
    }
    return true;
  }

  /** Halfway between the steepest lines, at an end where the function has this value. */
  Value Middle(double x, const Value& value) const
  {
    Value result;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const auto [low, high] = this->Limits(value, c); // rounding may pass them
      result[c] = static_cast<float>(std::clamp(this->Channels[c].Middle(x), low, high));
    }
    return result;
  }

private:
  std::pair<double, double> Limits(const Value& value, std::size_t channel) const
  {
    const double tolerance =
      channel < 3 ? this->ColorTolerance : this->OpacityTolerance * value[channel];
    return { std::max(0.0, value[channel] - tolerance), value[channel] + tolerance };
  }

  double ColorTolerance, OpacityTolerance;
  std::array<Lines, 4> Channels;
};

/** Nodes between 0 and 1. */
std::vector<double> Fractions(const std::vector<double>& nodes)
{
  std::vector<double> fractions;
  const double width = 0.5 * nodes.back() - 0.5 * nodes.front(); // of the largest doubles too
  for (const double node : nodes)
  {
    fractions.push_back((0.5 * node - 0.5 * nodes.front()) / width);
  }
  return fractions;
}
}

void JoinIntervals(std::vector<double>& nodes, std::vector<Interval>& intervals,
  double colorTolerance, double opacityTolerance)
{
  if (nodes.size() < 3)
  {
    return;
  }
  const std::vector<double> x = Fractions(nodes);
  std::vector<double> joinedNodes = { nodes.front() };
  std::vector<Interval> joined = { intervals.front() };
  for (std::size_t first = 1, next = 2; first < nodes.size(); first = next++)
  {
    Interval interval = intervals[first];
    Run run(colorTolerance, opacityTolerance);
    const auto add = [&](std::size_t k) {
      return x[k] > x[k - 1] && run.Add(x[k - 1], intervals[k].Low) &&
        run.Add(x[k], intervals[k].High);
    };
    for (bool fits = add(first); fits && next < nodes.size() && add(next); ++next)
    {
      interval = { run.Middle(x[first - 1], intervals[first].Low),
        run.Middle(x[next], intervals[next].High) };
    }
    joinedNodes.push_back(nodes[next - 1]);
    joined.push_back(interval);
  }
  joined.push_back(intervals.back());
  nodes = std::move(joinedNodes);
  intervals = std::move(joined);
}

} // namespace nephoscope
