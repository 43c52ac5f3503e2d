# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Media of one colour and one extinction: those of meshes without arrays, or with `color` instead of scalars."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from ._fields import is_bright, is_helper

FAINTER = 5.0  # than a medium with scalars: its shape is seen by its opacity alone


def is_bare(mesh: pyvista.DataSet) -> bool:
    """True if nothing in the mesh could be scalars: there are no arrays, or only normals, texture coordinates, VTK's ids and the like."""
    return all(name.startswith("vtk") or is_helper(name) and data[name].ndim > 1 for data in (mesh.point_data, mesh.cell_data) for name in data.keys())


def uniform_colours(plotter: pyvista.BasePlotter, color: Any, cmap: Any) -> Any:
    """The colour map of one colour: without `color` it is `cmap`, or else the theme's colour for meshes. PyVista's own would be pale on a bright background."""
    if color is None and cmap is not None:
        return cmap
    if color is None:
        pale = plotter.theme.color in (pyvista.themes.Theme().color, pyvista.themes.DocumentTheme().color) and is_bright(plotter.background_color)
        color = "steelblue" if pale else plotter.theme.color
    return [pyvista.Color(color).hex_rgb] * 2


def concentration(points: np.ndarray) -> float:
    """Mean number of neighbours on a line of sight, over that of points evenly spread in the same bounds: 1 or more; 4 for normally distributed points."""
    points = np.asarray(points, float)
    points = points[np.isfinite(points).all(axis=1)]
    if len(points) < 100:
        return 1.0
    found = []
    for axis in range(3):
        seen = np.delete(points, axis, axis=1)
        bins = max(2, int(np.sqrt(len(points) / 8)))
        size = np.ptp(seen, axis=0)
        if not size.all():
            continue
        counts, _, _ = np.histogram2d(*seen.T, bins=bins)
        found.append((counts * (counts - 1)).sum() / len(points) / counts.mean())  # a point is not its own neighbour
    return max(1.0, float(np.mean(found))) if found else 1.0
