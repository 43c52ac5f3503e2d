# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a dataset."""
from __future__ import annotations

import warnings

import numpy as np

from .._pipeline import level_of_caller


_NAMES = ("time", "valid_time", "step", "forecast_time", "leadtime", "initial_time", "forecast_reference_time", "xtime", "t", "date", "init_time", "lead_time", "prediction_timedelta", "timestep", "time_counter", "time_instant", "month", "season", "year", "dayofyear", "doy")
_STARTS = ("time", "forecast_reference_time", "reftime", "initial_time", "init_time", "valid_time")  # of forecasts
MEMBERS = ("number", "realization", "ensemble", "member", "members", "ensemble_member", "member_id", "eps", "case", "orderedsequencedata")


def is_member(dataset, dim: str) -> bool:
    """True for a dimension of several forecasts or of wave partitions, of which one is drawn."""
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
    return dim.lower() in _NAMES or dim.lower().startswith("time_")


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
            warnings.warn(f"{other!r} is a second dimension of time, of {dataset.sizes[other]}; the first was taken. Choose one: ds.isel({other}=0).", UserWarning, stacklevel=level_of_caller())
    elif time is not None and dims:
        chosen[dims[0]] = _index(dataset, dims[0], time)
    found = dataset.isel(chosen)
    named = [name for name in ("valid_time", "time") if name in found.variables and found[name].ndim == 0 and name not in dims][:1]
    return found, "; ".join([*(_told_of(dataset, dim, chosen[dim]) for dim in dims), *(f"{name} {_told(found[name].values)}" for name in named)])


def _told_of(dataset, dim: str, index: int) -> str:
    values = when(dataset, dim)
    if values is None:
        return f"{dim} without a coordinate, step {index}"
    lead = f" ({_told(dataset[dim].values[index])} from the start)" if values.dtype.kind == "M" and dim in dataset.variables and dataset[dim].dtype.kind == "m" else ""
    return f"{dim} {_told(values[index])}{lead}"


def _index(dataset, dim: str, time) -> int:
    size = dataset.sizes[dim]
    if time is None:
        warnings.warn(f"The dataset has {size} times ({dim!r}), {_range(dataset, dim)}; the first was taken. Choose one with time: an index, 0 to {size - 1}, or a date.", UserWarning,
                      stacklevel=level_of_caller())
        return 0
    if isinstance(time, (int, np.integer)):
        if not -size <= time < size:
            raise ValueError(f"time is {time}, but the dataset has {size} times ({dim!r}): it must be an index, 0 to {size - 1}, or a date.{_of_value(dataset, dim, time)}")
        return int(time) % size
    return _of_date(dataset, dim, time)


def _of_value(dataset, dim: str, value: int) -> str:
    """How to choose a time by its number, such as that of a month."""
    values = dataset[dim].values if dim in dataset.variables else np.zeros(0)
    found = np.flatnonzero(values == value) if np.issubdtype(values.dtype, np.number) else []
    return f" For {dim} {value} pass time={found[0]}." if len(found) else ""


def when(dataset, dim: str) -> np.ndarray | None:
    """The dates along a dimension of time: its own dates, those of another coordinate along it (valid_time), or lead times added to the reference time. If there are
    none, its values unchanged."""
    own = dataset[dim].values if dim in dataset.variables else None
    if own is not None and own.dtype.kind in "MO":
        return own
    dates = [variable.values for name, variable in dataset.variables.items() if name != dim and variable.dims == (dim,) and variable.dtype.kind == "M" and not str(name).endswith("_bnds")]
    if dates:
        return dates[0]
    starts = [dataset[name].values for name in _STARTS if name in dataset.variables and dataset[name].ndim == 0 and dataset[name].dtype.kind == "M"]
    return starts[0] + own if starts and own is not None and own.dtype.kind == "m" else own


def _of_date(dataset, dim: str, time) -> int:
    import xarray
    values = when(dataset, dim)
    if values is None or values.dtype.kind not in "mMO":
        raise ValueError(f"time is {time!r}, but {dim!r} has no dates, {_range(dataset, dim)}: choose by index, 0 to {dataset.sizes[dim] - 1}.")
    places = xarray.DataArray(np.arange(dataset.sizes[dim]), dims=[dim], coords={dim: values})
    try:
        found = np.ravel(places.sel({dim: time}).values)
    except (KeyError, ValueError, TypeError) as problem:
        raise ValueError(f"time: {time!r} is none of the {dataset.sizes[dim]} times ({dim!r}), {_range(dataset, dim)}.") from problem
    if found.size == 0:
        raise ValueError(f"time: {time!r} is none of the {dataset.sizes[dim]} times ({dim!r}), {_range(dataset, dim)}.")
    return int(found[0])


def _range(dataset, dim: str) -> str:
    values = when(dataset, dim)
    if values is None:
        return "without a coordinate"
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
    """Seconds since the first of these times, in any calendar; None if they are neither dates nor durations."""
    if values.dtype.kind in "mM":
        return (values - values[0]) / np.timedelta64(1, "s")
    since = [value - values[0] for value in values] if values.dtype == object else []
    return np.array([step.total_seconds() for step in since]) if since and all(hasattr(step, "total_seconds") for step in since) else None


def listed_times(dataset) -> list[str]:
    """The values of the time dimension with several entries, or of the only one: dates, or step numbers if there are no dates."""
    dims = sorted(time_dims(dataset), key=lambda dim: dataset.sizes[dim] < 2)
    if not dims:
        return []
    values = when(dataset, dims[0])
    return [str(i) for i in range(dataset.sizes[dims[0]])] if values is None else [_told(value) for value in values]
