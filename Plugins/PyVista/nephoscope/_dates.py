# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Dates and times of Python's libraries, as `vtkSunlight` reads them."""
from __future__ import annotations

from datetime import timezone
from typing import Any, Mapping

import numpy as np


def as_time(value: Any) -> Any:
    """``YYYY-MM-DD HH:MM:SS`` in UTC, of what datetime, NumPy, pandas and cftime call a date, or of one from xarray; any other value is unchanged.

    A date without a time zone is in UTC.
    """
    if not isinstance(value, str) and getattr(value, "shape", None) == ():
        value = np.asarray(value)[()]
    if isinstance(value, np.datetime64):
        return "NaT" if np.isnat(value) else np.datetime_as_string(value, unit="s").replace("T", " ")
    if not hasattr(value, "isoformat") or not hasattr(value, "strftime"):
        return value
    if getattr(value, "tzinfo", None) is not None:
        value = value.astimezone(timezone.utc)
    return value.strftime("%Y-%m-%d %H:%M:%S") if value == value else "NaT"


def options_of(sun: Any) -> dict[str, Any]:
    """The arguments of `sunlight` that `sun` means: a dict of them, True, a date and time, or a direction."""
    given = dict(sun) if isinstance(sun, Mapping) else {} if sun is True else {"time": as_time(sun)} if isinstance(as_time(sun), str) else {"direction": sun}
    return {name: as_time(value) if name == "time" else value for name, value in given.items()}
