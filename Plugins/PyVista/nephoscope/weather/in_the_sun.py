# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sun of a picture on a globe or a map: its position, and the variables of the water and the air by their roles."""
from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pyvista

from .. import vtkSunSource
from .._dates import options_of
from .._globe_camera import middle_of
from .._medium import default_scalars
from .._pipeline import level_of_caller
from ..light import _is_date, is_on_globe
from .picture import seen
from .reading import Reading

_ARGUMENTS = {"cloud_water": "liquid", "cloud_ice": "ice", "rain": "rain", "snow": "snow", "temperature": "temperature", "pressure": "pressure", "cloud_fraction": "cloud_fraction"}
AIR = "temperature"  # the array that is computed if the dataset has none
SLANT = 45.0  # degrees from the zenith, of a sun without a date and a direction
LOWEST_SUN = 5.0  # degrees above the horizon, by day


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
        given.update(_sun_of_data(reading.date, grid))
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


def _sun_of_data(date: str | None, grid: pyvista.DataSet) -> dict[str, Any]:
    """The sun at the date of the data. Without a date, or if it is night in the middle of what they show, a sun that shows them, with a warning."""
    middle = _middle(grid)
    if date is None or not _is_date(date):
        told = "the data have no date"
    elif middle is not None and _height_of_sun(date, middle, grid) < LOWEST_SUN:
        told = f"it is night in the middle of the data at their time, {date} UTC"
    else:
        return {"time": date}
    warnings.warn(f"sun=True: {told}, so that a sun {90 - SLANT:g} degrees above the horizon in the west lights their middle. For another sun give a date and time, sun='2020-06-21 12:00', or a direction.",
                  UserWarning, stacklevel=level_of_caller())
    return {"direction": _above(grid, middle)}


def _middle(grid: pyvista.DataSet) -> np.ndarray | None:
    """What the camera looks at: a point on a globe, None if the field is all around it, or the longitude and latitude in the middle of a map."""
    return middle_of(grid, seen(grid), default_scalars(grid)[1]) if is_on_globe(grid) else np.array(_middle_of_map(grid))


def _height_of_sun(date: str, middle: np.ndarray, grid: pyvista.DataSet) -> float:
    """Degrees above the horizon."""
    sun = vtkSunSource()
    sun.SetDateTime(date)
    if not is_on_globe(grid):
        sun.SetLongitude(middle[0])
        sun.SetLatitude(middle[1])
    sun.Update()
    found = pyvista.wrap(sun.GetOutput()).field_data
    sine = np.ravel(found["SunDirectionOnGlobe"]) @ middle / np.linalg.norm(middle) if is_on_globe(grid) else np.ravel(found["SunDirection"])[2]
    return float(np.degrees(np.arcsin(np.clip(sine, -1, 1))))


def _above(grid: pyvista.DataSet, middle: np.ndarray | None) -> np.ndarray:
    """A direction from the west of the zenith over the middle of the data."""
    if not is_on_globe(grid):
        return np.array([-1.0, -0.5, 1.0])
    up = np.array([0.27, -0.91, 0.32]) if middle is None else middle / np.linalg.norm(middle)
    west = np.cross(up, (0.0, 0.0, 1.0))
    west = west / np.linalg.norm(west) if np.linalg.norm(west) > 1e-6 else np.array([1.0, 0.0, 0.0])
    return np.cos(np.radians(SLANT)) * up + np.sin(np.radians(SLANT)) * west
