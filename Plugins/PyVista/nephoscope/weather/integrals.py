# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Integrals of a quantity over the columns of a reading: every level stands for a layer, from the ground upwards."""
from __future__ import annotations

import numpy as np

from .air import Air, half_coefficients
from .derived import QUANTITIES, density_of, water_fraction
from .quantities import PER_VOLUME, VOLUME_UNITS, no_column
from .reading import Reading
from .units import GRAVITY, converted, plain

BY_PRESSURE = ("pressure", "log pressure", "hybrid", "sigma")  # axes whose layers have a known mass, dp/g
POINTS = ("pressure", "height", "height above ground")  # axes of points, which end at the last level; others are middles of layers


def column_of(name: str, reading: Reading, air: Air) -> np.ndarray:
    """kg/m2. The mass of a layer is dp/g on axes of pressure, sigma and hybrid levels, and its thickness times the density of the air on others.

    Layers meet midway between levels, or at the model's own half levels. The lowest layer above the ground reaches down to it. Levels of a model have half a layer
    above the uppermost one; levels of pressure or height end at it. Missing values count as nothing.
    """
    if (reading.vertical.kind in BY_PRESSURE or reading.has("pressure_thickness")) and not _is_per_volume(name, reading):
        return total(_fraction(name, reading, air), _masses(reading, air))
    order = _upwards(air.heights)
    return total(_content(name, reading, air)[order], _thicknesses(reading, air, order))


def total(field: np.ndarray, layers: np.ndarray) -> np.ndarray:
    """The sum over the first axis; NaN where no layer has a value."""
    pieces = np.where(layers > 0, field * layers, np.nan)
    return np.where(np.isfinite(pieces).any(axis=0), np.nansum(pieces, axis=0), np.nan)


def _upwards(heights: np.ndarray) -> np.ndarray:
    return np.argsort(np.nanmean(heights.reshape(len(heights), -1), axis=1))


def _is_per_volume(name: str, reading: Reading) -> bool:
    return name in reading.dataset.variables and plain(reading.dataset[name].attrs.get("units")) in VOLUME_UNITS


def _fraction(name: str, reading: Reading, air: Air) -> np.ndarray:
    """kg/kg."""
    if name in PER_VOLUME:
        return water_fraction(name, reading, air)
    variables = [known for known, _ in reading.field_variables()]
    if name not in variables:
        raise no_column(name, "levels", variables, [str(dim) for dim in reading.dataset[name].dims] if name in reading.dataset.variables else None)
    return converted(reading.values(name).astype(float), reading.dataset[name].attrs.get("units"), "mass fraction", name)[0]


def _content(name: str, reading: Reading, air: Air) -> np.ndarray:
    """kg/m3."""
    if name in PER_VOLUME:
        return np.asarray(QUANTITIES[name](reading, air), float)
    if _is_per_volume(name, reading):
        return reading.values(name).astype(float) * VOLUME_UNITS[plain(reading.dataset[name].attrs["units"])]
    return _fraction(name, reading, air) * density_of(air, name)


# Layers

def _masses(reading: Reading, air: Air) -> np.ndarray:
    """kg/m2 of air in each layer, in the order of the dataset."""
    if reading.has("pressure_thickness"):
        return reading.role("pressure_thickness").astype(float) / GRAVITY
    order = np.argsort(np.nanmean(air.pressure.reshape(len(air.pressure), -1), axis=1))  # top first
    back = np.empty(air.shape)
    half = half_coefficients(reading)
    if half is not None:
        a, b = (values.reshape(-1, *[1] * (len(air.shape) - 1)) for values in half)
        back[order] = np.diff(a + b * air.surface_pressure, axis=0) / GRAVITY
    else:
        back[order] = _between(air.pressure[order], _ground_pressure(air, order), reading.vertical.kind in POINTS) / GRAVITY
    return back


def _between(pressure: np.ndarray, ground: np.ndarray | None, points: bool) -> np.ndarray:
    """Pa of the layers around levels, top first."""
    top, bottom = _ends(pressure, points)
    faces = np.concatenate([np.maximum(top, 0)[None], 0.5 * (pressure[1:] + pressure[:-1]), bottom[None]])
    if ground is None:
        return np.diff(faces, axis=0)
    above = pressure <= ground
    lowest = above & ~np.concatenate([above[1:], np.zeros_like(above[:1])])
    return np.where(above, np.where(lowest, ground, faces[1:]) - faces[:-1], 0)


def _ends(levels: np.ndarray, points: bool) -> tuple[np.ndarray, np.ndarray]:
    """The outer faces of the first and of the last layer, at the levels themselves or half a layer beyond."""
    if points or len(levels) == 1:
        return levels[0], levels[-1]
    return 1.5 * levels[0] - 0.5 * levels[1], 1.5 * levels[-1] - 0.5 * levels[-2]


def _ground_pressure(air: Air, order: np.ndarray) -> np.ndarray | None:
    """Pa; by the heights of the two lowest levels above the ground where the pressure there is not in the dataset."""
    if air.surface_pressure is not None or air.terrain is None or len(order) < 2:
        return air.surface_pressure
    height, pressure = air.heights[order], np.log(air.pressure[order])
    lowest = np.maximum((height >= air.terrain).sum(axis=0), 2) - 1  # of the levels, top first
    take = lambda field, index: np.take_along_axis(field, index[None], axis=0)[0]
    slope = (take(pressure, lowest) - take(pressure, lowest - 1)) / (take(height, lowest) - take(height, lowest - 1))
    return np.exp(take(pressure, lowest) + slope * (air.terrain - take(height, lowest)))


def _thicknesses(reading: Reading, air: Air, order: np.ndarray) -> np.ndarray:
    """m of the layers from the bottom to the top, above the ground."""
    kind, heights = reading.vertical.kind, air.heights[order]
    ground = air.terrain if air.terrain is not None or kind != "height above ground" else np.zeros(air.shape[1:])
    faces = air.interfaces(order)
    if kind in POINTS or len(faces) == len(heights):
        faces = np.concatenate([heights[:1], 0.5 * (heights[1:] + heights[:-1]), heights[-1:]])
    if ground is None:
        return np.diff(faces, axis=0)
    above = faces[1:] > ground if kind not in POINTS else heights >= ground - 1
    lowest = above & ~np.concatenate([np.zeros_like(above[:1]), above[:-1]])
    return np.where(above, faces[1:] - np.where(lowest, ground, faces[:-1]), 0)
