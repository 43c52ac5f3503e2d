# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Argument checks shared by the techniques. Every message names the argument and what would be accepted."""
from __future__ import annotations

import math
import warnings
from typing import Any, Callable, Mapping, Sequence

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError


def listed(names: Sequence[str]) -> str:
    """`names` as "'a', 'b'", or "none"."""
    return ", ".join(repr(name) for name in names) or "none"


WINDS = ("Wind", "DisplayVelocity")  # the output of globe() for the winds
NO_WINDS = 'globe() found no winds in the data. Name them, for example globe(wind=("ua", "va")).'


def arrays_of(mesh: pyvista.DataSet, wanted: str = "") -> str:
    """The sentence that ends a message about a missing array, `wanted`."""
    arrays = f"Point arrays: {listed(mesh.point_data.keys())}; cell arrays: {listed(mesh.cell_data.keys())}."
    return f"{arrays} {NO_WINDS}" if wanted in WINDS and _is_without_winds(mesh) else arrays


def _is_without_winds(mesh: pyvista.DataSet) -> bool:
    return "GlobeGridProjection" in mesh.field_data and not any(name in mesh.array_names for name in WINDS)


def require_winds(mesh: pyvista.DataSet) -> None:
    """Raises MissingDataError for output of globe() that has neither winds nor other vectors."""
    vectors = [name for data in (mesh.point_data, mesh.cell_data) for name in data.keys() if data[name].ndim == 2 and data[name].shape[1] == 3]
    if _is_without_winds(mesh) and not vectors:
        raise MissingDataError(f"mesh has no velocity. {NO_WINDS} {arrays_of(mesh)}")


def require_array(mesh: pyvista.DataSet, name: str, argument: str) -> None:
    """Raises MissingDataError (a ValueError) unless `mesh` has a point or cell array `name`."""
    if name not in mesh.point_data and name not in mesh.cell_data:
        raise MissingDataError(f"{argument}: no array {name!r}. {arrays_of(mesh, name)}")


def require_beside_scalars(mesh: pyvista.DataSet, name: str, association: str, argument: str) -> None:
    """Raises ValueError unless the array `name` has the association of the scalars, "point" or "cell"."""
    here, there = (mesh.point_data, mesh.cell_data) if association == "point" else (mesh.cell_data, mesh.point_data)
    if name in here:
        return
    if name in there:
        remedy = "cell_data_to_point_data()" if association == "point" else "point_data_to_cell_data()"
        raise ValueError(f"{argument}: the array {name!r} must be on {association}s, like the scalars: use mesh.{remedy}.")
    raise MissingDataError(f"{argument}: no array {name!r}. {arrays_of(mesh, name)}")


def choose(choices: Mapping[str, Callable[[], None]], value: str, argument: str) -> None:
    """Calls the function in `choices` for `value`; raises ValueError with the list of choices if there is none."""
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{argument} is {value!r}; it must be one of {listed(list(choices))}.")
    choices[value]()


def renamed_argument(value: float | None, name: str, old_value: float | None, old_name: str) -> float | None:
    """`value`, or the value given by the argument's old name, with a DeprecationWarning at the caller of the package's function."""
    if old_value is None:
        return value
    if value is not None:
        raise ValueError(f"{name} and {old_name} are both given; {old_name} is the old name of {name}.")
    warnings.warn(f"{old_name} is now called {name}, as in pyvista.Plotter.add_volume.", DeprecationWarning, stacklevel=3)
    return old_value


def as_array(values: Any) -> np.ndarray:
    """`values` as an array that VTK can hold: masked values are NaN, and numbers of 16 or more than 64 bits become those of 32 or 64."""
    if isinstance(values, np.ma.MaskedArray):
        masked = np.ma.getmaskarray(values)
        values = np.asarray(values.data)
        if masked.any() and values.dtype.kind in "biuf":
            values = np.where(masked, np.nan, values if values.dtype.kind == "f" else values.astype(float))
    values = np.asarray(values)
    if values.dtype.kind == "f" and values.dtype.itemsize not in (4, 8):
        return values.astype(np.float32 if values.dtype.itemsize < 4 else np.float64)
    return values


def require_number(value: float, argument: str, *, above: float | None = None, least: float | None = None,
                   most: float | None = None) -> float:
    """`value` as a finite float greater than `above`, not less than `least`, not more than `most`; ValueError otherwise."""
    try:
        number = math.nan if isinstance(value, (str, bytes)) else float(value)
    except (TypeError, ValueError):
        number = math.nan
    limits = [f"greater than {above:g}"] if above is not None else [f"at least {least:g}"] if least is not None else []
    limits += [f"at most {most:g}"] if most is not None else []
    if not math.isfinite(number) or (above is not None and number <= above) or (least is not None and number < least) or (
            most is not None and number > most):
        raise ValueError(f"{argument} is {value!r}; it must be a finite number{' ' if limits else ''}{' and '.join(limits)}.")
    return number
