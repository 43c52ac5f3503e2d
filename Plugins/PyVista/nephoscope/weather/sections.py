# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sections of the globe, at one longitude or one latitude, and means along these: a picture of places and heights."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from ..globe import EARTH_RADIUS


def as_section(dataset: Any) -> Any:
    """The dataset; if it has latitudes alone, or longitudes, with the other one as a dimension of one entry."""
    from .horizontal import is_latitude, is_longitude
    kinds = [{str(name): variable for name, variable in dataset.variables.items() if fits(str(name), variable)} for fits in (is_longitude, is_latitude)]
    for here, other, name in ((kinds[1], kinds[0], "longitude"), (kinds[0], kinds[1], "latitude")):
        along = [one for one in here if here[one].dims == (one,)]
        if not along or any(variable.ndim for variable in other.values()):
            continue
        if other:
            return dataset.expand_dims(next(iter(other)))
        units = "degrees_east" if name == "longitude" else "degrees_north"
        return dataset.expand_dims({name: [0.0]}).assign_coords({name: (name, [0.0], {"units": units, "standard_name": name})})
    return dataset


def axis_of_section(grid: pyvista.DataSet) -> str | None:
    """"latitude" or "longitude", along which a grid of several levels extends; None for other grids."""
    longitudes, latitudes, levels = (*getattr(grid, "dimensions", ()), 0, 0, 0)[:3]
    if levels < 2 or (longitudes > 1) == (latitudes > 1):
        return None
    return "latitude" if longitudes == 1 else "longitude"


def unrolled(grid: pyvista.StructuredGrid, shape: float, scale: float | None = None) -> tuple[pyvista.StructuredGrid, dict[str, tuple[str, float]]]:
    """The section of a globe or a map in the plane y = 0, and the title and the length in the scene of one unit of x and z. `shape`: its height over its width there, unless `scale` is the length of 1 km."""
    points = np.asarray(grid.points, float)
    radius = float(np.ravel(grid.field_data.get("PlanetRadius", [EARTH_RADIUS]))[0])
    stretch = float(np.ravel(grid.field_data.get("VerticalExaggeration", [1.0]))[0]) or 1.0
    along = axis_of_section(grid)
    if str(np.ravel(grid.field_data["GlobeGridProjection"])[0]).lower() in ("1", "1.0", "map"):
        degrees, heights = np.degrees(points[:, 1 if along == "latitude" else 0] / radius), points[:, 2]
    else:
        radii = np.linalg.norm(points, axis=1)
        angles = np.arcsin(np.clip(points[:, 2] / radii, -1, 1)) if along == "latitude" else np.arctan2(points[:, 1], points[:, 0])
        degrees, heights = np.degrees(angles), radii - radius
    if along == "longitude":
        rows = np.radians(degrees.reshape(grid.dimensions[::-1])[:, 0, :])
        degrees = np.ravel(np.degrees(np.unwrap(rows, axis=-1)))
    heights = heights / (1000.0 * stretch)  # km
    scale = scale or shape * (np.ptp(degrees) or 1.0) / (np.ptp(heights) or 1.0)
    sheet = grid.copy(deep=False)
    sheet.points = np.column_stack((degrees, 0 * degrees, scale * heights))
    sign = "°N" if along == "latitude" else "°E"
    return sheet, {"x": (sign, 1.0), "z": ("km", scale)}
