# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The vertical exaggeration of a first picture, in which the data are neither a sheet nor a tower."""
from __future__ import annotations

import warnings
from typing import Any, Callable

import numpy as np
import pyvista

from .._medium import text_colour
from ..globe import EARTH_RADIUS, is_map
from .sea import is_sea

USUAL = 30.0  # on a globe or a map; data whose x and y are lengths have 1
ROUND = (1.0, 2.0, 3.0, 5.0, 10.0, 15.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0)
HIGHEST = 0.4  # of the width of the data, or of the radius of the planet: their height on a globe or a map
DEEP, DEEPEST = 0.25, 0.1  # of the width, and of the radius at most: the depth of water, whose sides are to be seen
FLATTEST, RAISED = 0.1, 0.25  # of the width: flat data that are lower than the first are drawn with the second height at most
FLATTEST_SECTION, RAISED_SECTION = 0.2, 0.5


def suited(make: Callable[[float], pyvista.DataSet], usual: float) -> pyvista.DataSet:
    """The mesh that `make` makes with the exaggeration that suits it: with `usual` or, where another suits it, made again."""
    grid = make(usual)
    factor = suitable(grid, usual)
    if factor == usual:
        return grid
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # all has been told
        return make(factor)


def suitable(grid: pyvista.DataSet, made: float) -> float:
    """The exaggeration that suits the mesh, which was made with the exaggeration `made`."""
    points = np.asarray(grid.points, float)
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return made
    if "GlobeGridProjection" not in grid.field_data:
        return _of_flat(grid, np.ptp(points, axis=0), made)
    width, height = _measured(grid, points)
    height /= made
    if height > 0 and width > 0 and is_sea(grid):
        return _rounded(min(DEEP * width, DEEPEST * _radius(grid)) / height)
    return made if height <= 0 or width <= 0 or made * height <= HIGHEST * width else _rounded(HIGHEST * width / height)


def _radius(grid: pyvista.DataSet) -> float:
    return float(np.ravel(grid.field_data.get("PlanetRadius", [EARTH_RADIUS]))[0])


def _measured(grid: pyvista.DataSet, points: np.ndarray) -> tuple[float, float]:
    """Width, at most the radius of the planet, and height above the sea or below it."""
    radius = _radius(grid)
    if is_map(grid):
        return min(radius, float(np.ptp(points[:, :2], axis=0).max())), float(np.abs(points[:, 2]).max())
    radii = np.linalg.norm(points, axis=1)
    return min(radius, radius * float(np.ptp(points / radii[:, None], axis=0).max())), float(np.abs(radii - radius).max())


def _of_flat(grid: pyvista.DataSet, spans: np.ndarray, made: float) -> float:
    width, height = float(spans[:2].max()), float(spans[2]) / made
    flattest, raised = (FLATTEST_SECTION, RAISED_SECTION) if 1 in getattr(grid, "dimensions", ()) else (FLATTEST, RAISED)
    return made if height <= 0 or made * height >= flattest * width else _rounded(raised * width / height)


def _rounded(factor: float) -> float:
    """The largest round number that is not larger; at least 1."""
    return max([number for number in ROUND if number <= 1.000001 * factor], default=1.0)


def write_exaggeration(plotter: Any, grid: pyvista.DataSet) -> None:
    """Writes an exaggeration of flat data, which have none unless it is needed, into the picture."""
    factor = float(np.ravel(grid.field_data.get("VerticalExaggeration", [1.0]))[0])
    if factor != 1:
        plotter.add_text(f"heights x {factor:g}", position=(0.02, 0.02), viewport=True, font_size=8, color=text_colour(plotter), name="vertical_exaggeration")
