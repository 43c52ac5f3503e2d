# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One row or column of a grid whose longitudes and latitudes are two-dimensional, or of a projection: the points of a section along a line."""
from __future__ import annotations

import re
from typing import Any

import numpy as np

from .horizontal import is_latitude, is_longitude
from .projections import vectors
from .stagger import is_same_axis, is_staggered
from .times import time_dims

ROW = "section_row"  # the dimension of one entry that such a row gets
LONGEST = 7.0  # radians along a line; once around the globe is 6.3
SHARPEST = 0.5  # cosine of the greatest turn from step to step
UNEVEN = 8.0  # times the usual step: the longest one
_COLUMN = re.compile(r"(y|j|nj|lat|rlat|eta|south_north|grid_latitude|projection_y)([_\d].*)?$")
_AXES = ("grid_latitude", "grid_longitude", "projection_x_coordinate", "projection_y_coordinate")


def as_row(dataset: Any) -> Any:
    """The dataset; if its points lie along a line, which one index along a row or a column leaves of a grid, with a dimension of one entry besides that of the line."""
    lines = _lines(dataset)
    if lines:
        return _with_row(dataset, lines | _faces(dataset, lines))
    axis = _left_out(dataset)
    return dataset if axis is None else _with_row(dataset.drop_vars(axis), set(_dims(dataset)), axis).assign_coords({axis: dataset[axis].expand_dims(axis)})


def _with_row(dataset: Any, lines: set[str], row: str = ROW) -> Any:
    """`row` comes before the dimensions `lines`, or after them if they are columns by their names: winds may be relative to the rows."""
    wide = {}
    for name, variable in dataset.variables.items():
        line = next((dim for dim in variable.dims if dim in lines), None)
        if line is not None and name not in dataset.dims:
            parts = [{row: 1}, {line: variable.sizes[line]}]
            others = {dim: size for dim, size in variable.sizes.items() if dim != line}
            order = parts[::-1] if _COLUMN.match(str(line).lower()) else parts
            wide[name] = variable.set_dims({**others, **order[0], **order[1]})
    return dataset.assign(wide)


def _lines(dataset: Any) -> set[str]:
    """The dimensions that both longitudes and latitudes have, if the points lie on a line. If these depend on time, as in WRF, the first time counts."""
    first = {dim: 0 for dim in time_dims(dataset)}
    there = {name: variable.isel(first, missing_dims="ignore") for name, variable in dataset.variables.items() if 0 < variable.ndim < 3}
    longitudes, latitudes = ({variable.dims[0]: variable for name, variable in there.items() if variable.ndim == 1 and fits(str(name), variable)} for fits in (is_longitude, is_latitude))
    return {str(dim) for dim in longitudes if dim in latitudes and not _has_cells(dataset, dim) and is_line(vectors(longitudes[dim].values, latitudes[dim].values))}


def _faces(dataset: Any, lines: set[str]) -> set[str]:
    """The dimensions of cell faces along these lines. They may have no longitudes and latitudes."""
    return {str(dim) for dim in dataset.dims for line in lines if is_staggered(dim) and abs(dataset.sizes[dim] - dataset.sizes[line]) <= 1 and (str(dim).startswith(line) or is_same_axis(dim, line))}


def _has_cells(dataset: Any, dim: Any) -> bool:
    """Whether the points are cells of a mesh, of which the file has more than their positions. Cells with four corners may be those of a row."""
    has_corners = lambda name, variable: variable.ndim == 2 and str(name).endswith(("_bnds", "_bounds", "_vertices")) and variable.shape[-1] != 4  # noqa: E731
    return any(dim in variable.dims and ("cf_role" in variable.attrs or has_corners(name, variable)) for name, variable in dataset.variables.items())


def is_line(places: np.ndarray) -> bool:
    """Whether three or more points, unit vectors of shape (n, 3), are in their order on a line without sharp turns and without jumps."""
    steps = np.diff(places[np.isfinite(places).all(axis=1)], axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    steps, lengths = steps[lengths > 1e-7], lengths[lengths > 1e-7]
    if len(steps) < 2 or lengths.sum() > LONGEST or lengths.max() > UNEVEN * np.median(lengths):
        return False
    directions = steps / lengths[:, None]
    return bool(((directions[1:] * directions[:-1]).sum(axis=1) > SHARPEST).all())


def _dims(dataset: Any) -> list[str]:
    """Dimensions that are axes of a projection."""
    return [str(dim) for dim in dataset.dims if dim in dataset.variables and _is_axis(dataset, str(dim))]


def _is_axis(dataset: Any, name: str) -> bool:
    return dataset[name].attrs.get("standard_name") in _AXES


def _left_out(dataset: Any) -> str | None:
    """The axis of a projection of which one index has been chosen, where the other one is a dimension and there are no longitudes and latitudes."""
    if len(_dims(dataset)) != 1 or any(fits(str(name), variable) and variable.ndim for name, variable in dataset.variables.items() for fits in (is_longitude, is_latitude)):
        return None
    return next((str(name) for name in dataset.coords if dataset[name].ndim == 0 and _is_axis(dataset, str(name))), None)
