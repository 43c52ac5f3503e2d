# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of xarray wherever a mesh is expected. This package does not import xarray."""
from __future__ import annotations

import sys
from typing import Any


def meshed(data: Any) -> Any:
    """The mesh of an xarray.Dataset or xarray.DataArray, flat or on a globe; all other data unchanged."""
    xarray = sys.modules.get("xarray")
    if not isinstance(data, (getattr(xarray, "Dataset", ()), getattr(xarray, "DataArray", ()))):
        return data
    from .weather.accessor import ArrayAccessor, WeatherAccessor
    return (WeatherAccessor if isinstance(data, xarray.Dataset) else ArrayAccessor)(data).mesh()
