// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The 1976 US standard atmosphere up to 84.852 km, in closed form (StandardAtmosphere1976, part 1,
// section 1.2: seven layers of constant temperature gradient, equations 23, 33a and 33b). Plain
// C++17.
//
// Heights are geopotential metres, pressures pascals, temperatures kelvins, densities kg/m3. Below
// the sea level and above the top the first and the last layer go on.
#ifndef nephoscope_StandardAtmosphere_h
#define nephoscope_StandardAtmosphere_h

#include <cmath>

namespace nephoscope
{
namespace atmosphere
{
inline constexpr double GRAVITY = 9.80665;           // m/s2, standard
inline constexpr double DRY_AIR_CONSTANT = 287.0529; // J/(kg K): 8314.32 / 28.9644

struct Layer
{
  double height;
  double temperature;
  double gradient; // K/m
  double pressure;
};

// Table 4 gives heights and gradients; temperatures and pressures at the layer bases follow from
// them.
inline constexpr Layer LAYERS[7] = {
  { 0.0, 288.15, -0.0065, 101325.0 },
  { 11000.0, 216.65, 0.0, 22632.0640 },
  { 20000.0, 216.65, 0.001, 5474.88867 },
  { 32000.0, 228.65, 0.0028, 868.018685 },
  { 47000.0, 270.65, 0.0, 110.906306 },
  { 51000.0, 270.65, -0.0028, 66.9388731 },
  { 71000.0, 214.65, -0.002, 3.95642043 },
};

inline const Layer& LayerAtHeight(double height)
{
  int i = 6;
  while (i > 0 && height < LAYERS[i].height)
  {
    --i;
  }
  return LAYERS[i];
}

inline const Layer& LayerAtPressure(double pressure)
{
  int i = 6;
  while (i > 0 && pressure > LAYERS[i].pressure)
  {
    --i;
  }
  return LAYERS[i];
}

inline double Temperature(double height)
{
  const Layer& layer = LayerAtHeight(height);
  return layer.temperature + layer.gradient * (height - layer.height);
}

inline double Pressure(double height)
{
  const Layer& layer = LayerAtHeight(height);
  const double scale = GRAVITY / DRY_AIR_CONSTANT;
  if (layer.gradient == 0.0)
  {
    return layer.pressure * std::exp(-scale * (height - layer.height) / layer.temperature);
  }
  return layer.pressure * std::pow(layer.temperature / Temperature(height), scale / layer.gradient);
}

// The inverse of Pressure; pressure > 0.
inline double HeightFromPressure(double pressure)
{
  const Layer& layer = LayerAtPressure(pressure);
  const double scale = GRAVITY / DRY_AIR_CONSTANT;
  if (layer.gradient == 0.0)
  {
    return layer.height - layer.temperature / scale * std::log(pressure / layer.pressure);
  }
  const double ratio = std::pow(pressure / layer.pressure, -layer.gradient / scale);
  return layer.height + layer.temperature / layer.gradient * (ratio - 1.0);
}

inline double Density(double pressure, double temperature)
{
  return pressure / (DRY_AIR_CONSTANT * temperature);
}

// w = -omega / (rho g) in m/s from omega = dp/dt in Pa/s: hydrostatic, the local change and the
// advection of pressure along the surface neglected.
inline double UpwardWindFromOmega(double omega, double pressure, double temperature)
{
  return -omega / (Density(pressure, temperature) * GRAVITY);
}
}
}

#endif
