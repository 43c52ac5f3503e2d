// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A structured grid with what light meets in it; its third index counts upwards (UprightOrder.h).
// Plain C++17.
#ifndef nephoscope_LightGrid_h
#define nephoscope_LightGrid_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace nephoscope
{
using Vector = std::array<float, 3>;

struct LightGrid
{
  static constexpr float Night = 1e4f; ///< depth towards a sun behind the planet; others are less

  int Size[3] = { 0, 0, 0 };
  bool Closed[2] = { false, false }; ///< along an axis: the last points are the first again
  bool Open = false; ///< light leaves through the sides, and that of the sky enters; else mirrors
  std::vector<Vector>
    Step; ///< distance to the next point along each axis; at the last point that to the one before
  std::vector<Vector> Sun; ///< direction in which sunlight goes, in the axes of each point; one for
                           ///< all if there is one
  std::vector<float> Extinction; ///< scaled
  std::vector<float> Albedo;     ///< scaled
  std::vector<float> Asymmetry;  ///< scaled
  std::vector<float> Second;     ///< scaled: the second Legendre coefficient of the phase function
  std::vector<float> Depth;      ///< scaled, towards the sun
  std::vector<float> Shadow;     ///< what other data let through of the beam; empty: all
  std::vector<float> Sky;        ///< irradiance from the sky, per column
  double GroundAlbedo = 0;

  std::size_t Points() const { return std::size_t(this->Size[0]) * this->Size[1] * this->Size[2]; }
  std::size_t Columns() const { return std::size_t(this->Size[0]) * this->Size[1]; }
  std::size_t Stride(int axis) const
  {
    return axis == 0 ? 1 : axis == 1 ? std::size_t(this->Size[0]) : this->Columns();
  }
  const Vector& SunAt(std::size_t p) const
  {
    return this->Sun.size() == 1 ? this->Sun[0] : this->Sun[p];
  }
  float Transmittance(std::size_t p) const { return std::exp(-this->Depth[p]); }
  float ShadowAt(std::size_t p) const { return this->Shadow.empty() ? 1.0f : this->Shadow[p]; }
  float BeamAt(std::size_t p) const { return this->ShadowAt(p) * this->Transmittance(p); }
  bool IsClosed(int axis) const { return axis < 2 && this->Closed[axis]; }
  /** Whether a point with this index along an axis is on an open side. */
  bool IsOpenSide(int index, int axis) const
  {
    const int last = this->Size[axis] - 1;
    return this->Open && axis < 2 && !this->Closed[axis] && last > 0 &&
      (index == 0 || index == last);
  }
  /** Points along an axis, without repeats of the first. */
  int Width(int axis) const { return this->Size[axis] - (this->IsClosed(axis) ? 1 : 0); }
  /** The index after this one, or -1. */
  int After(int index, int axis) const
  {
    return index + 1 < this->Width(axis) ? index + 1 : this->IsClosed(axis) ? 0 : -1;
  }
  int Before(int index, int axis) const
  {
    return index > 0 ? index - 1 : this->IsClosed(axis) ? this->Width(axis) - 1 : -1;
  }

  /** Gives the last points of closed axes the values of the first. */
  template <typename Value>
  void CloseSeams(std::vector<Value>& values) const
  {
    const std::size_t nx = this->Size[0], ny = this->Size[1];
    for (std::size_t row = 0; this->Closed[0] && row < values.size(); row += nx)
    {
      values[row + nx - 1] = values[row];
    }
    for (std::size_t level = 0; this->Closed[1] && level < values.size(); level += nx * ny)
    {
      std::copy_n(values.begin() + level, nx, values.begin() + level + nx * (ny - 1));
    }
  }
};

/** Calls body(k) for k in [0, n), perhaps by several threads. */
using Parallel = std::function<void(int n, const std::function<void(int)>& body)>;
}

#endif
