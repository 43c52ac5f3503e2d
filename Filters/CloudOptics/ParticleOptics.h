// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Extinction, single-scattering albedo and asymmetry parameter in visible light (0.55 micrometres).
// Plain C++17. Contents in kg/m3, radii in metres, extinction in 1/m.
#ifndef nephoscope_ParticleOptics_h
#define nephoscope_ParticleOptics_h

#include "ParticleSize.h"

namespace nephoscope
{
namespace particles
{
inline constexpr double EXTINCTION_EFFICIENCY = 2.0; // particles much larger than the wavelength

struct Optics
{
  double Extinction = 0;
  double Scattering = 0; // extinction times single-scattering albedo
  double Forward = 0;    // scattering times asymmetry parameter

  void Add(double extinction, double albedo, double asymmetry)
  {
    this->Extinction += extinction;
    this->Scattering += extinction * albedo;
    this->Forward += extinction * albedo * asymmetry;
  }
  // Without water the value is that of droplets of 10 micrometres, so that interpolation at the
  // edge of a cloud changes little.
  double Albedo() const { return this->Extinction > 0 ? this->Scattering / this->Extinction : 1.0; }
  double Asymmetry() const
  {
    return this->Scattering > 0 ? this->Forward / this->Scattering : 0.854;
  }
};

// Particles of one effective radius: beta = 3 Q content / (4 density radius).
inline double Extinction(double content, double density, double radius)
{
  return content > 0 ? 0.75 * EXTINCTION_EFFICIENCY * content / (density * radius) : 0.0;
}

// Slingo1989, table 1, the mean of visible bands: radii in micrometres from 4.2 to 16.6.
inline double DropletAlbedo(double micrometres)
{
  return std::min(1.0, 1.0 + 5.62e-8 - 1.63e-7 * micrometres);
}
inline double DropletAsymmetry(double micrometres)
{
  return 0.829 + 2.482e-3 * std::min(std::max(micrometres, 4.2), 16.6);
}

// EbertCurry1992, table 2, the band from 0.25 to 0.7 micrometres: radii in micrometres up to 130.
inline double CrystalAlbedo()
{
  return 1.0 - 1e-5;
}
inline double CrystalAsymmetry(double micrometres)
{
  return 0.7661 + 5.851e-4 * std::min(std::max(micrometres, 13.0), 130.0);
}

inline void AddDroplets(Optics& optics, double content, double radius)
{
  const double micrometres = 1e6 * radius;
  optics.Add(Extinction(content, WATER_DENSITY, radius), DropletAlbedo(micrometres),
    DropletAsymmetry(micrometres));
}
inline void AddCrystals(Optics& optics, double content, double radius)
{
  optics.Add(
    Extinction(content, ICE_DENSITY, radius), CrystalAlbedo(), CrystalAsymmetry(1e6 * radius));
}
// Large particles: the asymmetry of geometric optics. Drops 0.87 with diffraction; flakes that of
// the largest crystals.
inline void AddRain(Optics& optics, double content)
{
  if (content > 0)
  {
    optics.Add(Extinction(content, WATER_DENSITY, RainRadius(content)), 1.0, 0.87);
  }
}
inline void AddSnow(Optics& optics, double content)
{
  if (content > 0)
  {
    optics.Add(Extinction(content, SNOW_DENSITY, SnowRadius(content)), CrystalAlbedo(),
      CrystalAsymmetry(130.0));
  }
}
}
}

#endif
