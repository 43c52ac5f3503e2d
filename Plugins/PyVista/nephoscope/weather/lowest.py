# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that fill all of the air, such as the temperature: as a volume they are a haze in which nothing is seen, so that a first picture shows them at the ground."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .._fields import preset_of_field
from ..globe import is_map, planet_radius
from .prisms import HIDDEN_POINT
from .sea import is_sea

LOWEST = "LowestLevel"  # field array of such a level
FILLING = ("temperature",)  # presets of such fields


def fills_the_air(grid: pyvista.DataSet, name: str, options: dict[str, Any], of_volumes: tuple[str, ...] = ()) -> bool:
    """Whether a picture of the point array `name` of a volume is better one of its lowest level, unless one of the `options` is `of_volumes` or the opacity."""
    preset = preset_of_field(name, grid)
    return (isinstance(grid, pyvista.StructuredGrid) and min(grid.dimensions) > 1 and name in grid.point_data and preset is not None and preset.name in FILLING and not is_sea(grid)
            and not any(option in options for option in ("opacity", *of_volumes)))


def lowest_level(grid: pyvista.StructuredGrid, name: str) -> pyvista.StructuredGrid:
    """The values of the point array `name` in the lowest point of each column that is above the ground and has one, at the height 0 of the globe or the map."""
    columns, rows, levels = grid.dimensions
    values = np.asarray(grid.point_data[name]).reshape(levels, -1)
    hidden = np.asarray(grid.point_data.get("vtkGhostType", np.zeros(grid.n_points, np.uint8))).reshape(levels, -1) & HIDDEN_POINT > 0
    there = np.isfinite(values) & ~hidden
    first = np.argmax(there, axis=0)
    sheet = pyvista.StructuredGrid()
    sheet.points = _on_the_ground(grid, np.asarray(grid.points, float).reshape(levels, -1, 3)[first, np.arange(columns * rows)])
    sheet.dimensions = (columns, rows, 1)
    sheet.point_data[name] = np.where(there.any(axis=0), values[first, np.arange(columns * rows)], np.nan)
    sheet.GetFieldData().ShallowCopy(grid.GetFieldData())
    sheet.field_data[LOWEST] = [1]
    return sheet


def _on_the_ground(grid: pyvista.DataSet, points: np.ndarray) -> np.ndarray:
    if is_map(grid):
        return points * (1, 1, 0)
    return points * planet_radius(grid) / np.linalg.norm(points, axis=1)[:, None]
