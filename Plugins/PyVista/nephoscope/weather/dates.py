# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Dates that xarray does not decode, those of WRF and of ICON, and the date of one time step."""
from __future__ import annotations

import calendar
import re

import numpy as np

_DAYS = re.compile(r"day\s+as\s+%Y%m%d(\.%f)?")  # units of times by CDO and ICON, such as 20200101.25
_WRITTEN = re.compile(r"(\d{4}-\d\d-\d\d)[_T ](\d\d:\d\d:\d\d)")  # in WRF's variable Times
FIRST, LAST = np.datetime64("1678-01-01"), np.datetime64("2262-01-01")  # dates between these fit into nanoseconds
_STARTS = ("forecast_reference_time", "reftime", "initial_time", "init_time")
_LEADS = ("step", "forecast_time", "leadtime", "lead_time", "prediction_timedelta", "forecast_period")


def with_dates(dataset):
    """`dataset` with dates instead of days as %Y%m%d.%f, and along WRF's dimension Time, if no other coordinate has them; unchanged if there is nothing to decode."""
    for name, variable in dataset.variables.items():
        if variable.ndim < 2 and variable.dtype.kind in "fiu" and _DAYS.fullmatch(str(variable.attrs.get("units", "")).strip()):
            dates = _of_days(variable.values)
            if dates is not None:
                attrs = {key: value for key, value in variable.attrs.items() if key not in ("units", "calendar")}
                dataset = dataset.assign({name: (variable.dims, dates, attrs)}) if name in dataset.data_vars else dataset.assign_coords({name: (variable.dims, dates, attrs)})
    return _with_written_dates(dataset)


def _of_days(days: np.ndarray) -> np.ndarray | None:
    """None if these are no dates, as the 30th of February in a calendar of equal months; see also `in_range`."""
    days = np.asarray(days, float)
    try:
        whole = [np.datetime64("NaT" if np.isnan(day) else f"{int(day) // 10000:04}-{int(day) // 100 % 100:02}-{int(day) % 100:02}", "s") for day in np.ravel(days)]
    except ValueError:
        return None
    seconds = np.rint(86400 * np.nan_to_num(np.ravel(days) % 1)).astype("m8[s]")
    dates = in_range(np.array(whole, "M8[s]") + seconds)
    return None if dates is None else dates.reshape(days.shape)


def in_range(dates: np.ndarray) -> np.ndarray | None:
    """Dates in seconds, as xarray has them: in nanoseconds or, for model years outside their range, as dates of cftime.

    None for such years if cftime is missing or a date is missing.
    """
    known = dates[~np.isnat(dates)]
    if not known.size or FIRST < known.min() and known.max() < LAST:
        return dates.astype("M8[ns]")
    try:
        import cftime
    except ImportError:
        return None
    if known.size < dates.size:
        return None
    found = np.empty(dates.shape, object)
    found[...] = [cftime.DatetimeProlepticGregorian(*one.timetuple()[:6]) for one in dates.tolist()]
    return found


def _with_written_dates(dataset):
    times = dataset.variables.get("Times")
    if times is None or times.dtype.kind not in "SUO" or times.ndim > 2 or "Time" in dataset.variables or times.ndim and times.dims[0] != "Time":
        return dataset
    if any(variable.dtype.kind == "M" and variable.dims == times.dims[:1] for variable in dataset.variables.values()):
        return dataset
    values = np.asarray(times.values)
    if values.ndim == 2:  # letters
        values = np.array(["".join(map(_text, row)) for row in values])
    written = [_WRITTEN.match(_text(value)) for value in np.ravel(values)]
    if not written or not all(written):
        return dataset
    dates = in_range(np.array([f"{found[1]}T{found[2]}" for found in written], "M8[s]"))
    if dates is None:
        return dataset
    return dataset.assign_coords(Time=dates[0] if times.ndim == 0 else ("Time", dates))


def _text(value) -> str:
    return value.decode("ascii", "replace") if isinstance(value, bytes) else str(value)


def date_of(dataset, dims: list[str]) -> str | None:
    """The date of a dataset of one time, ``YYYY-MM-DD HH:MM``, whatever its calendar; None if it has none. `dims`: the dimensions of time that it had."""
    alone = {str(name): variable for name, variable in dataset.variables.items() if variable.ndim == 0}
    dates = {name: variable for name, variable in alone.items() if (variable.dtype.kind == "M" and not np.isnat(variable.values)) or hasattr(variable.values[()], "calendar")}
    valid = [name for name in dates if name == "valid_time" or dates[name].attrs.get("standard_name") == "time"]
    if valid:
        return _told(dates[valid[0]].values[()])
    leads = [variable.values for name, variable in alone.items() if variable.dtype.kind == "m" and (name in _LEADS or name in dims)]
    others = sorted(dates, key=lambda name: (name in _STARTS, name not in dims))
    if not others:
        return None
    start = dates[others[0]].values[()]
    return _told(start + sum(leads, np.timedelta64(0, "s")) if isinstance(start, np.datetime64) else start)


def _told(date) -> str:
    if isinstance(date, np.datetime64):
        return str(np.datetime_as_string(date, unit="m")).replace("T", " ")
    day = min(date.day, calendar.monthrange(date.year, date.month)[1]) if date.year else date.day  # months of 30 days
    return f"{date.year:04}-{date.month:02}-{day:02} {date.hour:02}:{date.minute:02}"
