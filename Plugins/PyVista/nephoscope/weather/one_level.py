# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields of one level, such as a pressure at the ground, in datasets that have others with levels."""
from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from .accessor import WeatherAccessor
from .helpers import helpers
from .horizontal import is_latitude, is_longitude
from .sections import as_section
from .vertical import VerticalError, is_layer

if TYPE_CHECKING:
    import xarray

    from .reading import Reading


def part_of(dataset: xarray.Dataset, name: str | None, time: int | str | np.datetime64 | None, options: dict[str, Any], is_lit: bool = False) -> xarray.Dataset:
    """The part of the dataset that a picture of the field `name` shows: a section, the field's level, or all of it. In the sun all clouds are drawn, whatever the field is."""
    if WeatherAccessor(dataset)._is_flat(options):
        return dataset
    section = as_section(dataset)
    level = None if is_lit or name is None else one_level(section, name, time, options)
    return section if level is None else level


def one_level(dataset: xarray.Dataset, name: str | None, time: int | str | np.datetime64 | None, options: dict[str, Any]) -> xarray.Dataset | None:
    """The dataset without levels, and without fields on other grids, if `name` is a field without levels and others have them; otherwise None."""
    if name not in dataset.data_vars or "vertical" in options:
        return None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # who reads the field will tell
        try:
            reading = WeatherAccessor(dataset)._reading(time, options)
        except VerticalError:  # perhaps of levels that this field has not, such as layers above the ground in a GRIB file
            alone = _on_grid_of(dataset, name)
            return alone if len(alone.data_vars) < len(dataset.data_vars) else None
    if name not in reading.dataset.data_vars or not _is_beside_others(reading, name):
        return None
    return _on_grid_of(dataset, name)


def _is_beside_others(reading: Reading, name: str) -> bool:
    """Whether the field covers a grid, has no levels, and is none of the fields that are put on the mesh of the dataset."""
    dims = reading.dataset[name].dims
    has_levels = reading.vertical is not None and reading.vertical.dim in dims
    return len(dims) >= len(reading.horizontal.dims) and not has_levels and name not in reading.helpers and name not in dict(reading.field_variables())


def _on_grid_of(dataset: xarray.Dataset, name: str) -> xarray.Dataset:
    """The dataset without variables on dimensions that the field does not have. Longitudes, latitudes and variables that describe cells stay."""
    own, kept = set(dataset[name].dims), {name, *helpers(dataset)}
    shared = {dim for dim in own if not is_layer(str(dim))}  # the values of this field alone decide which layer is drawn
    stays = lambda other, variable: set(variable.dims) <= shared or other in kept or variable.dims == (other,) or is_longitude(str(other), variable) or is_latitude(str(other), variable)  # noqa: E731
    return dataset.drop_vars([other for other, variable in dataset.variables.items() if not stays(other, variable)])
