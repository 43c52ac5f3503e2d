# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a mesh on the globe, in one line."""
from __future__ import annotations

import numpy as np
import pyvista

from .._blocks import cell_dimension
from .._medium import association_of, default_scalars
from ..cells import add_cells
from ..globe import EARTH_RADIUS, globe_surface

GROUND = "#3d5a73"  # of the globe, without a texture

BAR = {"vertical": True, "position_x": 0.885, "position_y": 0.3, "width": 0.06, "height": 0.4, "title_font_size": 14, "label_font_size": 12, "n_labels": 4}  # beside the globe


def plotted(grid: pyvista.DataSet, scalars: str | None, screenshot: str | None, options: dict) -> pyvista.Plotter:
    plotter = pyvista.Plotter(off_screen=screenshot is not None, theme=pyvista.themes.DarkTheme(), window_size=(800, 800))
    on_globe = str(np.ravel(grid.field_data.get("GlobeGridProjection", ["globe"]))[0]).lower() not in ("1", "1.0", "map")
    flat = cell_dimension(grid) < 3
    if on_globe:
        plotter.add_mesh(globe_surface(radius=_below(grid) if flat else EARTH_RADIUS), color=GROUND, lighting=True)
    if flat:  # one level
        name = default_scalars(grid)[1] if scalars is None else scalars
        association_of(grid, name, "point", "scalars")  # raises an error if no value is finite; VTK would end the process
        plotter.add_mesh(grid, scalars=name, **{"nan_opacity": 0, "lighting": False, "scalar_bar_args": BAR, **options})
    else:
        add_cells(plotter, grid, scalars, **{"scalar_bar_args": BAR, **options})
    if on_globe:
        _look_down(plotter, grid)
    plotter.show(screenshot=screenshot or False, auto_close=False)
    return plotter


def _below(sheet: pyvista.DataSet) -> float:
    """A radius below the sheet's flat cells, which are also bent along a diagonal: that of the middle of the longest diagonal."""
    half = 0.5 * _longest_diagonal(sheet)
    return 0.998 * float(np.sqrt(np.clip(1 - (half / EARTH_RADIUS) ** 2, 0.64, 1))) * EARTH_RADIUS


def _longest_diagonal(sheet: pyvista.DataSet) -> float:
    points = np.asarray(sheet.points)
    if isinstance(sheet, pyvista.StructuredGrid):
        grid = points.reshape(*[size for size in sheet.dimensions[::-1] if size > 1], 3)
        sizes = np.linalg.norm(grid[1:, 1:] - grid[:-1, :-1], axis=-1) if grid.ndim == 3 else np.zeros(1)
    else:
        corners, starts = points[sheet.cell_connectivity], np.asarray(sheet.offset)[:-1]
        sizes = np.linalg.norm(np.maximum.reduceat(corners, starts) - np.minimum.reduceat(corners, starts), axis=1) if len(starts) else np.zeros(1)
    sizes = sizes[np.isfinite(sizes)]
    return float(sizes.max()) if sizes.size else 0.0


def _look_down(plotter: pyvista.Plotter, grid: pyvista.DataSet) -> None:
    """Places the camera above the middle of the data, far enough to show all of them, with north up."""
    points = np.asarray(grid.points)[:: max(1, grid.n_points // 5000)]
    points = points[np.isfinite(points).all(axis=1)]
    middle = points.mean(axis=0)
    if np.linalg.norm(middle) < 0.2 * EARTH_RADIUS:  # all round the globe
        middle = np.array([0.3, -1.0, 0.35]) * EARTH_RADIUS
    centre = middle if np.linalg.norm(middle) > 0.6 * EARTH_RADIUS and np.ptp(points, axis=0).max() < 1.2 * EARTH_RADIUS else np.zeros(3)
    size = np.linalg.norm(points - centre, axis=1).max()
    upward = middle / np.linalg.norm(middle)
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + upward * size * 4.5
    plotter.camera.up = (0, 0, 1) if abs(upward[2]) < 0.95 else (1, 0, 0)
    plotter.camera.SetWindowCenter(0.08, 0)  # room for the scalar bar
    plotter.reset_camera_clipping_range()
