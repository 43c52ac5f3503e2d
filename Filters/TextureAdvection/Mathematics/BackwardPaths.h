// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths that are followed back in time through the winds of a series. Plain C++17.
#ifndef nephoscope_BackwardPaths_h
#define nephoscope_BackwardPaths_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nephoscope
{
// The position of a time within a series. Before the first and after the last, both neighbours are
// that one.
struct SeriesInterval
{
  int Earlier = 0;
  int Later = 0;
  double Fraction = 0.0; // of the way from the earlier to the later
};

class TimeSeries
{
public:
  // Seconds, rising; at least one.
  explicit TimeSeries(std::vector<double> times)
    : Times(std::move(times))
  {
  }

  double First() const { return this->Times.front(); }
  double Last() const { return this->Times.back(); }
  double Time(int i) const { return this->Times[static_cast<std::size_t>(i)]; }

  SeriesInterval Find(double time) const
  {
    const int last = static_cast<int>(this->Times.size()) - 1;
    const auto after = std::upper_bound(this->Times.begin(), this->Times.end(), time);
    const int earlier = static_cast<int>(after - this->Times.begin()) - 1;
    if (earlier < 0)
    {
      return { 0, 0, 0.0 };
    }
    if (earlier == last || time == this->Time(earlier))
    {
      return { earlier, earlier, 0.0 };
    }
    return { earlier, earlier + 1,
      (time - this->Time(earlier)) / (this->Time(earlier + 1) - this->Time(earlier)) };
  }

  // The interval of the series that a step back from `time` runs through, and where it may end: at
  // the times of the series and at equal parts of what lies between, of at most `step`. So the
  // steps do not depend on where a path begins.
  double StepBack(double time, double step, SeriesInterval& interval) const
  {
    const double edge = time <= this->First() ? this->First() : this->Last();
    if (time <= this->First() || time > this->Last())
    {
      const double parts = std::ceil((time - edge) / step - ROUNDING) - 1.0;
      const int index = time <= this->First() ? 0 : static_cast<int>(this->Times.size()) - 1;
      interval = { index, index, 0.0 };
      return edge + parts * step;
    }
    const auto after = std::lower_bound(this->Times.begin(), this->Times.end(), time);
    const int later = static_cast<int>(after - this->Times.begin());
    const double begin = this->Time(later - 1);
    const double span = this->Time(later) - begin;
    const double count = std::max(1.0, std::ceil(span / step - ROUNDING));
    const double parts = std::ceil((time - begin) / span * count - ROUNDING) - 1.0;
    interval = { later - 1, later, 0.0 };
    return parts <= 0.0 ? begin : begin + span * parts / count;
  }

  // The fraction of an interval that has passed, exactly 0 and 1 at its ends.
  double FractionOf(double time, const SeriesInterval& interval) const
  {
    if (interval.Earlier == interval.Later || time <= this->Time(interval.Earlier))
    {
      return 0.0;
    }
    const double begin = this->Time(interval.Earlier);
    return time >= this->Time(interval.Later)
      ? 1.0
      : (time - begin) / (this->Time(interval.Later) - begin);
  }

private:
  static constexpr double ROUNDING = 1e-9;

  std::vector<double> Times;
};

// A step of a path: the interval it is in, and the fractions and times at its ends.
struct PathStep
{
  SeriesInterval Interval;
  double FromFraction;
  double ToFraction;
  double From;
  double To;
};

// Calls take(PathStep) for every step from `start` back to each of `stops`, which fall, and
// arrive(index) there. False if one of them said so.
template <typename Take, typename Arrive>
bool FollowBack(const TimeSeries& series, double start, const std::vector<double>& stops,
  double step, const Take& take, const Arrive& arrive)
{
  double now = start;
  for (std::size_t s = 0; s < stops.size(); ++s)
  {
    while (now > stops[s])
    {
      PathStep path;
      path.From = now;
      path.To = std::max(stops[s], series.StepBack(now, step, path.Interval));
      // Not a tiny step to a stop that rounding has put beside an end.
      path.To = path.To - stops[s] < 1e-9 * step ? stops[s] : path.To;
      path.FromFraction = series.FractionOf(path.From, path.Interval);
      path.ToFraction = series.FractionOf(path.To, path.Interval);
      if (!take(path))
      {
        return false;
      }
      now = path.To;
    }
    arrive(s);
  }
  return true;
}
}

#endif
