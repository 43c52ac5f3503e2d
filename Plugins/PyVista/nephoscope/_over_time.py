# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes whose values follow the time: colours and opacities suit all steps, not only the current one."""
from __future__ import annotations

import weakref
from typing import Any

import numpy as np
import pyvista

from ._components import reduced

_series: weakref.WeakValueDictionary[str, Any] = weakref.WeakValueDictionary()  # by the address of the mesh


def follow(mesh: pyvista.DataSet, series: Any) -> None:
    """Registers `mesh` as the mesh whose values `series` replaces."""
    _series[mesh.memory_address] = series


def follows(mesh: pyvista.DataSet) -> bool:
    """Whether the values of the mesh follow a series; at some times it may be empty."""
    return mesh.memory_address in _series


def values_over_time(grid: pyvista.DataSet, name: str, association: str, component: int | None = None) -> np.ndarray:
    """The values of the array (for vectors, their lengths, or the component). For the mesh of a series they are sampled from all steps, including the minimum and maximum."""
    series = _series.get(grid.memory_address)
    if series is not None:
        return np.concatenate(series.samples(name, component))
    return reduced((grid.point_data if association == "point" else grid.cell_data)[name], component)


def densest(grid: pyvista.DataSet, name: str, opacity: Any, component: int | None = None) -> pyvista.DataSet:
    """The grid; for the mesh of a series, the grid of the step with the largest mean of the function `opacity` of the values, as `values_over_time` takes them."""
    series = _series.get(grid.memory_address)
    if series is None:
        return grid
    return series.step_with_greatest(name, lambda values: np.mean([opacity.GetValue(value) for value in values]), component)


def lengths_of_vectors(grid: pyvista.DataSet, name: str) -> np.ndarray:
    """The lengths above 0 of the vectors in all steps of the series whose mesh is the grid; empty for another grid."""
    series = _series.get(grid.memory_address)
    lengths = np.zeros(0) if series is None else np.concatenate(series.samples(name))
    return lengths[lengths > 0]


def step_with_greatest(grid: pyvista.DataSet, name: str) -> pyvista.DataSet:
    """The grid; for the mesh of a series, the grid of the step whose values, or lengths of vectors, have the largest mean."""
    series = _series.get(grid.memory_address)
    return grid if series is None else series.step_with_greatest(name, np.mean)
