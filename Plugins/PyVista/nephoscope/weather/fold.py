# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The northern fold of tripolar ocean grids, where the last row meets itself: column i lies next to column s - i."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .projections import vectors

ROWS = 3  # the last rows, where a halo may repeat


@dataclass
class Fold:
    """How the last row is closed. `mirror`: the partner of each column. `added`: the partners form an additional row; otherwise the file already
    has that row. `hidden`: columns whose points in the last row are hidden, so that no cell appears twice. `dropped`: the last row only repeats
    others."""
    mirror: np.ndarray
    added: bool
    hidden: np.ndarray
    dropped: bool = False

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """The rows of the file, closed."""
        if self.dropped:
            return values[..., :-1, :]
        return np.concatenate([values, values[..., -1:, self.mirror]], axis=-2) if self.added else values


def closed_fold(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray | None, Fold | None]:
    """The row order that ends at the fold (None if it is the order of the file), and the fold (None if there is none)."""
    places = vectors(x, y)
    if x.shape[1] == 1 or np.nanmax(np.linalg.norm(places[:, 0] - places[:, -1], axis=-1)) > 1e-4:
        return None, None  # not a closed ring
    if (fold := find_fold(places)) is not None:
        return None, fold
    fold = find_fold(places[::-1])
    return (np.arange(len(x))[::-1], fold) if fold else (None, None)


def find_fold(places: np.ndarray) -> Fold | None:
    """The fold in a closed ring of unit vectors (rows, columns, 3), whose first and last columns coincide; None if there is nothing to do."""
    ring = places[-ROWS - 1:, :-1]
    if len(ring) < ROWS + 1 or not np.isfinite(ring).all():
        return None
    size = np.median(np.linalg.norm(np.diff(ring, axis=0), axis=-1))
    if np.linalg.norm(ring[-1].mean(axis=0)) > 1 - size ** 2:  # a small circle round one pole
        return None
    found = [_partners(ring[-1], ring[-1 - back]) for back in range(ROWS)]
    for back in (1, 2):
        mirror, apart = found[back]
        if apart < 0.01 * size:
            return Fold(mirror, False, _second_half(mirror) & (back == 1), dropped=back == 2)
    mirror, apart = found[0]
    return Fold(mirror, True, _second_half(mirror)) if 0.1 * size < apart < 2 * size else None


def _partners(row: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, float]:
    """s - i for every column i, with the first one repeated at the end, and the median distance between the partners in `other`."""
    count = len(row)
    columns = np.arange(count)
    shifts = (np.argmin(np.linalg.norm(other - row[i], axis=-1)) + i for i in columns[::max(1, count // 16)])
    tried = {int(shift) % count for shift in shifts}
    apart = {s: float(np.median(np.linalg.norm(row - other[(s - columns) % count], axis=-1))) for s in tried}
    best = min(apart, key=apart.get)
    return np.append((best - columns) % count, best % count), apart[best]


def _second_half(mirror: np.ndarray) -> np.ndarray:
    """True in the columns of one half, whose cells the other half repeats. The row turns at the columns s/2 and s/2 + n/2."""
    count = len(mirror) - 1
    return np.mod(np.arange(count + 1) - mirror[0] / 2, count) > count / 2 + 0.25
