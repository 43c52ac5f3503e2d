# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines that are missing inside a regular axis, such as longitudes that a selection left out: they are added as missing, so that nothing is drawn there."""
from __future__ import annotations

import numpy as np

WIDE = 1.5  # times the median of the steps around it
AROUND = 4  # steps on each side
SMOOTH = 1.3  # greatest ratio of neighbouring steps of an axis that has gaps; other axes are irregular by nature


def with_gaps(axis: np.ndarray, order: np.ndarray | None) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    """The `axis` and its indices in the file with the missing lines added, and True for each of these."""
    steps = np.diff(axis)
    counts = _missing(steps)
    if not counts.any():
        return axis, order, np.zeros(len(axis), bool)
    added = [axis[i] + steps[i] * np.arange(1, counts[i] + 1) / (counts[i] + 1) for i in np.flatnonzero(counts)]
    places = np.repeat(np.arange(1, len(axis)), counts)
    indices = np.arange(len(axis)) if order is None else order
    return np.insert(axis, places, np.concatenate(added)), np.insert(indices, places, 0), np.insert(np.zeros(len(axis), bool), places, True)


def _missing(steps: np.ndarray) -> np.ndarray:
    """How many lines are missing in each step; none if the axis is irregular or not monotonic."""
    if len(steps) < AROUND or not np.isfinite(steps).all() or np.ptp(np.sign(steps)):
        return np.zeros(len(steps), int)
    steps = np.abs(steps)
    usual = np.array([np.median(steps[max(0, i - AROUND):i + AROUND + 1]) for i in range(len(steps))])
    wide = steps > WIDE * usual
    rest = steps[~wide]
    smooth = len(rest) >= AROUND - 1 and (np.maximum(rest[1:], rest[:-1]) <= SMOOTH * np.minimum(rest[1:], rest[:-1])).all()
    return np.where(wide & bool(smooth), np.clip(np.round(steps / usual) - 1, 1, 4 * len(steps)), 0).astype(int)


def notes_of_gaps(name: str, axis: np.ndarray, added: np.ndarray) -> list[str]:
    """A sentence about the lines that were `added` to the axis."""
    there = np.flatnonzero(~added)
    ends = [(axis[i], axis[j]) for i, j in zip(there[:-1], there[1:]) if j > i + 1]
    between = ", ".join(f"from {first:g} to {last:g}" for first, last in ends[:3]) + (f" and at {len(ends) - 3} other places" if len(ends) > 3 else "")
    return [f"{name!r} jumps {between}: values are missing there, and nothing is drawn"] if ends else []
