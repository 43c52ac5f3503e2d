# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes whose values follow the time: colours and opacities are made for all steps, not for the one that is shown."""
from __future__ import annotations

import weakref
from typing import Any

import numpy as np
import pyvista

_series: weakref.WeakValueDictionary[str, Any] = weakref.WeakValueDictionary()  # by the address of the mesh


def follow(mesh: pyvista.DataSet, series: Any) -> None:
    """From now on `mesh` is the one whose values `series` exchanges."""
    _series[mesh.memory_address] = series


def values_over_time(grid: pyvista.DataSet, name: str, association: str) -> np.ndarray:
    """The values of the array, or, of the mesh of a series, values (of vectors, their lengths) of all its steps with their least and greatest."""
    values = (grid.point_data if association == "point" else grid.cell_data)[name]
    series = _series.get(grid.memory_address)
    return values if series is None else np.concatenate(series.samples(name))


def densest(grid: pyvista.DataSet, name: str, opacity: Any) -> pyvista.DataSet:
    """The grid, or, of the mesh of a series, that of the step with the greatest mean of the function `opacity`."""
    series = _series.get(grid.memory_address)
    if series is None:
        return grid
    return series.greatest(name, lambda values: np.mean([opacity.GetValue(value) for value in values]))
