# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A description in words of what was found in a dataset."""
from __future__ import annotations

import contextlib
import warnings

import numpy as np

from .air import Air
from .horizontal import GridError
from .land import may_have_zeros
from .reading import Reading
from .roles import ROLES
from .times import listed_times
from .units import CHECKED, UnitsError
from .winds import winds

WIDE_GAP = 60.0  # degrees without a longitude: the points are those of a region

def described(reading: Reading, air: Air, dataset) -> str:
    lines = [_grid(reading), *_cells(reading), *_levels(reading, air), _times(reading, dataset), *_roles(reading)]
    _look_at_values(reading)
    with contextlib.suppress(UnitsError):  # said by the line of the heights
        winds(reading, air)
    return "\n".join(lines + [f"note: {note}" for note in [*reading.horizontal.notes, *(reading.vertical.notes if reading.vertical else []), *reading.notes]])


def not_understood(dataset, problem: Exception) -> str:
    """What is in a dataset whose grid or levels are not recognized, and why they are not."""
    def line(kind: str, name, variable) -> str:
        known = [f"{key} {variable.attrs[key]!r}" for key in ("standard_name", "units", "axis", "positive") if key in variable.attrs]
        sizes = ", ".join(f"{dim} {size}" for dim, size in variable.sizes.items())
        return f"{kind} {name!r}: {sizes or 'no dimension'}" + "".join(f", {text}" for text in known)
    return "\n".join([f"not recognized: {problem}", *(line("coordinate", *item) for item in dataset.coords.items()), *(line("variable", *item) for item in dataset.data_vars.items())])


def _look_at_values(reading: Reading) -> None:
    """Notes the zeros of land in temperature, salinity and currents of the sea, cloud fractions that are percent, and units that the values contradict."""
    checked = {reading.roles.get(role) for role in CHECKED}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a note says the same
        for name in reading.plain_variables():
            if may_have_zeros(name, reading.dataset[name]) or name in reading.fractions or name in checked:
                reading.values(name)


def _grid(reading: Reading) -> str:
    grid = reading.horizontal
    sizes = " x ".join(f"{dim} {reading.dataset.sizes[dim]}" for dim in grid.dims)
    west, east = _west_to_east(grid.longitude)
    return (f"grid: {grid.kind}, {sizes}; longitude {west:g} to {east:g} ({grid.names[0]}), "
            f"latitude {np.nanmin(grid.latitude):g} to {np.nanmax(grid.latitude):g} ({grid.names[1]})")


def _cells(reading: Reading) -> list[str]:
    if not reading.horizontal.is_list:
        return []
    from .polygons import find_polygons
    try:
        return [f"cells: {find_polygons(reading.dataset, reading.horizontal).source}"]
    except (GridError, ModuleNotFoundError) as problem:
        return [f"cells: none. {problem}"]


def _levels(reading: Reading, air: Air) -> list[str]:
    if reading.vertical is None:
        return ["levels: none, drawn at the height 0"]
    try:
        heights = air.heights
    except UnitsError as problem:
        return [f"levels: {reading.vertical.kind}, {reading.vertical.dim} {reading.dataset.sizes[reading.vertical.dim]}", f"heights: none. {problem}"]
    return [f"levels: {reading.vertical.kind}, {reading.vertical.dim} {reading.dataset.sizes[reading.vertical.dim]}",
            f"heights: {np.nanmin(heights):.0f} to {np.nanmax(heights):.0f} m, from {air.height_source}"]


def _times(reading: Reading, dataset) -> str:
    times = listed_times(dataset)
    return f"time: {reading.time_text or 'none'}" + (f" (of {len(times)}, to {times[-1]})" if len(times) > 1 else "")


def _roles(reading: Reading) -> list[str]:
    return [f"{ROLES[role].meaning}: {name!r}" + (f" ({units})" if (units := reading.dataset[name].attrs.get("units")) else "") + ("" if reading.has(role) else ", left out")
            for role, name in reading.roles.items()]


def _west_to_east(longitude: np.ndarray) -> tuple[float, float]:
    """The ends of the longitudes; those of a region across the meridian at which they jump are on either side of it."""
    low, high = float(np.nanmin(longitude)), float(np.nanmax(longitude))
    if high - low < 300:
        return low, high
    around = np.unique(np.mod(longitude[np.isfinite(longitude)], 360))
    gaps = np.diff(around, append=around[0] + 360)
    last = int(np.argmax(gaps))
    if gaps[last] < WIDE_GAP:
        return low, high
    west, east = float(around[(last + 1) % len(around)]), float(around[last])
    return (west - 360 if west > east else west), east
