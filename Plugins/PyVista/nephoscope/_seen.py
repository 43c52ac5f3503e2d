# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How dense a medium must be to be seen."""
from __future__ import annotations

import numpy as np
import pyvista

MEAN_OPTICAL_DEPTH = 2.0  # over the silhouette of the bounds
SAMPLES = 20_000          # cells of an unstructured grid that are measured
_OPACITY = "Nephoscope opacity"


def seen_distance(grid: pyvista.DataSet, values: np.ndarray, association: str, clim: tuple[float, float],
                  opacities: np.ndarray) -> float | None:
    """The unit distance that gives a medium of these opacities, at equal steps over `clim`, the mean optical depth `MEAN_OPTICAL_DEPTH`.

    None without cells, or if nothing is opaque. The mean silhouette of a convex body is a quarter of its surface (Cauchy's formula);
    the bounds are taken for a box around an ellipsoid, whose silhouette is pi/6 of the box's.
    """
    opacity = np.nan_to_num(np.interp(values, np.linspace(*clim, len(opacities)), opacities))
    cells = _shown_cells(grid)
    if len(cells) == 0:
        return None
    a, b, c = (grid.bounds[2 * axis + 1] - grid.bounds[2 * axis] for axis in range(3))
    silhouette = np.pi / 12 * (a * b + b * c + c * a)
    volumes, means, every = _measured(grid, cells, opacity, association)
    distance = every * float(np.sum((means * volumes)[np.isfinite(volumes)])) / (MEAN_OPTICAL_DEPTH * silhouette or 1.0)
    return distance if np.isfinite(distance) and distance > 0 else None


def _shown_cells(grid: pyvista.DataSet) -> np.ndarray:
    ghosts = grid.cell_data.get("vtkGhostType")
    return np.arange(grid.n_cells) if ghosts is None else np.flatnonzero(np.asarray(ghosts) == 0)


def _measured(grid: pyvista.DataSet, cells: np.ndarray, opacity: np.ndarray, association: str) -> tuple[np.ndarray, np.ndarray, float]:
    """Volumes and mean opacities of `cells`, or of an even share of them, and how many each of these stands for."""
    if min(getattr(grid, "dimensions", (1,))) > 1:
        shape = tuple(reversed(grid.dimensions))
        means = _corner_mean(opacity.reshape(shape)).ravel() if association == "point" else opacity
        return _box_volumes(grid, shape).ravel()[cells], means[cells], 1.0
    chosen = cells[::max(1, len(cells) // SAMPLES)]
    bare = grid.copy(deep=False)
    bare.clear_data()
    (bare.point_data if association == "point" else bare.cell_data)[_OPACITY] = opacity
    bare = bare.extract_cells(chosen)
    if association == "point":
        bare = bare.point_data_to_cell_data()
    volumes = np.abs(bare.compute_cell_sizes(length=False, area=False)["Volume"])
    return volumes, np.asarray(bare.cell_data[_OPACITY]), len(cells) / len(chosen)


def _corner_mean(values: np.ndarray) -> np.ndarray:
    for axis in range(3):
        first, last = [slice(None)] * 3, [slice(None)] * 3
        first[axis], last[axis] = slice(None, -1), slice(1, None)
        values = 0.5 * (values[tuple(first)] + values[tuple(last)])
    return values


def _box_volumes(grid: pyvista.DataSet, shape: tuple[int, int, int]) -> np.ndarray:
    """Of the parallelepipeds spanned by the mean edges of the cells of a structured grid."""
    points = np.asarray(grid.points, float).reshape(*shape, 3)
    edges = []
    for axis in range(3):
        edge = np.diff(points, axis=axis)
        for other in {0, 1, 2} - {axis}:
            first, last = [slice(None)] * 3, [slice(None)] * 3
            first[other], last[other] = slice(None, -1), slice(1, None)
            edge = 0.5 * (edge[tuple(first)] + edge[tuple(last)])
        edges.append(edge)
    return np.abs(np.einsum("...i,...i", np.cross(edges[0], edges[1]), edges[2]))
