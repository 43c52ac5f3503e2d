// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The one splat that stands for all that lies below a node of the hierarchy, and how far it is from it. What is not there below the
// node, because it is transparent or has no value, counts as extinction 0. Plain C++17.
#ifndef nephoscope_SplatSummary_h
#define nephoscope_SplatSummary_h

#include "EllipsoidSplat.h"
#include "SplatBranch.h"

#include <limits>

namespace nephoscope
{
struct SplatSummary
{
  SplatVector Place{};
  SplatMatrix Jacobian{};
  SplatVector Color{};
  double Extinction = 0.0;
  SplatVector Vector{};
  // Deviation of extinction or emission from the mean, whichever deviates more, and of vectors.
  double GreatestError = 0.0, RootMeanSquareError = 0.0;
  double GreatestVectorError = 0.0, RootMeanSquareVectorError = 0.0;
  double Span = 1.0; // edge, in those of the leaves
};

// A block of samples of a lattice: its first index, and how many there are along each axis where the grid ends in it.
struct SplatBlock
{
  SplatVector First{}, Size{};

  SplatVector Center() const
  {
    SplatVector center;
    for (std::size_t c = 0; c < 3; ++c)
    {
      center[c] = this->First[c] + 0.5 * (this->Size[c] - 1.0);
    }
    return center;
  }
  double Count() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
};

namespace splat_summary
{
inline SplatNode Empty(double volume)
{
  SplatNode node = SplatLeaf(0.0);
  node.Count = volume;
  return node;
}

// Lower triangular factor of a symmetric positive matrix: the kernel of L is that of any J with J J^T = L L^T.
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

// `empty`: volume below the node where there is nothing; `bend`: how far places below it are off, in edges of the node.
inline void FillIn(SplatSummary& splat, const SplatBranch& branch, double empty, double bend)
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
  const double volume = std::abs(Determinant(splat.Jacobian));
  const double mass = branch.Light[3].Mean * branch.Volume();
  splat.Extinction = mass / volume;
  for (std::size_t c = 0; c < 3; ++c)
  {
    splat.Color[c] = mass > 0.0 ? branch.Light[c].Mean / branch.Light[3].Mean : branch.Color[c];
    splat.Vector[c] = vector[c].Mean;
  }
  double variance = 0.0, vectorVariance = 0.0, speed = 0.0;
  for (const SplatNode& n : light)
  {
    variance = std::max(variance, n.Variance);
  }
  for (const SplatNode& n : vector)
  {
    const double most = n.LargestError();
    splat.GreatestVectorError += most * most;
    vectorVariance += n.Variance;
    speed += n.Mean * n.Mean;
  }
  // Moved by a share of its size, a kernel changes the field by about this share of its extinction.
  const double moved = std::min(bend, 1.0);
  splat.GreatestError = LargestError(light) + moved * splat.Extinction;
  splat.RootMeanSquareError = std::sqrt(variance + std::pow(moved * splat.Extinction, 2));
  splat.GreatestVectorError = std::sqrt(splat.GreatestVectorError) + moved * std::sqrt(speed);
  splat.RootMeanSquareVectorError = std::sqrt(vectorVariance + moved * moved * speed);
  splat.Span = std::cbrt((branch.Volume() + empty) * branch.Leaves / branch.Volume());
}
}

// The middle of the block; exact where the lattice is straight.
inline SplatVector PlaceOfBlock(const SplatBranch& branch, const SplatBlock& block)
{
  const SplatVector offset = Times(branch.Jacobian, Minus(block.Center(), branch.Index));
  return { { branch.Place[0] + offset[0], branch.Place[1] + offset[1], branch.Place[2] + offset[2] } };
}

// On a lattice: the edges of all cells of the block, and its middle, so that equal nodes form a lattice again.
inline SplatSummary SummarizeLattice(const SplatBranch& branch, const SplatBlock& block, double flatShare)
{
  SplatSummary splat;
  splat.Place = PlaceOfBlock(branch, block);
  SplatVector bend{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    bend[c] = branch.Bend[c] / block.Size[c];
    for (std::size_t row = 0; row < 3; ++row)
    {
      splat.Jacobian[c][row] = block.Size[c] * branch.Jacobian[c][row];
    }
  }
  splat.Jacobian = WithoutFlatColumns(splat.Jacobian, flatShare);
  const double empty = branch.Volume() * std::max(0.0, block.Count() / branch.Leaves - 1.0);
  splat_summary::FillIn(splat, branch, empty, Length(bend));
  // A node that a bent lattice folds up, as around a pole, cannot stand for anything.
  const double share = std::abs(Determinant(splat.Jacobian)) / (branch.Volume() + empty);
  if (!(share > 0.25 && share < 4.0))
  {
    splat.GreatestError = splat.RootMeanSquareError = std::numeric_limits<double>::infinity();
  }
  return splat;
}

// Elsewhere: an ellipsoid of the covariance of what lies below. Leaves that form a block of a lattice get the block's own.
inline SplatSummary SummarizeScattered(const SplatBranch& branch)
{
  SplatSummary splat;
  splat.Place = branch.Place;
  splat.Jacobian = splat_summary::Cholesky(branch.Shape);
  const double volume = std::abs(Determinant(splat.Jacobian));
  splat_summary::FillIn(splat, branch, std::max(0.0, volume - branch.Volume()), 0.0);
  const double overlap = std::max(1.0, branch.Volume() / volume); // of leaves, whose extinctions add up
  splat.GreatestError *= overlap;
  splat.RootMeanSquareError *= overlap;
  return splat;
}
}

#endif
