# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What quantities have in common on any grid: their formulas, integrals over height, and messages about names that are not known."""
from __future__ import annotations

from typing import Iterable

import numpy as np

from .._checks import listed
from .columns import KAPPA

WATER = ("cloud_water", "cloud_ice", "rain", "snow", "graupel")  # roles that cloud_content sums
VOLUME_UNITS = {"kgm-3": 1.0, "kg/m3": 1.0, "gm-3": 1e-3, "g/m3": 1e-3, "mgm-3": 1e-6, "mg/m3": 1e-6}  # of contents, in kg/m3
PER_VOLUME = ("cloud_content", "water_vapour")  # kg/m3


def wanted(names: str | Iterable[str], known: Iterable[str], where: str = "") -> list[str]:
    """The names of the quantities that `derive` asks for; ValueError for others. `where`: in the message, such as " on a flat grid"."""
    asked = [names] if isinstance(names, str) else list(names)
    unknown = [name for name in asked if name not in known]
    if unknown:
        raise ValueError(f"derive: {listed(unknown)} not known{where}. There are: {listed(list(known))}.")
    return asked


def no_column(name: str, where: str, variables: list[str], dims: list[str] | None = None) -> ValueError:
    """The error for a name that has no integral over height. `dims`: the dimensions of the variable, if it exists."""
    if dims is not None:
        return ValueError(f"column: {name!r} is on {listed(dims) or 'no dimension'}, and has no integral over the {where}. These have: {listed(variables)}.")
    return ValueError(f"column: {name!r} is neither {', '.join(map(repr, PER_VOLUME))} nor a variable on the {where}: {listed(variables)}.")


def no_water(remedy: str) -> ValueError:
    return ValueError(f"cloud_content needs one of {listed(list(WATER))}, and none was found. {remedy}")


def potential_temperature(temperature: np.ndarray, pressure: np.ndarray) -> np.ndarray:
    """K, to 1000 hPa."""
    return temperature * (1e5 / pressure) ** KAPPA


def column(field: np.ndarray, thickness: np.ndarray) -> np.ndarray:
    """Integral over the first axis by the trapezoidal rule; `thickness`: of the layers between neighbours. NaN where nothing is known."""
    pieces = 0.5 * (field[:-1] + field[1:]) * thickness
    return np.where(np.isfinite(pieces).any(axis=0), np.nansum(pieces, axis=0), np.nan)
