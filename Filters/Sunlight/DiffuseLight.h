// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Diffuse light in a structured grid whose third index counts upwards: the equation of radiative transfer by discrete ordinates and short
 * characteristics (KunaszAuer1988), iterated with Anderson's acceleration (WalkerNi2011).
 *
 * Directions are relative to the grid's own axes at each point, so that on a globe they are east, north and up everywhere; the curvature over one free
 * path is neglected. The forward peak is taken away beforehand (PhaseFunction.h). The source function is
 *
 *     S(d) = albedo / (4 pi) (fluence + 3 g d . flux + P(d . s) E T)
 *
 * with the fluence and flux of the diffuse light, the irradiance E of the sun across its beam, its transmittance T and the Henyey-Greenstein P, whose
 * mean over the directions is made 1.
 * Light of one sun is 1: E = 1. Plain C++17.
 */
#ifndef nephoscope_DiffuseLight_h
#define nephoscope_DiffuseLight_h

#include "DirectionSet.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace nephoscope
{
using Vector = std::array<float, 3>;

struct LightGrid
{
  int Size[3] = { 0, 0, 0 };
  bool Periodic = false; ///< the last points along the first axis are in the place of the first
  std::vector<Vector> Spacing; ///< distance of neighbours along each axis
  std::vector<Vector>
    Sun; ///< direction in which sunlight goes, in the axes of each point; one for all if there is one
  std::vector<float> Extinction;    ///< scaled
  std::vector<float> Albedo;        ///< scaled
  std::vector<float> Asymmetry;     ///< scaled
  std::vector<float> Transmittance; ///< of the sun's beam
  std::vector<float> Sky;           ///< irradiance from the sky, per column
  double GroundAlbedo = 0;

  std::size_t Points() const { return std::size_t(this->Size[0]) * this->Size[1] * this->Size[2]; }
  std::size_t Columns() const { return std::size_t(this->Size[0]) * this->Size[1]; }
  const Vector& SunAt(std::size_t p) const
  {
    return this->Sun.size() == 1 ? this->Sun[0] : this->Sun[p];
  }
};

struct LightSettings
{
  int Zenith = 3;
  int Azimuth = 4;
  int MostIterations = 100;
  double Tolerance = 1e-3; ///< change of the fluence, as a fraction of its largest value
};

/** Fluence and flux of the diffuse light: four numbers a point. */
struct DiffuseField
{
  std::vector<float> Moments;
  std::vector<float>
    Vertical; ///< flux up plus flux down; their difference is the third component of the flux
  int Iterations = 0;
  double Change = 0; ///< of the last iteration

  float Up(std::size_t p) const { return 0.5f * (this->Vertical[p] + this->Moments[4 * p + 3]); }
  float Down(std::size_t p) const { return 0.5f * (this->Vertical[p] - this->Moments[4 * p + 3]); }
};

/** Calls body(k) for k in [0, n), perhaps by several threads; returns false to stop. */
using Parallel = std::function<void(int n, const std::function<void(int)>& body)>;

DiffuseField diffuseLight(const LightGrid& grid, const LightSettings& settings,
  const Parallel& parallel, const std::function<bool(double)>& progress);
}

#endif
