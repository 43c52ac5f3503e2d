// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The one splat that stands for all that lies below a node of the hierarchy, and how far it is from
// it. What is not there below the node, because it is transparent or has no value, counts as
// extinction 0. Plain C++17.
#ifndef nephoscope_SplatSummary_h
#define nephoscope_SplatSummary_h

#include "SplatBranch.h"
#include "SplatGaussian.h"

#include <vector>

namespace nephoscope
{
struct SplatSummary
{
  Vector3 Place{};
  SplatMatrix Jacobian{};
  Vector3 Color{};
  double Extinction = 0.0;
  Vector3 Vector{};
  // Deviation of extinction or emission from the mean, whichever deviates more, and of vectors; in
  // the mean square the field of the node from that of what lies below, over the node.
  double GreatestError = 0.0, RootMeanSquareError = 0.0;
  double GreatestVectorError = 0.0, RootMeanSquareVectorError = 0.0;
  double Span = 1.0; // edge, in those of the leaves
};

namespace splat_summary
{
inline SplatNode Empty(double volume)
{
  SplatNode node = SplatLeaf(0.0);
  node.Count = volume;
  return node;
}

// Lower triangular factor of a symmetric positive matrix: the kernel of L is that of any J with J
// J^T = L L^T.
inline SplatMatrix Cholesky(const std::array<double, 6>& s)
{
  SplatMatrix l{};
  l[0][0] = std::sqrt(s[0]);
  l[0][1] = s[3] / l[0][0];
  l[0][2] = s[4] / l[0][0];
  l[1][1] = std::sqrt(std::max(0.0, s[1] - l[0][1] * l[0][1]));
  l[1][2] = l[1][1] > 0.0 ? (s[5] - l[0][1] * l[0][2]) / l[1][1] : 0.0;
  l[2][2] = std::sqrt(std::max(0.0, s[2] - l[0][2] * l[0][2] - l[1][2] * l[1][2]));
  return l;
}

template <std::size_t channels>
double LargestError(const std::array<SplatNode, channels>& nodes)
{
  double largest = 0.0;
  for (const SplatNode& n : nodes)
  {
    largest = std::max(largest, n.LargestError());
  }
  return largest;
}

// `empty`: volume of the node where there is nothing.
inline void FillIn(SplatSummary& splat, const SplatBranch& branch, double volume, double empty)
{
  auto light = branch.Light;
  auto vector = branch.Vector;
  if (empty > 1e-6 * branch.Volume()) // more than rounding
  {
    for (SplatNode& n : light)
    {
      n = Join(n, Empty(empty));
    }
    for (SplatNode& n : vector)
    {
      n = Join(n, Empty(empty));
    }
  }
  const double mass = branch.Light[3].Mean * branch.Volume();
  splat.Extinction = mass / volume;
  double vectorVariance = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    splat.Color[c] = mass > 0.0 ? branch.Light[c].Mean / branch.Light[3].Mean : branch.Color[c];
    splat.Vector[c] = vector[c].Mean;
    splat.GreatestVectorError += std::pow(vector[c].LargestError(), 2);
    vectorVariance += vector[c].Variance;
  }
  splat.GreatestError =
    LargestError(light) * std::max(1.0, branch.Volume() / volume); // overlapping leaves add up
  splat.GreatestVectorError = std::sqrt(splat.GreatestVectorError);
  splat.RootMeanSquareVectorError = std::sqrt(vectorVariance);
  splat.Span = std::cbrt((branch.Volume() + empty) * branch.Leaves / branch.Volume());
}

inline SplatGaussian<3> GaussianOf(const SplatBranch& branch)
{
  SplatGaussian<3> gaussian;
  gaussian.Place = branch.Place;
  const auto& s = branch.Shape;
  const double full[3][3] = { { s[0], s[3], s[4] }, { s[3], s[1], s[5] }, { s[4], s[5], s[2] } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      gaussian.Covariance[i][j] = cubic_kernel::variance * full[i][j];
    }
  }
  for (std::size_t c = 0; c < 4; ++c)
  {
    gaussian.Mass[c] = branch.Light[c].Mean * branch.Volume();
  }
  return gaussian;
}
}

// What stands for the branches of [begin, end), whose join is `branch`: an ellipsoid with the mass,
// the mean place and the covariance of what lies below. The branch gets the square of its error.
template <typename Iterator>
SplatSummary Summarize(SplatBranch& branch, Iterator begin, Iterator end)
{
  SplatSummary splat;
  splat.Place = branch.Place;
  splat.Jacobian = splat_summary::Cholesky(branch.Shape);
  const double volume = std::abs(Determinant(splat.Jacobian));
  splat_summary::FillIn(splat, branch, volume, std::max(0.0, volume - branch.Volume()));
  std::vector<SplatGaussian<3>> below;
  for (Iterator i = begin; i != end; ++i)
  {
    below.push_back(splat_summary::GaussianOf(*i));
  }
  const SplatGaussian<3> one = splat_summary::GaussianOf(branch);
  branch.SquareError += SquareDistance(one, below.begin(), below.end());
  splat.RootMeanSquareError = std::sqrt(branch.SquareError * Overlap(one, one));
  splat.GreatestError = std::max(splat.GreatestError, splat.RootMeanSquareError);
  return splat;
}
}

#endif
