# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The land and the sea floor in a section: what lies below the water, and what lies below the ground."""
from __future__ import annotations

import numpy as np
import pyvista

from .._over_time import follows
from .placing import GROUND
from .prisms import HIDDEN_POINT
from .sea import is_sea

LAND = (0.42, 0.38, 0.34)  # seen before black and before white


def ground_of(sheet: pyvista.StructuredGrid) -> list[pyvista.DataSet]:
    """The land in a section. In the sea, it is behind the water. In the air, it is in front, up to the height of the ground or, if that is not known, up to the highest point below the ground."""
    if is_sea(sheet):
        return [_moved(_quads(sheet), 1), _moved(_under(sheet, sheet.points[: _columns(sheet), 2]), 1)]
    if GROUND in sheet.field_data:
        heights = np.maximum(sheet.field_data[GROUND], sheet.bounds[4])
        return [_moved(_under(sheet, heights), -1)] if heights.max() > sheet.bounds[4] else []
    below = np.asarray(sheet.point_data.get("BelowGround", np.zeros(sheet.n_points))) > 0
    heights = np.where(below, sheet.points[:, 2], sheet.bounds[4]).reshape(-1, _columns(sheet)).max(axis=0)
    return [_moved(_under(sheet, heights), -1)] if np.ptp(heights) > 0 else []


def _columns(sheet: pyvista.StructuredGrid) -> int:
    return sheet.n_points // sheet.dimensions[2]


def _moved(part: pyvista.DataSet, side: int) -> pyvista.DataSet:
    """Behind the section, or before it."""
    part.points = np.asarray(part.points) + (0, side * 1e-3 * (part.length or 1.0), 0)
    return part


def _under(sheet: pyvista.StructuredGrid, heights: np.ndarray) -> pyvista.StructuredGrid:
    """What is between the lowest point of a section and the `heights`, one for each column."""
    lower = np.array(sheet.points[: _columns(sheet)])
    upper = lower.copy()
    lower[:, 2], upper[:, 2] = sheet.bounds[4], heights
    grid = pyvista.StructuredGrid()
    grid.points, grid.dimensions = np.concatenate([lower, upper]), (len(upper), 1, 2)
    return grid


def visible(sheet: pyvista.DataSet, name: str) -> pyvista.DataSet:
    """The quadrilaterals of a grid of two dimensions that have a value of the point array `name` at all corners, unless it is one whose values follow the time of the air, and a corner that is
    not hidden; with the arrays of the grid. The grid, if these are all. VTK draws the half of a quadrilateral that has three values, if its diagonal leaves one."""
    if name not in sheet.point_data or sum(size > 1 for size in getattr(sheet, "dimensions", ())) != 2:
        return sheet
    values = np.asarray(sheet.point_data[name]).reshape(sheet.n_points, -1)
    there = np.isfinite(values).all(axis=1) if is_sea(sheet) or not follows(sheet) else np.ones(sheet.n_points, bool)
    hidden = np.asarray(sheet.point_data.get("vtkGhostType", np.zeros(sheet.n_points, np.uint8))) & HIDDEN_POINT > 0
    if (there & ~hidden).all() or not there.any():
        return sheet
    found = _quads(sheet, there, ~hidden)
    found.GetPointData().ShallowCopy(sheet.GetPointData())
    found.GetFieldData().ShallowCopy(sheet.GetFieldData())
    found.GetPointData().RemoveArray("vtkGhostType")
    return found


def _quads(sheet: pyvista.DataSet, needed: np.ndarray | None = None, wanted: np.ndarray | None = None) -> pyvista.PolyData:
    """The quadrilaterals of a grid of two dimensions, whose corners are all `needed` and some `wanted`, without arrays. A film moves their points."""
    ids = np.arange(sheet.n_points).reshape([size for size in sheet.dimensions[::-1] if size > 1])
    corners = np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], axis=-1).reshape(-1, 4)
    if needed is not None and wanted is not None:
        corners = corners[needed[corners].all(axis=1) & wanted[corners].any(axis=1)]
    found = pyvista.PolyData()
    found.SetPoints(sheet.GetPoints() if isinstance(sheet, pyvista.StructuredGrid) else pyvista.vtk_points(sheet.points))
    found.faces = np.insert(corners, 0, 4, axis=1).ravel()
    return found
