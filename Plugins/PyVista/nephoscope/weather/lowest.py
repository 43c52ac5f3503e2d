# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that fill all of the air, such as the temperature: as a volume they are a haze in which nothing is seen, so that a first picture shows them at the ground."""
from __future__ import annotations

import numpy as np
import pyvista

from ..globe import is_map, planet_radius
from .prisms import HIDDEN_CELL, HIDDEN_POINT, LEVEL_SIZE, bases


def lowest_level(grid: pyvista.StructuredGrid | pyvista.UnstructuredGrid, name: str) -> tuple[pyvista.StructuredGrid | pyvista.UnstructuredGrid, str]:
    """The values of the array `name` in the lowest point or cell of each column that is above the ground and has one, at the height 0 of the globe or the map.
    `grid`: structured, with the array on points, or as `place_columns` makes it."""
    on_points = name in grid.point_data
    data, mark = (grid.point_data, HIDDEN_POINT) if on_points else (grid.cell_data, HIDDEN_CELL)
    points, cells = (grid.dimensions[0] * grid.dimensions[1], 0) if isinstance(grid, pyvista.StructuredGrid) else map(int, grid.field_data[LEVEL_SIZE])
    columns = np.arange(points if on_points else cells)
    values = np.asarray(data[name]).reshape(-1, len(columns))
    hidden = np.asarray(data.get("vtkGhostType", np.zeros(values.size, np.uint8))).reshape(values.shape) & mark > 0
    there = np.isfinite(values) & ~hidden
    first = np.argmax(there, axis=0)
    places = np.asarray(grid.points, float).reshape(-1, points, 3)
    sheet = _level(grid, cells, _on_the_ground(grid, places[first, columns] if on_points else places[0]))
    (sheet.point_data if on_points else sheet.cell_data)[name] = np.where(there.any(axis=0), values[first, columns], np.nan)
    sheet.GetFieldData().ShallowCopy(grid.GetFieldData())
    if LEVEL_SIZE in sheet.field_data:
        sheet.field_data.remove(LEVEL_SIZE)
    return sheet, "lowest level"


def _level(grid: pyvista.DataSet, cells: int, points: np.ndarray) -> pyvista.StructuredGrid | pyvista.UnstructuredGrid:
    """The lowest level of the grid, with these points. `cells`: their number in a level of columns."""
    if not isinstance(grid, pyvista.StructuredGrid):
        return bases(grid, cells, points)
    sheet = pyvista.StructuredGrid()
    sheet.points, sheet.dimensions = points, (*grid.dimensions[:2], 1)
    return sheet


def _on_the_ground(grid: pyvista.DataSet, points: np.ndarray) -> np.ndarray:
    if is_map(grid):
        return points * (1, 1, 0)
    return points * planet_radius(grid) / np.linalg.norm(points, axis=1)[:, None]
