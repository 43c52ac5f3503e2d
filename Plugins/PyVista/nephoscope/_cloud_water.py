# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Water of clouds of which only the fraction is known: in a cloud 0.21 g/m3 at sea level, and less by a factor of e every 2.3 km of height (Hack 1998)."""
from __future__ import annotations

import math
import warnings
from typing import Any, Callable

import numpy as np
import pyvista

from ._fields import FLAT_GRID, preset_of_field
from ._pipeline import level_of_caller
from .weather.columns import geopotential_height, standard_air
from .weather.flat_air import FlatAir
from .weather.units import UnitsError, converted

CONTENT = 0.21e-3  # kg/m3, in clouds at sea level
PRECIPITABLE = 25.0  # kg/m2, of water vapour: the mean of the globe
SCALE_HEIGHT = 700.0 * math.log(1 + PRECIPITABLE)  # m
WATER, FRACTION, TEMPERATURE = "NephoscopeCloudWater", "NephoscopeCloudFraction", "NephoscopeTemperature"  # arrays that are removed afterwards


def is_fraction(mesh: pyvista.DataSet, name: str) -> bool:
    preset = preset_of_field(name, mesh)
    return preset is not None and preset.name == "clouds"


def usual_water(fraction: np.ndarray, heights: np.ndarray) -> np.ndarray:
    """The usual content of clouds in kg/m3; `heights` are in metres above sea level."""
    return np.clip(fraction, 0, 1) * CONTENT * np.exp(-np.clip(heights, 0, None) / SCALE_HEIGHT)


def words_for(name: str) -> str:
    """The warning that says what is assumed for the cloud fraction `name`."""
    return (f"There is no cloud water, but a cloud fraction, {name!r}: clouds have the water that is usual at their height, {1000 * CONTENT:g} g/m3 at sea level and less by a factor e every "
            f"{SCALE_HEIGHT / 1000:.1f} km (Hack 1998), times the fraction. If the data have cloud water, name it.")


def optics_of_fraction(mesh: pyvista.DataSet, options: dict[str, Any], make: Callable[..., pyvista.DataSet]) -> pyvista.DataSet | None:
    """What `make` returns for the mesh with water instead of its cloud fraction; None if it has no fraction, or no heights in metres. `options`: those of `cloud_optics`."""
    found = _fraction(mesh, options["cloud_fraction"])
    if found is None:
        return None
    name, data = found
    heights = _heights(mesh, data, options["height"])
    if heights is None:
        return None
    fraction = np.clip(_as_fraction(mesh, name, data), 0, 1)
    mesh = mesh.copy(deep=False)
    data = mesh.point_data if name in mesh.point_data else mesh.cell_data
    data[FRACTION], data[WATER] = fraction, usual_water(fraction, heights)
    given = {**options, "water": WATER, "cloud_fraction": FRACTION, "units": "kg/m3"}
    try:
        result = make(mesh, **given)
    except RuntimeError as problem:
        if "There is no temperature" not in str(problem):
            raise
        data[TEMPERATURE] = standard_air(geopotential_height(heights))[1]
        result = make(mesh, **{**given, "temperature": TEMPERATURE})
    for array in (WATER, FRACTION, TEMPERATURE):
        for data in (result.point_data, result.cell_data):
            if array in data:
                del data[array]
    warnings.warn(words_for(name), UserWarning, stacklevel=level_of_caller())
    return result


def _fraction(mesh: pyvista.DataSet, named: str) -> tuple[str, pyvista.DataSetAttributes] | None:
    """The array that is named, or the first one that is a cloud fraction, and whether it is on points or cells."""
    arrays = [(name, data) for data in (mesh.point_data, mesh.cell_data) for name in data if data[name].ndim == 1]
    return next(((name, data) for name, data in arrays if name == named or not named and is_fraction(mesh, name)), None)


def _heights(mesh: pyvista.DataSet, data: pyvista.DataSetAttributes, named: str) -> np.ndarray | None:
    if (named or "Height") in data:
        return np.nan_to_num(np.asarray(data[named or "Height"], float))
    return FlatAir(mesh).heights if FLAT_GRID in mesh.field_data and not named else None


def _as_fraction(mesh: pyvista.DataSet, name: str, data: pyvista.DataSetAttributes) -> np.ndarray:
    """From 0 to 1; without units, values above 1.5 are percent."""
    values, units = np.asarray(data[name], float), mesh.field_data.get(f"{name}_units")
    if units is not None:
        try:
            return converted(values, str(units[0]), "fraction", name)[0]
        except UnitsError:
            pass
    return values * (0.01 if np.nanmax(values, initial=0) > 1.5 else 1)
