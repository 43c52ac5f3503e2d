# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sun of a picture on a globe or a map: its place, and the variables of the water and the air by their roles."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .._dates import options_of
from ..light import is_on_globe
from .reading import Reading

_ARGUMENTS = {"cloud_water": "liquid", "cloud_ice": "ice", "rain": "rain", "snow": "snow", "temperature": "temperature", "pressure": "pressure", "cloud_fraction": "cloud_fraction"}
AIR = "temperature"  # the array that is computed if the dataset has none
SLANT = 45.0  # degrees from the zenith, of a sun without a date and a direction


def missing_air(reading: Reading) -> list[str]:
    """What `derive` must compute for light in clouds: the temperature, if the dataset has clouds and a potential temperature alone, as those of WRF and MPAS."""
    if reading.has("temperature") or not reading.has("potential_temperature") or not any(reading.has(role) for role in ("cloud_water", "cloud_ice", "cloud_fraction")):
        return []
    on_pressures = reading.vertical is not None and reading.vertical.kind in ("pressure", "log pressure", "hybrid", "sigma")
    return [AIR] if on_pressures or reading.has("pressure") or reading.has("pressure_thickness") else []


def sun_of(sun: Any, reading: Reading, grid: pyvista.DataSet) -> dict[str, Any]:
    """The argument `sun` of `add_cells`; what the user has given takes precedence."""
    given = options_of(sun)
    if not {"time", "direction"} & set(given):
        given["direction"] = _above(grid)
    if given.get("time") and not is_on_globe(grid):
        given.setdefault("place", _middle_of_map(grid))
    if AIR in grid.array_names and not reading.has("temperature"):
        given.setdefault("temperature", AIR)
    if "water" in given:
        return given
    there = {argument: reading.roles[role] for role, argument in _ARGUMENTS.items() if reading.has(role) and reading.roles[role] in grid.array_names}
    if not {"liquid", "ice"} & set(there):  # cloud_optics finds them, takes the usual ones of a cloud fraction, or says what it has looked for
        return given
    absent = {argument: "none" for argument in ("liquid", "ice", "rain", "snow") if argument not in there}
    return {**there, **absent, **given}


def _middle_of_map(grid: pyvista.DataSet) -> tuple[float, float]:
    """Longitude and latitude: a map has one sun."""
    west, east, south, north, *_ = np.degrees(np.array(grid.bounds) / float(np.ravel(grid.field_data["PlanetRadius"])[0]))
    return (0.5 * (west + east) + 180) % 360 - 180, 0.5 * (south + north)


def _above(grid: pyvista.DataSet) -> np.ndarray:
    """A direction from the west of the zenith over the middle of the data."""
    if not is_on_globe(grid):
        return np.array([-1.0, -0.5, 1.0])
    points = np.asarray(grid.points)
    middle = points[np.isfinite(points).all(axis=1)].mean(axis=0)
    up = middle / np.linalg.norm(middle) if np.linalg.norm(middle) > 0.2 * np.abs(points).max() else np.array([0.27, -0.91, 0.32])
    west = np.cross(up, (0.0, 0.0, 1.0))
    west = west / np.linalg.norm(west) if np.linalg.norm(west) > 1e-6 else np.array([1.0, 0.0, 0.0])
    return np.cos(np.radians(SLANT)) * up + np.sin(np.radians(SLANT)) * west
