# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a dataset in which a field has values: one that is on some of the levels of the others, or at some of their times."""
from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import pyvista

from .accessor import WeatherAccessor

if TYPE_CHECKING:
    import xarray

    from .reading import Reading

SEARCHED = 50  # times
BY_VALUES = ("pressure", "height", "depth")  # kinds of levels whose heights do not depend on the others


class Part(NamedTuple):
    """A part of a dataset in which a field has values, and the time to draw."""
    dataset: xarray.Dataset
    time: Any


def filled(dataset: xarray.Dataset, grid: pyvista.DataSet, name: str, time: Any, options: dict[str, Any]) -> Part | None:
    """What to draw instead of `grid`, the mesh of the dataset. None if the field has values on all levels; otherwise the first time
    at which it has any, or the levels on which it has some."""
    if not is_sparse(grid, name):
        return None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the mesh has given these warnings
        reading = WeatherAccessor(dataset)._reading(time, options)
    if time is None and (step := step_with_values(dataset, reading, name)) is not None:
        return Part(dataset, step)
    levels = on_own_levels(dataset, reading, name)
    return None if levels is None else Part(levels, time)


def is_sparse(grid: pyvista.DataSet, name: str) -> bool:
    """Whether the array has no value on some levels of the grid, or none at all."""
    data = grid.point_data if name in grid.point_data else grid.cell_data
    values = np.isfinite(np.asarray(data[name]))
    levels = grid.dimensions[2] if isinstance(grid, pyvista.StructuredGrid) and name in grid.point_data else 1
    return not values.reshape(levels, -1).any(axis=1).all()


def step_with_values(dataset: xarray.Dataset, reading: Reading, name: str) -> int | None:
    """The first time step at which the field has values, if it has none at the time that was read; None if there is no such step."""
    dim = next((dim for dim in reading.times if dataset.sizes.get(dim, 1) > 1), None)
    if dim is None or name not in dataset or dim not in dataset[name].dims or np.isfinite(reading.values(name)).any():
        return None
    steps = range(1, min(dataset.sizes[dim], SEARCHED))
    return next((step for step in steps if np.isfinite(np.asarray(dataset[name].isel({dim: step}), float)).any()), None)


def on_own_levels(dataset: xarray.Dataset, reading: Reading, name: str) -> xarray.Dataset | None:
    """The dataset on the levels at which the field has values, if it lacks them on a level between others: as a volume it would have gaps there; None if it does not."""
    vertical = reading.vertical
    if vertical is None or vertical.kind not in BY_VALUES or name not in dataset or vertical.dim not in dataset[name].dims:
        return None
    values = np.isfinite(np.asarray(reading.values(name), float))
    there = values.reshape(len(values), -1).any(axis=1)
    inner = there[slice(*(np.flatnonzero(there)[[0, -1]] + (0, 1)))] if there.any() else there
    return None if inner.all() or not there.any() else dataset.isel({vertical.dim: np.flatnonzero(there)})
