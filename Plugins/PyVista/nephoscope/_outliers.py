# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values that look like fill values: one number, far from all others, that would take the whole range of colours and opacities."""
from __future__ import annotations

import warnings

import numpy as np
import pyvista

from ._fields import FLAT_GRID
from ._pipeline import level_of_caller

USUAL = (9999.0, 99999.0, 999.0, 999999.0, 8888.0, 32767.0, 32768.0, 65535.0, 1e10, 1e15, 1e20, 1e30, 1e35, 1e36, 1e37, 9.999e20, 9.96921e36, 3.4028235e38)  # of either sign
FAR, FARTHER = 5.0, 1000.0  # times the range of all others: the distance to them of a usual fill value, and of another one
SMALL, MOSTLY = 0.05, 0.5  # of the greatest value, and of all values: a field that is zero almost everywhere
LEAST = 0.01  # of the greatest value: the least one of such a field; codes from 1 on have none
BULK = (5.0, 25.0, 75.0, 95.0)  # percentiles: the values between the outer ones keep their own colours, and those within FENCE times the distance of the inner ones beyond these
FENCE = 3.0  # Tukey's for values that are far out
NARROW = 1 / 3  # of the range of all values: where the bulk is narrower, it has the whole range of colours
MOST = 4  # fill values of one array
HUGE, SANE = 1e15, 1e9  # where the median is below the second, magnitudes above the first are no values, even if they differ


def is_mostly_zero(values: np.ndarray) -> bool:
    """Whether no value is negative and more than half of them are 0 or close to it, as those of rain, of plumes and of aerosol are."""
    finite = np.asarray(values, float)[np.isfinite(values)]
    if not finite.size or finite.max() <= 0 or not 0 <= finite.min() <= LEAST * finite.max():
        return False
    return bool(np.mean(finite <= SMALL * finite.max()) > MOSTLY)


def skewed_range(values: np.ndarray) -> tuple[float, float] | None:
    """The range of all values but those far out, at most 5 % on either side, if these would take most of the colours, as rivers do in salinity; otherwise None.

    None also for fields that are zero almost everywhere, and for values that look like fill values, of which `warn_of_fill_values` warns.
    """
    finite = np.asarray(values, float)[np.isfinite(values)]
    if not finite.size or is_mostly_zero(finite) or fill_values(np.asarray(values))[1].size < finite.size:
        return None
    lowest, lower, upper, highest = np.percentile(finite, BULK)
    fence = FENCE * (upper - lower)
    inside = finite[(finite >= min(lower - fence, lowest)) & (finite <= max(upper + fence, highest))]
    low, high = inside.min(), inside.max()
    return (float(low), float(high)) if 0 < high - low < NARROW * (finite.max() - finite.min()) else None


def share_outside(values: np.ndarray, clim: tuple[float, float] | None) -> str:
    """``"2 % beyond"``: how many of the finite values are outside a range of colours; empty if none is."""
    finite = np.asarray(values, float)[np.isfinite(values)]
    if clim is None or not finite.size:
        return ""
    share = 100 * float(np.mean((finite < clim[0]) | (finite > clim[1])))
    return f"{_percent(share)} beyond" if share else ""


def fill_values(values: np.ndarray) -> tuple[list[float], np.ndarray]:
    """The numbers that look like fill values, and the finite values without them and without huge ones."""
    values = values[np.isfinite(values)]
    found: list[float] = []
    if values.dtype == bool:
        return found, values
    while len(found) < MOST and (fills := _fills(values)):
        found.extend(fills)
        values = values[~np.isin(values, np.array(fills, values.dtype))]
    if values.size and np.issubdtype(values.dtype, np.floating) and _greatest(values) > HUGE and np.median(np.abs(values)) < SANE:
        values = values[np.abs(values) <= HUGE]
    return found, values


def _greatest(values: np.ndarray) -> float:
    return max(abs(float(values.min())), abs(float(values.max())))


def _fills(values: np.ndarray) -> list[float]:
    """The maximum, the minimum or both, if they are far from all others."""
    if values.size < 3:
        return []
    greatest, least = values.max(), values.min()
    return next((fills for fills in ([greatest], [least], [greatest, least]) if _are_far(values, fills)), [])


def _are_far(values: np.ndarray, fills: list) -> bool:
    others = values[~np.isin(values, fills)]
    if not others.size or others.min() == others.max():
        return False
    low, high = float(others.min()), float(others.max())
    gap = min(float(fill) - high if fill > high else low - float(fill) for fill in fills)
    if gap > FAR * (high - low) and all(np.isclose(abs(float(fill)), USUAL, rtol=1e-6).any() for fill in fills):
        return True
    return np.issubdtype(values.dtype, np.floating) and gap > FARTHER * (high - low) and values.size - others.size > len(fills)


def warn_of_fill_values(values: np.ndarray, name: str, grid: pyvista.DataSet, argument: str) -> None:
    """Warns of values that look like fill values. `argument`: that which gives the range."""
    fills, others = fill_values(np.asarray(values))
    finite = int(np.isfinite(values).sum())
    if others.size == finite or not others.size:
        return
    share = 100 * (finite - others.size) / finite
    low, high = float(others.min()), float(others.max())
    what = " and ".join(f"{float(fill):.6g}" for fill in fills) if fills else f"up to {_greatest(np.asarray(values)[np.isfinite(values)]):.3g}"
    weather = FLAT_GRID in grid.field_data or "GlobeGridProjection" in grid.field_data
    if not fills:
        remedy = f"dataset[{name!r}].where(abs(dataset[{name!r}]) < 1e15)" if weather else f"scalars=numpy.ma.masked_outside(mesh[{name!r}], {low:.6g}, {high:.6g})"
    elif weather:
        remedy = f"dataset[{name!r}].where(" + " & ".join(f"(dataset[{name!r}] != {float(fill):.9g})" for fill in fills) + ")"
    else:
        values_of = f"mesh[{name!r}]"
        for fill in fills:
            values_of = f"numpy.ma.masked_values({values_of}, {float(fill):.9g})"
        remedy = f"scalars={values_of}"
    warnings.warn(f"The array {name!r} has {what} as values in {_percent(share)} of the data, far from all others, which are {low:.6g} to {high:.6g}. They look like fill values, and colours and opacities cover "
                  f"them too. Mask them: {remedy}; or pass {argument}=({low:.6g}, {high:.6g}).", UserWarning, stacklevel=level_of_caller())


def _percent(share: float) -> str:
    return f"{share:.2g} %" if share >= 0.01 else "less than 0.01 %"
