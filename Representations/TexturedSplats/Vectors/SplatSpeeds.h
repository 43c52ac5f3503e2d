// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The speed at which vectors are fully drawn, which a few outliers do not raise. Plain C++17.
#ifndef nephoscope_SplatSpeeds_h
#define nephoscope_SplatSpeeds_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace nephoscope
{
// Speeds are counted in bins by the leading bits of their number: counts of several processes add
// up to those of one.
class SpeedCounts
{
public:
  // Speeds of 0 or that are not finite do not count.
  void Add(float speed)
  {
    if (speed > 0.0f && std::isfinite(speed))
    {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &speed, sizeof bits);
      this->Counts.resize(bins, 0.0);
      this->Counts[bits >> dropped] += 1.0;
      this->Greatest = std::max(this->Greatest, static_cast<double>(speed));
    }
  }

  double GetGreatest() const { return this->Greatest; }

  double GetNumber() const
  {
    return std::accumulate(this->Counts.begin(), this->Counts.end(), 0.0);
  }

  // That 99 % of the vectors do not exceed; 0 without vectors.
  double GetUsual() const
  {
    const double needed = usualShare * this->GetNumber();
    double below = 0.0;
    for (std::size_t bin = 0; bin < this->Counts.size(); ++bin)
    {
      const double count = this->Counts[bin];
      if (count > 0.0 && below + count >= needed)
      {
        const double low = lowerEdge(bin);
        return low + (needed - below) / count * (lowerEdge(bin + 1) - low);
      }
      below += count;
    }
    return this->Greatest;
  }

  // The greatest, or 1.25 times the usual one if that is less.
  double GetFull() const { return std::min(this->Greatest, longOfUsual * this->GetUsual()); }

  // What is told of vectors that are more than twice as long as the usual one, or empty.
  std::string DescribeLong(const std::string& arrayName) const
  {
    const double full = this->GetFull();
    if (!(this->Greatest > toldOfUsual * this->GetUsual()))
    {
      return {};
    }
    std::ostringstream text;
    text.precision(3);
    text << "Array '" << arrayName << "' has vectors of a length of up to " << this->Greatest
         << ", but 99 % are not longer than " << this->GetUsual() << ": vectors longer than "
         << full << " are clamped to this length. Replace wrong values, or set MaximumSpeed.";
    return text.str();
  }

  ///@{
  // For sums over processes: as many numbers everywhere.
  std::vector<double> GetCounts() const
  {
    std::vector<double> counts = this->Counts;
    counts.resize(bins, 0.0);
    return counts;
  }
  void Set(const std::vector<double>& counts, double greatest)
  {
    this->Counts = counts;
    this->Greatest = greatest;
  }
  ///@}

private:
  static constexpr int dropped = 16; // bits: a bin is at most 0.8 % wide
  static constexpr std::size_t bins = std::size_t(1) << (31 - dropped);
  static constexpr double usualShare = 0.99, longOfUsual = 1.25, toldOfUsual = 2.0;

  static double lowerEdge(std::size_t bin)
  {
    const auto bits = static_cast<std::uint32_t>(bin << dropped);
    float edge = 0.0f;
    std::memcpy(&edge, &bits, sizeof edge);
    return edge;
  }

  std::vector<double> Counts;
  double Greatest = 0.0;
};

inline float SpeedOf(const std::array<float, 3>& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}
}

#endif
