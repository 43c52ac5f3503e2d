# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Axes of longitude and latitude, reordered so that neighbours are neighbours on the Earth."""
from __future__ import annotations

import numpy as np

SAME = 1e-6  # degrees


def eastward(x: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
    """Longitudes without a jump at 360, and their indices on the axis; None if nothing changes.

    An axis that jumps back, such as 0, 1, 358, 359, begins after its widest gap. Longitudes beyond one revolution and missing values are left out.
    """
    unwrapped = np.degrees(np.unwrap(np.radians(x))) if np.isfinite(x).all() else x
    if _goes_one_way(unwrapped) and np.ptp(unwrapped) <= 360 + SAME:
        return unwrapped, None
    turned = np.mod(x, 360)
    order = _without_repeated(turned, np.argsort(turned, kind="stable"))
    if len(order) > 1 and turned[order[0]] + 360 - turned[order[-1]] < SAME:
        order = order[:-1]
    gaps = np.diff(turned[order], append=turned[order[:1]] + 360)
    order = np.roll(order, -1 - int(np.argmax(gaps))) if len(order) > 1 and gaps.max() > 1.5 * np.median(gaps) else order
    return np.degrees(np.unwrap(np.radians(turned[order]))), order


def northward(y: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
    """Monotonic latitudes without repetitions, and their indices on the axis."""
    if _goes_one_way(y):
        return y, None
    order = _without_repeated(y, np.argsort(y, kind="stable"))
    return y[order], order


def _goes_one_way(axis: np.ndarray) -> bool:
    steps = np.diff(axis)
    return bool(np.isfinite(axis).all() and (np.all(steps > 0) or np.all(steps < 0)))


def _without_repeated(axis: np.ndarray, order: np.ndarray) -> np.ndarray:
    order = order[np.isfinite(axis[order])]
    return order[np.diff(axis[order], prepend=-np.inf) > SAME]


def notes_of_order(name: str, size: int, order: np.ndarray | None) -> list[str]:
    """What was done, for `describe`."""
    if order is None:
        return []
    gone = size - len(order)
    return [f"{name!r} is not in order and was sorted" + (f", {gone} repeated or missing of {size} left out" if gone else "")]
