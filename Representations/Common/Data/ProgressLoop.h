// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Loops that report their progress, and stop on request.
 *
 * A loop is cut into stretches of about 30 ms; between two of them the calling thread reports. The
 * result of a loop does not depend on where it was split. Without anybody to report to, it runs in
 * one stretch.
 */
#ifndef nephoscope_ProgressLoop_h
#define nephoscope_ProgressLoop_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <utility>

namespace nephoscope
{

/** A part of some work: fractions of it, in [0, 1], reported as fractions of the whole. */
class Progress
{
public:
  /** Takes the fraction of the whole that is done; false: stop. */
  using Listener = std::function<bool(double)>;

  Progress() = default;
  Progress(Listener listener)
    : Hear(std::move(listener))
  {
  }
  bool IsHeard() const { return static_cast<bool>(this->Hear); }
  /** Returns false when the work is to stop. */
  bool Report(double fraction) const
  {
    return !this->Hear || this->Hear(this->Begin + (this->End - this->Begin) * fraction);
  }
  /** The stretch of this work from one fraction to another. */
  Progress Part(double begin, double end) const
  {
    Progress part(this->Hear);
    part.Begin = this->Begin + (this->End - this->Begin) * begin;
    part.End = this->Begin + (this->End - this->Begin) * end;
    return part;
  }

private:
  Listener Hear;
  double Begin = 0, End = 1;
};

namespace detail
{
/** stretch(begin, end) over [0, n); false when stopped. */
template <typename Stretch>
bool InStretches(std::size_t n, const Progress& progress, std::size_t shortest, std::size_t longest,
  Stretch stretch)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds veryQuick(3), quick(15), slow(45);
  std::size_t length =
    progress.IsHeard() ? shortest : n; // the first stretch tells how long one takes
  for (std::size_t begin = 0; begin < n;)
  {
    const std::size_t end = begin + std::min(length, n - begin);
    const Clock::time_point start = Clock::now();
    stretch(begin, end);
    const Clock::duration spent = Clock::now() - start;
    length = spent < veryQuick ? 16 * length : spent < quick ? 2 * length : length;
    length = std::min(longest, spent > slow ? std::max(length / 2, shortest) : length);
    begin = end;
    if (!progress.Report(static_cast<double>(end) / static_cast<double>(n)))
    {
      return false;
    }
  }
  return true;
}
}

constexpr std::size_t anyLength = static_cast<std::size_t>(-1);

/**
 * body(begin, end) in parallel over [0, n); false when stopped before the end. `longest`: elements
 * in a stretch for each thread, where some are much heavier than those before them.
 */
template <typename Body>
bool ForRanges(std::size_t n, const Progress& progress, Body body, std::size_t longest = anyLength)
{
  const std::size_t threads =
    static_cast<std::size_t>(std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1));
  longest = longest == anyLength ? n : longest * threads;
  return detail::InStretches(
    n, progress, threads, longest, [&body](std::size_t first, std::size_t last) {
      vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last),
        [&body](vtkIdType begin, vtkIdType end) {
          body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
        });
    });
}

/** body(i) in parallel for i in [0, n); false when stopped before the end. */
template <typename Body>
bool ForEachIndex(
  std::size_t n, const Progress& progress, Body body, std::size_t longest = anyLength)
{
  return ForRanges(
    n, progress,
    [&body](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        body(i);
      }
    },
    longest);
}

/** body(i) one after the other; false when stopped before the end. */
template <typename Body>
bool ForEachInTurn(std::size_t n, const Progress& progress, Body body)
{
  return detail::InStretches(n, progress, 1, n, [&body](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      body(i);
    }
  });
}

} // namespace nephoscope

#endif
