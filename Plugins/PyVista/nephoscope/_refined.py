# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A globe with more columns of points, between which light is resolved and whose cells follow the sphere."""
from __future__ import annotations

import numpy as np
import pyvista

MOST_POINTS = 3_000_000
HIDDEN_POINT = 2  # vtkDataSetAttributes::HIDDENPOINT


def fitting_factor(mesh: pyvista.StructuredGrid, wanted: float) -> int:
    """Parts of each cell along longitude and latitude, so that the steps are at most `wanted` (degrees), as far as the number of points allows."""
    columns, rows, levels = mesh.dimensions
    factor = int(np.ceil(step_of(mesh) / wanted - 1e-3))
    most = np.sqrt(MOST_POINTS / max(1, (columns - 1) * (rows - 1) * levels))
    return max(1, min(factor, int(most)))


def step_of(mesh: pyvista.StructuredGrid) -> float:
    """The usual distance of neighbouring points along the rows and columns of a globe, the greater of the two, in degrees."""
    columns, rows, _ = mesh.dimensions
    level = _directions(mesh)[0]
    steps = [np.linalg.norm(np.diff(level, axis=axis), axis=-1) for axis in (0, 1) if level.shape[axis] > 1]
    return float(np.degrees(max((np.nanpercentile(step, 90) for step in steps if np.isfinite(step).any()), default=0.0)))


def _directions(mesh: pyvista.StructuredGrid) -> np.ndarray:
    places = np.asarray(mesh.points, float).reshape(*mesh.dimensions[::-1], 3)
    with np.errstate(invalid="ignore", divide="ignore"):
        return places / np.linalg.norm(places, axis=-1, keepdims=True)


def refined(mesh: pyvista.StructuredGrid, factor: int, names: dict[str, str | None]) -> pyvista.StructuredGrid:
    """`mesh` with `factor` times as many cells along longitude and latitude. The point arrays `names` are interpolated, weighted by the array that each names."""
    if factor < 2:
        return mesh
    columns, rows, levels = mesh.dimensions
    radii = np.linalg.norm(np.asarray(mesh.points, float), axis=1).reshape(levels, rows, columns)
    directions = _between(_directions(mesh), factor)
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    places = directions * _between(radii, factor)[..., None]
    fine = pyvista.StructuredGrid()
    fine.points = places.reshape(-1, 3)
    fine.dimensions = places.shape[2::-1]
    fine.GetFieldData().PassData(mesh.GetFieldData())
    for name, weight in names.items():
        values = np.asarray(mesh.point_data[name], float).reshape(levels, rows, columns)
        weights = np.asarray(np.isfinite(values), float)
        if weight is not None:
            weights *= np.nan_to_num(np.asarray(mesh.point_data[weight], float).reshape(values.shape)) + 1e-30
        sums = _between(weights, factor)
        found = np.divide(_between(weights * np.nan_to_num(values), factor), sums, out=np.full_like(sums, np.nan), where=sums > 0)
        fine.point_data[name] = found.astype(np.float32).ravel()
    if "vtkGhostType" in mesh.cell_data:
        fine.cell_data["vtkGhostType"] = _cells_hidden_alone(mesh).repeat(factor, axis=1).repeat(factor, axis=2).ravel()
    if "vtkGhostType" in mesh.point_data:
        hidden = (np.asarray(mesh.point_data["vtkGhostType"]) & HIDDEN_POINT != 0).astype(float).reshape(levels, rows, columns)
        fine.point_data["vtkGhostType"] = (HIDDEN_POINT * (_between(hidden, factor) > 0.5)).astype(np.uint8).ravel()
    return fine


def _cells_hidden_alone(mesh: pyvista.StructuredGrid) -> np.ndarray:
    """The marks of cells none of whose points is hidden: others are found again, from the points of the finer grid."""
    columns, rows, levels = mesh.dimensions
    marks = np.asarray(mesh.cell_data["vtkGhostType"]).reshape(levels - 1, rows - 1, columns - 1)
    if "vtkGhostType" not in mesh.point_data:
        return marks
    points = (np.asarray(mesh.point_data["vtkGhostType"]) & HIDDEN_POINT != 0).reshape(levels, rows, columns)
    touched = np.any([points[k:k + levels - 1, j:j + rows - 1, i:i + columns - 1] for k in (0, 1) for j in (0, 1) for i in (0, 1)], axis=0)
    return np.where(touched, 0, marks).astype(marks.dtype)


def _between(values: np.ndarray, factor: int) -> np.ndarray:
    """Linear interpolation along the second and third axis."""
    for axis in (1, 2):
        count = values.shape[axis]
        if count < 2:
            continue
        at = np.arange(factor * (count - 1) + 1)
        first = np.minimum(at // factor, count - 2)
        share = ((at - factor * first) / factor).reshape([-1 if i == axis else 1 for i in range(values.ndim)])
        values = values.take(first, axis) * (1 - share) + values.take(first + 1, axis) * share
    return values
