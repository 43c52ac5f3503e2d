# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flat data with another vertical axis, turned so that z is up."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .light import turned

VECTORS = ("SunDirection", "Up", "DiffuseFlux")


def matrix_of(up: np.ndarray) -> np.ndarray:
    """Rows of coordinates times this matrix are those with z up: of the shortest turn."""
    return np.column_stack([turned(axis, up) for axis in np.eye(3)])


def upright_mesh(mesh: pyvista.DataSet, matrix: np.ndarray) -> pyvista.DataSet:
    mesh = mesh.cast_to_structured_grid() if isinstance(mesh, (pyvista.ImageData, pyvista.RectilinearGrid)) else mesh.copy(deep=False)
    mesh.SetPoints(pyvista.vtk_points(np.asarray(mesh.points, float) @ matrix))  # mesh.points = ... would change those of the original
    for data in (mesh.field_data, mesh.point_data):
        for name in set(VECTORS) & set(data.keys()):
            data[name] = np.asarray(data[name]) @ matrix
    return mesh


def upright_sun(options: dict[str, Any], matrix: np.ndarray) -> dict[str, Any]:
    """The arguments of `sunlight` for the turned mesh."""
    turns = {name: np.asarray(value) @ matrix for name, value in options.items() if name in ("direction", "eye") and np.shape(value) == (3,)}
    if isinstance(options.get("clouds"), pyvista.DataSet):
        turns["clouds"] = upright_mesh(options["clouds"], matrix)
    return {**options, **turns, "up": "z"}
