# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that vary little within a level, such as the geopotential height. As a volume they are a slab of uniform layers, so a first picture shows their departures from the mean."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .._fields import PRESET_ENDING
from ..globe import is_map, planet_radius
from .prisms import HIDDEN_CELL, HIDDEN_POINT, LEVEL_SIZE

BAND, SECTOR = 5.0, 30.0  # degrees of latitude with one mean; degrees of longitude: data around the globe have points in all sectors


def departures(grid: pyvista.DataSet, name: str) -> tuple[pyvista.DataSet, str]:
    """`grid` with the array `name` minus its mean in each level or, for data around the globe, minus its zonal mean in each level; and words that say which."""
    on_points = name in grid.point_data
    data, mark = (grid.point_data, HIDDEN_POINT) if on_points else (grid.cell_data, HIDDEN_CELL)
    values = np.array(data[name], float)
    places = np.asarray(grid.points if on_points else grid.cell_centers().points, float)
    there = np.isfinite(values) & (np.asarray(data.get("vtkGhostType", np.zeros(len(values), np.uint8))) & mark == 0)
    size = int(grid.field_data[LEVEL_SIZE][0 if on_points else 1]) if LEVEL_SIZE in grid.field_data else grid.dimensions[0] * grid.dimensions[1]
    longitude, latitude = _degrees(grid, places)
    around = latitude is not None and len(np.unique(longitude[there] // SECTOR)) >= 360 / SECTOR
    bands = np.floor((latitude + 90) / BAND + 0.001).astype(int) if around else np.zeros(len(values), int)
    means = np.full(len(values), np.nan)
    for start in range(0, len(values), size):
        level = slice(start, start + size)
        means[level] = _means(values[level], there[level], bands[level], latitude[level] if around else bands[level])
    found = grid.copy(deep=False)
    found.field_data[name + PRESET_ENDING] = ["wind component"]
    (found.point_data if on_points else found.cell_data)[name] = (values - means).astype(np.float32)
    return found, f"minus {'zonal' if around else 'level'} mean"


def _degrees(grid: pyvista.DataSet, places: np.ndarray) -> tuple[Any, Any]:
    """Longitudes and latitudes; None for a flat grid."""
    if "GlobeGridProjection" not in grid.field_data:
        return None, None
    x, y, z = places.T
    longitude, latitude = (x / planet_radius(grid), y / planet_radius(grid)) if is_map(grid) else (np.arctan2(y, x), np.arctan2(z, np.hypot(x, y)))
    return np.degrees(longitude) % 360, np.nan_to_num(np.degrees(latitude))


def _means(values: np.ndarray, there: np.ndarray, bands: np.ndarray, latitudes: np.ndarray) -> np.ndarray:
    """For each value the mean of its band, interpolated between the mean latitudes of bands; NaN if there are no values."""
    count = np.bincount(bands[there], minlength=1)
    if not count.any():
        return np.full(len(values), np.nan)
    filled = count > 0
    means, middles = (np.bincount(bands[there], one[there])[filled] / count[filled] for one in (values, latitudes))
    return np.interp(latitudes, middles, means)
