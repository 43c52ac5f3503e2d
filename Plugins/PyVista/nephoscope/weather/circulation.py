# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The vorticity of horizontal winds on any grid of rows and columns: circulation by area, of the cells around each point."""
from __future__ import annotations

import numpy as np

from .horizontal import beyond_seam
from .projections import vectors

EARTH_RADIUS = 6371229.0  # metres
SAME = 1e-4  # of the radius: points that are one
POINT = 1e-6  # of the radius: a row of this length is a pole


def vorticity_of(u: np.ndarray, v: np.ndarray, lon: np.ndarray, lat: np.ndarray) -> np.ndarray:
    """1/s, upward, from eastward and northward winds (..., rows, columns).

    A cell with a missing wind does not count. At the border of a region it is that of the cells inside; a row at a pole has one value.
    """
    closed = _closed(lon, lat)
    repeated = closed is beyond_seam
    u, v, lon, lat = (closed(field) for field in (u, v, lon, lat)) if closed else (u, v, lon, lat)
    up = vectors(lon, lat)
    east = vectors(lon + 90.0, np.zeros_like(lat))
    circulation, area = _cells(EARTH_RADIUS * up, u[..., None] * east + v[..., None] * np.cross(up, east))
    there = np.isfinite(circulation) & (area != 0)
    circulation, area = (_around_points(np.where(there, field, 0.0)) for field in (circulation, area))
    whole = slice(1, -2 if repeated else -1) if closed else slice(None)
    for row in (0, -1):
        if np.linalg.norm(np.diff(up[row], axis=0), axis=-1).max() < POINT:
            circulation[..., row, :], area[..., row, :] = (field[..., row, whole].sum(axis=-1, keepdims=True) for field in (circulation, area))
    with np.errstate(divide="ignore", invalid="ignore"):
        field = np.where(np.isfinite(u) & np.isfinite(v), circulation / area, np.nan)
    return field[..., 1:-1] if closed else field


def _closed(lon: np.ndarray, lat: np.ndarray):
    """Adds a column on either side of a field on a grid that goes around the globe; None for other grids."""
    places = vectors(lon, lat)
    if np.nanmax(np.linalg.norm(places[:, 0] - places[:, -1], axis=-1), initial=0) < SAME:  # the last column repeats the first one
        return beyond_seam
    if lon.shape[1] > 2 and abs(np.ptp(lon[0]) + abs(lon[0, 1] - lon[0, 0]) - 360) < 1e-3:
        return lambda field: np.concatenate([field[..., -1:], field, field[..., :1]], axis=-1)
    return None


def _cells(places: np.ndarray, wind: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Circulation around each cell, by the trapezoidal rule along its edges, and its area, negative if the cell is clockwise."""
    along = (0.5 * (wind[..., :, 1:, :] + wind[..., :, :-1, :]) * np.diff(places, axis=1)).sum(axis=-1)
    across = (0.5 * (wind[..., 1:, :, :] + wind[..., :-1, :, :]) * np.diff(places, axis=0)).sum(axis=-1)
    circulation = along[..., :-1, :] + across[..., :, 1:] - along[..., 1:, :] - across[..., :, :-1]
    middle = places[1:, 1:] + places[1:, :-1] + places[:-1, 1:] + places[:-1, :-1]
    middle /= np.linalg.norm(middle, axis=-1, keepdims=True)
    area = 0.5 * (np.cross(places[1:, 1:] - places[:-1, :-1], places[1:, :-1] - places[:-1, 1:]) * middle).sum(axis=-1)
    return circulation, np.broadcast_to(area, circulation.shape)


def _around_points(cells: np.ndarray) -> np.ndarray:
    """The sum over the cells that meet at each point."""
    wide = np.pad(cells, [(0, 0)] * (cells.ndim - 2) + [(1, 1), (1, 1)])
    return wide[..., 1:, 1:] + wide[..., 1:, :-1] + wide[..., :-1, 1:] + wide[..., :-1, :-1]
