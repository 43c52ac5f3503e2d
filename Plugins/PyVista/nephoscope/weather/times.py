# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a dataset."""
from __future__ import annotations

import warnings

import numpy as np


_NAMES = ("time", "valid_time", "step", "forecast_time", "leadtime", "initial_time", "forecast_reference_time", "xtime", "t", "date", "init_time", "lead_time", "prediction_timedelta", "timestep", "time_counter", "time_instant")
MEMBERS = ("number", "realization", "ensemble", "member", "members", "ensemble_member", "eps", "orderedsequencedata")


def is_member(dataset, dim: str) -> bool:
    """True of a dimension of several forecasts, or of the partitions of waves: one of them is drawn."""
    return dim.lower() in MEMBERS or (dim in dataset.variables and dataset[dim].attrs.get("standard_name") == "realization")


def time_dims(dataset) -> list[str]:
    """Dimensions of times: dates, periods, axis T, or a usual name."""
    return [dim for dim in map(str, dataset.sizes) if _is_time(dataset, dim)]


def _is_time(dataset, dim: str) -> bool:
    if dim in dataset.variables:
        variable = dataset[dim]
        if variable.dtype.kind in "mM" or variable.attrs.get("axis") == "T" or variable.attrs.get("standard_name") in ("time", "forecast_reference_time", "forecast_period"):
            return True
        if variable.size and hasattr(variable.values.flat[0], "calendar"):
            return True
        if variable.attrs.get("axis") in ("X", "Y", "Z"):
            return False
    return dim.lower() in _NAMES


def choose_time(dataset, dims: list[str], time):
    """The dataset of one time, and the time in words."""
    several = [dim for dim in dims if dataset.sizes[dim] > 1]
    empty = [dim for dim in dims if dataset.sizes[dim] == 0]
    if empty:
        raise ValueError(f"The dimension {empty[0]!r} has length 0: the dataset has no time.")
    chosen = {dim: 0 for dim in dims}
    if several:
        dim = several[0]
        chosen[dim] = _index(dataset, dim, time)
        for other in several[1:]:
            warnings.warn(f"{other!r} is a second dimension of time, of {dataset.sizes[other]}; the first was taken. Choose one: ds.isel({other}=0).", UserWarning, stacklevel=5)
    elif time is not None and dims:
        chosen[dims[0]] = _index(dataset, dims[0], time)
    found = dataset.isel(chosen)
    named = dims or [name for name in ("valid_time", "time") if name in found.variables and found[name].ndim == 0][:1]
    return found, "; ".join(f"{dim} {_told(found[dim].values)}" for dim in named if dim in found.variables)


def _index(dataset, dim: str, time) -> int:
    size = dataset.sizes[dim]
    if time is None:
        warnings.warn(f"The dataset has {size} times ({dim!r}), {_range(dataset, dim)}; the first was taken. Choose one with time: an index, 0 to {size - 1}, or a date.", UserWarning,
                      stacklevel=6)
        return 0
    if isinstance(time, (int, np.integer)):
        if not -size <= time < size:
            raise ValueError(f"time is {time}; the dataset has {size} times ({dim!r}), from 0.")
        return int(time) % size
    return _of_date(dataset, dim, time)


def _of_date(dataset, dim: str, time) -> int:
    import xarray
    if dim not in dataset.variables or dataset[dim].dtype.kind not in "mMO":
        raise ValueError(f"time is {time!r}, but {dim!r} has no dates, {_range(dataset, dim)}: choose by index, 0 to {dataset.sizes[dim] - 1}.")
    places = xarray.DataArray(np.arange(dataset.sizes[dim]), dims=[dim], coords={dim: dataset[dim].values})
    try:
        found = np.ravel(places.sel({dim: time}).values)
    except (KeyError, ValueError, TypeError) as problem:
        raise ValueError(f"time: {time!r} is none of the {dataset.sizes[dim]} times ({dim!r}), {_range(dataset, dim)}.") from problem
    if found.size == 0:
        raise ValueError(f"time: {time!r} is none of the {dataset.sizes[dim]} times ({dim!r}), {_range(dataset, dim)}.")
    return int(found[0])


def _range(dataset, dim: str) -> str:
    if dim not in dataset.variables:
        return "without a coordinate"
    values = dataset[dim].values
    return f"{_told(values[0])} to {_told(values[-1])}"


def _told(value) -> str:
    value = np.asarray(np.ravel(value)[0])
    if value.dtype.kind in "mM" and np.isnat(value):
        return "unknown"
    if value.dtype.kind == "M":
        return str(value.astype("datetime64[m]")).replace("T", " ")
    if value.dtype.kind == "m":
        return f"{value / np.timedelta64(1, 'h'):g} h"
    return str(value)


def seconds_of(values: np.ndarray) -> np.ndarray | None:
    """Seconds since the first of these times, in any calendar; None if they are no dates and no durations."""
    if values.dtype.kind in "mM":
        return (values - values[0]) / np.timedelta64(1, "s")
    since = [value - values[0] for value in values] if values.dtype == object else []
    return np.array([step.total_seconds() for step in since]) if since and all(hasattr(step, "total_seconds") for step in since) else None


def listed_times(dataset) -> list[str]:
    dims = [dim for dim in time_dims(dataset) if dim in dataset.variables]
    return [_told(value) for value in np.atleast_1d(dataset[dims[0]].values)] if dims else []
