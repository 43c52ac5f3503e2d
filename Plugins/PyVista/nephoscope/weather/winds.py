# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winds of a reading: eastward, northward and upward, in m/s."""
from __future__ import annotations

import numpy as np

from .air import Air
from .columns import upward_wind
from .units import UnitsError


def along_grid(reading) -> bool:
    """True if the wind's components are along the grid's rows and columns."""
    variable = reading.dataset[reading.roles["u"]]
    stated = variable.attrs.get("GRIB_uvRelativeToGrid")
    if stated is not None:
        return bool(int(stated))
    if variable.attrs.get("GRIB_gridType") in ("polar_stereographic", "lambert", "rotated_ll"):  # cfgrib gives no direction, and calls every u eastward_wind
        reading.warn(f"{reading.roles['u']!r} is used as eastward: the dataset does not say whether it is along the grid ({variable.attrs['GRIB_gridType']}). Open the file with "
                     f"nephoscope.open, which knows, or set ds[{reading.roles['u']!r}].attrs['GRIB_uvRelativeToGrid'] = 1.")
        return False
    standard = str(variable.attrs.get("standard_name", ""))
    if standard in ("eastward_wind", "eastward_sea_water_velocity"):
        return False
    if standard in ("x_wind", "grid_eastward_wind", "sea_water_x_velocity") or variable.attrs.get("nephoscope_along_grid") or "xi_u" in variable.dims:
        return True
    if not reading.horizontal.is_regular and not standard:
        reading.note(f"{reading.roles['u']!r} is used as eastward: nothing says that it is along the grid (standard_name x_wind, GRIB_uvRelativeToGrid)")
    return False


def winds(reading, air: Air) -> tuple[list[np.ndarray], list[str]]:
    """[u, v] or [u, v, w], and the names of their variables; empty lists if a horizontal wind is missing."""
    if not reading.has_winds():
        return [], []
    u, v = reading.role("u"), reading.role("v")
    if along_grid(reading) and not reading.horizontal.is_regular:
        u, v = turned(u, v, *direction(reading))
    if reading.horizontal.caps:
        u, v = reading.horizontal.caps.winds(u, v, *reading.horizontal.places())
    found, names = [u, v], [reading.roles["u"], reading.roles["v"]]
    w = _upward(reading, air) if reading.has("w") else None
    return (found + [w], names + [reading.roles["w"]]) if w is not None else (found, names)


def turned(u, v, cosine, sine):
    return u * cosine - v * sine, u * sine + v * cosine


def direction(reading) -> tuple[np.ndarray, np.ndarray]:
    """Cosine and sine of the angle from east to the rows: from the file, otherwise from the projection, otherwise from point to point."""
    dataset = reading.dataset
    if {"COSALPHA", "SINALPHA"} <= set(dataset.variables) and set(dataset["COSALPHA"].dims) == set(reading.horizontal.dims):
        reading.note("winds rotated from the grid to east and north by COSALPHA and SINALPHA")
        return reading.values("COSALPHA"), reading.values("SINALPHA")
    angles = reading.horizontal.angles()
    by = reading.horizontal.projection.name if reading.horizontal.projection else "the positions of neighbouring points"
    reading.note(f"winds rotated from the grid to east and north by {by}, {np.degrees(np.nanmin(angles)):.1f} to {np.degrees(np.nanmax(angles)):.1f} degrees")
    return np.cos(angles), np.sin(angles)


def _upward(reading, air: Air) -> np.ndarray | None:
    try:
        values, quantity = reading.role_as("w")
    except UnitsError as problem:
        reading.warn(f"The vertical wind is left out. {problem}")
        return None
    if quantity == "speed":
        return values
    if air.pressure is None:
        reading.note(f"{reading.roles['w']!r} is in Pa/s, but no pressure is known: the vertical wind is left out")
        return None
    reading.note(f"{reading.roles['w']!r} converted from Pa/s to m/s")
    return upward_wind(values, air.pressure, air.temperature_or_standard)
