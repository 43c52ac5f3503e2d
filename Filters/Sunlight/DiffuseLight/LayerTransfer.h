// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Diffuse light between two points in Eddington's approximation, solved exactly in the layer
 * between them: whatever its optical depth, it neither makes nor loses light. Plain C++17.
 *
 * With fluence F, flux J along the layer, scaled optical depth t, albedo w, asymmetry g and the
 * beam's light T going along s:
 *
 *     dJ/dt = -(1 - w) F + w T        dF/dt / 3 = -(1 - w g) J + w g s T
 */
#ifndef nephoscope_LayerTransfer_h
#define nephoscope_LayerTransfer_h

#include <algorithm>
#include <cmath>

namespace nephoscope
{
struct LayerMedium
{
  double Depth = 0, Albedo = 1, Asymmetry = 0;

  double Transport() const { return std::max(1 - this->Albedo * this->Asymmetry, 1e-6); }
  /** Depth over which diffuse light falls to 1/e, counted in layers. */
  double Decay() const
  {
    return this->Depth * std::sqrt(std::max(3 * (1 - this->Albedo) * this->Transport(), 0.0));
  }
};

/**
 * Here - There of LayerConductance: what a layer absorbs per fluence at each of its points, without
 * the rounding errors of the difference.
 */
inline double LayerAbsorption(const LayerMedium& medium)
{
  const double x = medium.Decay(), d = 1 / (3 * medium.Transport() * std::max(medium.Depth, 1e-4));
  return d * x * std::tanh(0.5 * x);
}

/** The flux that leaves a point into the layer: Here F - There F(other point). */
struct LayerConductance
{
  double Here, There;

  explicit LayerConductance(const LayerMedium& medium)
  {
    const double x = medium.Decay(),
                 d = 1 / (3 * medium.Transport() * std::max(medium.Depth, 1e-4));
    const bool thin = x < 1e-3;
    this->Here = d * (thin ? 1 + x * x / 3 : x / std::tanh(x));
    this->There = d * (thin ? 1 - x * x / 6 : x / std::sinh(x));
  }
};

/**
 * The distribution of light that a beam scatters in the layer, as fractions of all light scattered
 * there. The beam goes as exp(slope u) from u = 0, the first point, to u = 1, the second.
 */
struct LayerShares
{
  double First, Second; ///< of scattered light that arrives at the points; the rest is absorbed
  double FirstForward, SecondForward; ///< means of the beam, as the two points feel its direction

  LayerShares(double slope, double decay)
  {
    this->Set(std::abs(slope), decay);
    if (slope > 0)
    {
      std::swap(this->First, this->Second);
      std::swap(this->FirstForward, this->SecondForward);
    }
  }

private:
  // (1 - exp(-y)) / y
  static double Mean(double y)
  {
    return std::abs(y) < 1e-4 ? 1 - 0.5 * y + y * y / 6 : -std::expm1(-y) / y;
  }
  void Set(double k, double x)
  {
    const double whole = Mean(k);
    if (x < 1e-2)
    {
      const double moment = k < 1e-2 ? 0.5 - k / 3 + k * k / 8 : (whole - std::exp(-k)) / k;
      this->First = 1 - moment / whole;
      this->Second = moment / whole;
      this->FirstForward = this->SecondForward = 1;
      return;
    }
    const double e = std::exp(-x), near = Mean(k + x),
                 far = k > x ? e * Mean(k - x) : std::exp(-k) * Mean(x - k); // exp(-x) Mean(k - x)
    const double scale = 1 / ((1 - e * e) * whole);
    this->First = (near - e * far) * scale;
    this->Second = (far - e * near) * scale;
    this->FirstForward = x * (near + e * far) * scale;
    this->SecondForward = x * (far + e * near) * scale;
  }
};
}

#endif
