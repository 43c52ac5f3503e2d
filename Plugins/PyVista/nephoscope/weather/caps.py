# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The poles of grids whose rows are closed rings, such as rotated grids: a row at one position closes the hole inside the last ring."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .projections import vectors

LARGEST = 1.2  # radius of a ring around a pole, in distances to the next ring
SMALLEST = 0.02  # a smaller ring is the pole itself
GEOGRAPHIC = 89.999  # degrees of latitude
ROUND = 0.05  # largest difference of the radii of such a ring, relative to their mean


@dataclass
class Caps:
    """`first`, `last`: whether a row is added before the first row and after the last one."""
    first: bool
    last: bool

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """The rows of the file, closed: the added ones have the mean of their ring, whose last column repeats its first one."""
        rows = [values]
        if self.first:
            rows.insert(0, self._filled(values[..., :1, :]))
        if self.last:
            rows.append(self._filled(values[..., -1:, :]))
        return np.concatenate(rows, axis=-2)

    @staticmethod
    def _filled(ring: np.ndarray) -> np.ndarray:
        if ring.dtype == bool:
            return np.broadcast_to(ring.all(axis=-1, keepdims=True), ring.shape)
        there = np.isfinite(ring[..., :-1])
        total = np.where(there, ring[..., :-1], 0).sum(axis=-1, keepdims=True)
        with np.errstate(invalid="ignore"):
            return np.broadcast_to(total / there.sum(axis=-1, keepdims=True), ring.shape).astype(ring.dtype)

    def places(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Longitudes and latitudes with those of the added rows, in degrees."""
        middle = self(np.moveaxis(vectors(x, y), -1, 0))
        lon, lat = np.degrees(np.arctan2(middle[1], middle[0])), np.degrees(np.arctan2(middle[2], np.hypot(middle[0], middle[1])))
        inner = slice(int(self.first), -1 if self.last else None)
        lon[inner], lat[inner] = x, y
        for row, ring in ((0, 1), (-1, -2)):
            if abs(lat[row, 0]) > GEOGRAPHIC:  # has every longitude
                lon[row] = lon[ring]
        return lon, lat

    def winds(self, u: np.ndarray, v: np.ndarray, lon: np.ndarray, lat: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Eastward and northward winds on all rows, with the mean vector of its ring on each added one."""
        u, v = np.array(u), np.array(v)
        for added, row, ring in ((self.first, 0, 1), (self.last, -1, -2)):
            if added:
                vector = sum(wind[..., ring, :-1, None] * along for wind, along in zip((u, v), _frame(lon[ring, :-1], lat[ring, :-1])))
                mean = np.nanmean(vector, axis=-2) if np.isfinite(vector).any() else vector[..., 0, :]
                east, north = _frame(lon[row], lat[row])
                u[..., row, :], v[..., row, :] = mean @ east.T, mean @ north.T
        return u, v


def _frame(lon: np.ndarray, lat: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Unit vectors to east and to north."""
    east = vectors(lon + 90.0, np.zeros_like(lat))
    return east, np.cross(vectors(lon, lat), east)


def find_caps(x: np.ndarray, y: np.ndarray) -> Caps | None:
    """The rows to add to a grid of closed rings; None if there are none."""
    if min(x.shape) < 3:
        return None
    places = vectors(x, y)
    if not np.nanmax(np.linalg.norm(places[:, 0] - places[:, -1], axis=-1), initial=0) < 1e-4:
        return None
    found = Caps(_is_round_a_pole(places), _is_round_a_pole(places[::-1]))
    return found if found.first or found.last else None


def _is_round_a_pole(places: np.ndarray) -> bool:
    """True if the first ring is a small circle around a hole about as large as the distance to the next ring."""
    ring = places[0, :-1]
    middle = ring.mean(axis=0)
    if not np.isfinite(places[:2]).all() or np.linalg.norm(middle) < 0.1:
        return False
    radii = np.linalg.norm(ring - middle / np.linalg.norm(middle), axis=-1)
    apart = np.median(np.linalg.norm(places[1] - places[0], axis=-1))
    return bool(SMALLEST * apart < radii.mean() < LARGEST * apart and np.ptp(radii) < ROUND * radii.mean())
