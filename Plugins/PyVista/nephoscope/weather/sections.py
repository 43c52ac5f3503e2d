# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sections of the globe, at one longitude or one latitude or along a line, and means along these: a picture by position and height."""
from __future__ import annotations

from typing import Any, Dict, Tuple

import numpy as np
import pyvista

from ..globe import EARTH_RADIUS, is_map, planet_radius
from .placing import GROUND
from .scales import meridian, parallel
from .sea import is_sea

SHALLOW = 2000.0  # m: air that is lower has its heights in metres, as water has
SAME = 0.01  # degrees: longitudes or latitudes that differ less are one
Scales = Dict[str, Tuple[str, float]]  # of each axis the title, and the length of one unit in the scene


def as_section(dataset: Any) -> Any:
    """The dataset; if it has latitudes alone, or longitudes, with the other one as a dimension of one entry; see also `as_row`."""
    from .horizontal import is_latitude, is_longitude
    from .section_rows import as_row
    kinds = [{str(name): variable for name, variable in dataset.variables.items() if fits(str(name), variable)} for fits in (is_longitude, is_latitude)]
    for here, other, name in ((kinds[1], kinds[0], "longitude"), (kinds[0], kinds[1], "latitude")):
        along = [one for one in here if here[one].dims == (one,)]
        if not along or any(variable.ndim for variable in other.values()):
            continue
        if other:
            return dataset.expand_dims(next(iter(other)))
        units = "degrees_east" if name == "longitude" else "degrees_north"
        return dataset.expand_dims({name: [0.0]}).assign_coords({name: (name, [0.0], {"units": units, "standard_name": name})})
    return as_row(dataset)


def axis_of_section(grid: pyvista.DataSet) -> str | None:
    """"latitude" or "longitude", along which a grid of several levels extends; None for other grids."""
    longitudes, latitudes, levels = (*getattr(grid, "dimensions", ()), 0, 0, 0)[:3]
    if levels < 2 or (longitudes > 1) == (latitudes > 1):
        return None
    return "latitude" if longitudes == 1 else "longitude"


def is_section(grid: pyvista.DataSet) -> bool:
    """Whether `grid` is a section of the globe, or a mean along longitude or latitude."""
    return "GlobeGridProjection" in grid.field_data and axis_of_section(grid) is not None


def unrolled(grid: pyvista.StructuredGrid, shape: float, scales: Scales | None = None) -> tuple[pyvista.StructuredGrid, Scales]:
    """The section of a globe or a map in the plane y = 0, and the title and the length in the scene of one unit of x and z. `shape`: its height over its width there. Or
    `scales`, which this function has returned for another time, give the unit and the length of heights."""
    stretch = float(np.ravel(grid.field_data.get("VerticalExaggeration", [1.0]))[0]) or 1.0
    longitudes, latitudes, heights = _places(grid)
    title, across = _along(longitudes[0], latitudes[0])
    heights = heights / stretch
    if scales is None:
        unit = ("m", 1.0) if is_sea(grid) or np.nanmax(np.abs(heights)) < SHALLOW else ("km", 1000.0)
        scales = {"x": (title, 1.0), "z": (unit[0], shape * (_extent(across) or 1.0) / (_extent(heights / unit[1]) or 1.0))}
    unit, scale = scales["z"]
    scale /= 1.0 if unit == "m" else 1000.0
    sheet = grid.copy(deep=False)
    across = np.tile(across, len(heights))
    sheet.points = np.column_stack((across, 0 * across, np.ravel(scale * heights)))
    if GROUND in grid.field_data:
        sheet.field_data[GROUND] = scale * np.asarray(grid.field_data[GROUND])
    return sheet, scales


def _extent(values: np.ndarray) -> float:
    return float(np.nanmax(values) - np.nanmin(values))


def _places(grid: pyvista.StructuredGrid) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Longitudes and latitudes in degrees and exaggerated heights in metres, each in rows of one level."""
    points = np.asarray(grid.points, float).reshape(grid.dimensions[2], -1, 3)
    radius = planet_radius(grid)
    x, y, z = np.moveaxis(points, -1, 0)
    if is_map(grid):
        return np.degrees(x / radius), np.degrees(y / radius), z
    radii = np.linalg.norm(points, axis=-1)
    return np.degrees(np.unwrap(np.arctan2(y, x), axis=-1)), np.degrees(np.arcsin(np.clip(z / radii, -1, 1))), radii - radius


def _along(longitude: np.ndarray, latitude: np.ndarray) -> tuple[str, np.ndarray]:
    """The title of the axis along the section, and the positions on it: latitudes or longitudes where the other one is the same everywhere, otherwise kilometres from one end."""
    away = np.abs(latitude) < 90 - SAME  # from the poles, which have no longitude
    if _extent(longitude[away] if away.any() else longitude) < SAME:
        return "°N", latitude
    if _extent(latitude) < SAME:
        return "°E", longitude
    x, y = np.radians(longitude), np.radians(latitude)
    places = np.column_stack((np.cos(y) * np.cos(x), np.cos(y) * np.sin(x), np.sin(y)))
    steps = np.nan_to_num(2 * np.arcsin(0.5 * np.linalg.norm(np.diff(places, axis=0), axis=1)))
    distance = np.append(0.0, np.cumsum(steps)) * EARTH_RADIUS / 1000
    ends = [(longitude[0], latitude[0]), (longitude[-1], latitude[-1])]
    east, north = (ends[1][0] - ends[0][0]) * np.cos(y.mean()), ends[1][1] - ends[0][1]
    if (east if abs(east) >= abs(north) else north) < 0:  # the west on the left, or the south
        ends, distance = ends[::-1], distance[-1] - distance
    return "km from " + " to ".join(f"{parallel(north, '.1f')} {meridian(east, '.1f')}" for east, north in ends), distance
