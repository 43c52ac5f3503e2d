// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A node of the hierarchy of splats (LaurHanrahan1991): exact mean, variance and range of what lies
// below it. Plain C++17.
#ifndef nephoscope_SplatNode_h
#define nephoscope_SplatNode_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{
struct SplatNode
{
  double Count = 0.0; // leaves below; 0 where the grid ends
  double Mean = 0.0;
  double Variance = 0.0;
  double Minimum = 0.0;
  double Maximum = 0.0;

  double RootMeanSquareError() const { return std::sqrt(this->Variance); }
  double LargestError() const
  {
    return std::max(this->Maximum - this->Mean, this->Mean - this->Minimum);
  }
};

inline SplatNode SplatLeaf(double value)
{
  return { 1.0, value, 0.0, value, value };
}

// Adds what lies below two nodes; exact, in any order up to rounding.
inline SplatNode Join(const SplatNode& a, const SplatNode& b)
{
  if (a.Count == 0.0 || b.Count == 0.0)
  {
    return a.Count == 0.0 ? b : a;
  }
  SplatNode sum;
  sum.Count = a.Count + b.Count;
  const double difference = b.Mean - a.Mean;
  sum.Mean = a.Mean + difference * b.Count / sum.Count;
  sum.Variance = (a.Count * a.Variance + b.Count * b.Variance) / sum.Count +
    difference * difference * a.Count * b.Count / (sum.Count * sum.Count);
  sum.Minimum = std::min(a.Minimum, b.Minimum);
  sum.Maximum = std::max(a.Maximum, b.Maximum);
  return sum;
}
}

#endif
