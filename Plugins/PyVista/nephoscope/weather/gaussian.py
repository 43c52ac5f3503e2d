# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of a reduced Gaussian grid (N, O), each with its own number of points, interpolated to rows of equal length."""
from __future__ import annotations

import numpy as np


class Rows:
    """Interpolates linearly in longitude around the circle, to as many columns as the longest row has, so that this row stays unchanged."""

    def __init__(self, longitude: np.ndarray, starts: np.ndarray) -> None:
        ends = np.append(starts[1:], len(longitude))
        counts = ends - starts
        self.longitude = np.arange(counts.max()) * 360.0 / counts.max()
        self.lower, self.upper, self.share = (np.empty((len(starts), counts.max()), kind) for kind in (int, int, float))
        for j, (start, count) in enumerate(zip(starts, counts)):
            place = np.mod(self.longitude - longitude[start], 360.0) * count / 360.0
            left = np.floor(place + 1e-9).astype(int)
            self.lower[j], self.upper[j], self.share[j] = start + left % count, start + (left + 1) % count, np.clip(place - left, 0, 1)

    def __call__(self, values: np.ndarray) -> np.ndarray:
        low, high = values[..., self.lower], values[..., self.upper]
        return np.where(self.share < 1e-9, low, low * (1 - self.share) + high * self.share).astype(values.dtype)


def find_rows(longitude: np.ndarray, latitude: np.ndarray, pl: np.ndarray | None) -> tuple[Rows, np.ndarray] | None:
    """The rows and their latitudes, by GRIB's list of row lengths or by the latitudes themselves; None if the points do not form complete, evenly spaced rows."""
    pl = None if pl is None else np.asarray(pl)[np.asarray(pl) > 0]
    starts = np.concatenate([[0], np.cumsum(pl)[:-1]]).astype(int) if pl is not None and np.sum(pl) == len(longitude) else np.flatnonzero(
        np.concatenate([[True], np.abs(np.diff(latitude)) > 1e-6]))
    counts = np.diff(np.append(starts, len(longitude)))
    if len(starts) < 4 or counts.min() < (4 if pl is None else 1) or not np.all(np.diff(np.sign(np.diff(latitude[starts]))) == 0):
        return None
    steps = np.mod(np.diff(longitude), 360.0)
    inside = np.ones(len(longitude) - 1, bool)
    inside[starts[1:] - 1] = False
    wanted = np.repeat(360.0 / counts, counts)[:-1]
    if not np.allclose(steps[inside], wanted[inside], rtol=0.02):
        return None
    return Rows(longitude, starts), latitude[starts]
