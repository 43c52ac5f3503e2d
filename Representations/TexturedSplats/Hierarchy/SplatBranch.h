// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What lies below a node of the hierarchy of splats (LaurHanrahan1991). Averages are taken after
// classification, over volume, so that mass (extinction times volume) and emission are kept. Plain
// C++17.
#ifndef nephoscope_SplatBranch_h
#define nephoscope_SplatBranch_h

#include "SplatKernel.h"
#include "SplatMatrix.h"
#include "SplatNode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nephoscope
{
// Means over the leaves; exact, whatever the order in which branches are joined.
struct SplatBranch
{
  std::array<SplatNode, 4> Light;  // red, green, blue emission and extinction; counted by volume
  std::array<SplatNode, 3> Vector; // counted by volume
  Vector3 Color{};                 // by volume, without regard to extinction
  double Leaves = 0.0;
  double Weight =
    0.0; // mass, of which what follows are the moments: mean, and covariance over that of a kernel
  Vector3 Place{};
  std::array<double, 6> Shape{}; // xx yy zz xy xz yz
  double SquareError = 0.0; // integral of the square of what the nodes below differ from theirs

  double Volume() const { return this->Light[3].Count; }
};

namespace splat_branch
{
inline std::array<double, 6> Square(const Vector3& v)
{
  return { { v[0] * v[0], v[1] * v[1], v[2] * v[2], v[0] * v[1], v[0] * v[2], v[1] * v[2] } };
}

inline double Blend(double a, double b, double share)
{
  return a + share * (b - a);
}

template <std::size_t n>
std::array<double, n> Blend(
  const std::array<double, n>& a, const std::array<double, n>& b, double share)
{
  std::array<double, n> sum;
  for (std::size_t i = 0; i < n; ++i)
  {
    sum[i] = Blend(a[i], b[i], share);
  }
  return sum;
}
}

// A leaf of this colour and extinction (the fourth component of `light`), with a share of its cell,
// which counts by its volume where `byVolume`, else by its mass.
inline SplatBranch BranchOfLeaf(const std::array<double, 4>& light, const Vector3& vector,
  const Vector3& place, const SplatMatrix& jacobian, double shareOfCell, bool byVolume)
{
  SplatBranch leaf;
  leaf.Leaves = 1.0;
  const double volume = shareOfCell * std::abs(Determinant(jacobian));
  for (std::size_t c = 0; c < 4; ++c)
  {
    leaf.Light[c] = SplatLeaf(c < 3 ? light[c] * light[3] : light[3]);
    leaf.Light[c].Count = volume;
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    leaf.Vector[c] = SplatLeaf(vector[c]);
    leaf.Vector[c].Count = volume;
    leaf.Color[c] = light[c];
    const auto square = splat_branch::Square(jacobian[c]);
    for (std::size_t i = 0; i < 6; ++i)
    {
      leaf.Shape[i] += square[i];
    }
  }
  leaf.Weight = byVolume ? volume : volume * light[3];
  leaf.Place = place;
  return leaf;
}

inline SplatBranch Join(const SplatBranch& a, const SplatBranch& b)
{
  if (a.Leaves == 0.0 || b.Leaves == 0.0)
  {
    return a.Leaves == 0.0 ? b : a;
  }
  using splat_branch::Blend;
  SplatBranch sum;
  sum.Leaves = a.Leaves + b.Leaves;
  for (std::size_t c = 0; c < 4; ++c)
  {
    sum.Light[c] = Join(a.Light[c], b.Light[c]);
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    sum.Vector[c] = Join(a.Vector[c], b.Vector[c]);
  }
  const double volume = a.Volume() + b.Volume();
  sum.Color = Blend(a.Color, b.Color, volume > 0.0 ? b.Volume() / volume : 0.5);
  sum.Weight = a.Weight + b.Weight;
  const double share = sum.Weight > 0.0 ? b.Weight / sum.Weight : 0.5;
  sum.Place = Blend(a.Place, b.Place, share);
  sum.Shape = Blend(a.Shape, b.Shape, share);
  const auto apart = splat_branch::Square(b.Place - a.Place);
  for (std::size_t i = 0; i < 6; ++i)
  {
    sum.Shape[i] += apart[i] * share * (1.0 - share) / cubic_kernel::variance;
  }
  sum.SquareError = a.SquareError + b.SquareError;
  return sum;
}
}

#endif
