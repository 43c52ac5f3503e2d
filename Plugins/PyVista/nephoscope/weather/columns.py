# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights and air of a column: the hypsometric equation, geopotential and the standard atmosphere. Plain numpy; the first axis is the level."""
from __future__ import annotations

import numpy as np

from .units import GRAVITY

EARTH_RADIUS = 6371229.0  # metres, of the sphere that most models compute on
GAS_CONSTANT = 287.05  # J/(kg K), of dry air
KAPPA = 0.2857  # R/cp of dry air
VAPOUR_RATIO = 0.622  # molar masses of water vapour and dry air


def geometric(geopotential_height: np.ndarray) -> np.ndarray:
    """Height above sea level from geopotential height: gravity falls with the square of the distance from the Earth's centre."""
    return EARTH_RADIUS * geopotential_height / (EARTH_RADIUS - geopotential_height)


def geopotential_height(height: np.ndarray) -> np.ndarray:
    return EARTH_RADIUS * height / (EARTH_RADIUS + height)


def virtual_temperature(temperature: np.ndarray, specific_humidity: np.ndarray | None) -> np.ndarray:
    if specific_humidity is None:
        return temperature
    return temperature * (1 + (1 / VAPOUR_RATIO - 1) * np.nan_to_num(specific_humidity))


def hypsometric(pressure: np.ndarray, virtual: np.ndarray, surface_pressure: np.ndarray, terrain: np.ndarray) -> np.ndarray:
    """Geopotential heights of full levels, from the ground upwards; levels in any order.

    Between neighbours the virtual temperature is linear in the logarithm of the pressure (the trapezoidal rule). From the ground to the lowest level
    above it, and to levels below the ground, it is constant.
    """
    order = np.argsort(-_means(pressure))  # bottom to top
    with np.errstate(divide="ignore"):  # the top of some models is at 0 Pa
        p, t = np.log(pressure[order]), virtual[order]
    scale = GAS_CONSTANT / GRAVITY
    above = p <= np.log(surface_pressure) + 1e-6
    heights = np.full(p.shape, np.nan)
    last = np.full(p.shape[1:], np.nan)
    for k in range(len(p)):
        first = above[k] & ~above[k - 1] if k else above[k]
        from_ground = terrain + scale * t[k] * (np.log(surface_pressure) - p[k])
        from_below = last + scale * 0.5 * (t[k] + t[k - 1]) * (p[k - 1] - p[k]) if k else np.nan
        last = np.where(first, from_ground, np.where(above[k], from_below, np.nan))
        heights[k] = np.where(above[k], last, from_ground)
    back = np.empty_like(heights)
    back[order] = heights
    return back


def from_half_levels(half_pressure: np.ndarray, virtual: np.ndarray, terrain: np.ndarray) -> np.ndarray:
    """Geopotential heights of the full levels between half levels, top first, as in the ECMWF's model (IFS documentation, part III, 2.21 to 2.23)."""
    scale = GAS_CONSTANT / GRAVITY
    heights = np.empty(virtual.shape)
    base = np.array(terrain, dtype=float)
    for k in range(len(virtual) - 1, -1, -1):
        upper, lower = half_pressure[k], half_pressure[k + 1]
        with np.errstate(divide="ignore", invalid="ignore"):
            thickness = np.log(lower / upper)
            alpha = np.where(upper > 0, 1 - upper / (lower - upper) * thickness, np.log(2))
        heights[k] = base + scale * virtual[k] * alpha
        base = base + scale * virtual[k] * np.where(upper > 0, thickness, 0)
    return heights


def midpoints(layers: np.ndarray, from_first: bool) -> np.ndarray:
    """Distances of the middles of layers from the outer face of the first or of the last one."""
    along = layers if from_first else layers[::-1]
    found = np.cumsum(along, axis=0) - 0.5 * along
    return found if from_first else found[::-1]


def _means(pressure: np.ndarray) -> np.ndarray:
    return np.nanmean(pressure.reshape(len(pressure), -1), axis=1)


# U.S. Standard Atmosphere 1976 to 86 km: geopotential height of the base (m), temperature (K), lapse rate (K/m).
_LAYERS = ((0, 288.15, -0.0065), (11000, 216.65, 0.0), (20000, 216.65, 0.001), (32000, 228.65, 0.0028), (47000, 270.65, 0.0), (51000, 270.65, -0.0028), (71000, 214.65, -0.002))
_GAS_1976 = 8.31432 / 0.0289644


def _bases() -> list[float]:
    pressures = [101325.0]
    for (z, t, rate), (above, _, _) in zip(_LAYERS, _LAYERS[1:]):
        pressures.append(pressures[-1] * _ratio(t, rate, above - z))
    return pressures


def _ratio(t: float, rate: float, dz: float) -> float:
    return (t / (t + rate * dz)) ** (GRAVITY / (_GAS_1976 * rate)) if rate else np.exp(-GRAVITY * dz / (_GAS_1976 * t))


def standard_height(pressure: np.ndarray) -> np.ndarray:
    """Geopotential height of a pressure in Pa in the standard atmosphere."""
    pressure = np.asarray(pressure, dtype=float)
    height = np.empty(pressure.shape)
    for (z, t, rate), base in zip(_LAYERS, _bases()):
        here = pressure <= base if z else np.full(pressure.shape, True)
        ratio = base / pressure[here]
        height[here] = z + (t / rate * (ratio ** (_GAS_1976 * rate / GRAVITY) - 1) if rate else _GAS_1976 * t / GRAVITY * np.log(ratio))
    return height


def standard_temperature(pressure: np.ndarray) -> np.ndarray:
    heights = standard_height(pressure)
    bases = np.array([layer[0] for layer in _LAYERS])
    layer = np.clip(np.searchsorted(bases, heights, side="right") - 1, 0, None)
    return np.array([entry[1] for entry in _LAYERS])[layer] + np.array([entry[2] for entry in _LAYERS])[layer] * (heights - bases[layer])


def standard_air(height: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pressure in Pa and temperature in K of the standard atmosphere at geopotential heights."""
    height = np.asarray(height, dtype=float)
    pressure, temperature = np.empty(height.shape), np.empty(height.shape)
    for (z, t, rate), base in zip(_LAYERS, _bases()):
        here = height >= z if z else np.full(height.shape, True)
        temperature[here] = t + rate * (height[here] - z)
        pressure[here] = base * _ratio(t, rate, height[here] - z)
    return pressure, temperature


def density(pressure: np.ndarray, virtual: np.ndarray) -> np.ndarray:
    return pressure / (GAS_CONSTANT * virtual)


def upward_wind(omega: np.ndarray, pressure: np.ndarray, virtual: np.ndarray) -> np.ndarray:
    """m/s from Pa/s by hydrostatic balance."""
    return -omega / (density(pressure, virtual) * GRAVITY)
