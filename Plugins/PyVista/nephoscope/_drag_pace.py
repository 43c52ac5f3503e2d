# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How fine smoke may be while it is dragged."""
from __future__ import annotations

UPDATES_PER_SECOND = 10.0
COARSEST = 2000  # tetrahedra
EXTRA = 0.25  # of the time of the rest of the picture: what smoke may take in any case; in a slow scene coarser smoke would save little
DECAY = 0.7  # of the weight of an update with each later one
MOST_GROWTH = 2.0  # from one update to the next, and its inverse


class DragPace:
    """Finds the number of tetrahedra that gives ten updates a second.

    An update takes a time for the rest of the picture, whatever the smoke, and a time per tetrahedron. Both are fitted to past updates by
    weighted least squares.

    Parameters
    ----------
    most : int
        Number of tetrahedra of the complete smoke.
    """

    def __init__(self, most: int) -> None:
        self.most = self.number = most
        self._weight = self._n = self._t = self._nn = self._nt = 0.0
        self._slope: float | None = None

    def note(self, tetrahedra: int, seconds: float) -> None:
        """An update with this many tetrahedra took so long; sets `number`, of the next one."""
        if self._slope is None:  # the first update compiles shaders too
            self._slope = seconds / max(tetrahedra, 1)
            wanted = 1 / (UPDATES_PER_SECOND * self._slope)
        else:
            fixed = self._fit(tetrahedra, seconds)
            wanted = (max(1 / UPDATES_PER_SECOND, (1 + EXTRA) * fixed) - fixed) / self._slope
            wanted = min(max(wanted, self.number / MOST_GROWTH), self.number * MOST_GROWTH)
        self.number = int(min(max(wanted, COARSEST), self.most))

    def _fit(self, n: float, t: float) -> float:
        """The seconds that do not depend on the smoke. Numbers that hardly differ keep the time per tetrahedron."""
        self._weight, self._n, self._t, self._nn, self._nt = (DECAY * old + new for old, new in zip(
            (self._weight, self._n, self._t, self._nn, self._nt), (1, n, t, n * n, n * t)))
        mean, seconds = self._n / self._weight, self._t / self._weight
        variance = self._nn / self._weight - mean * mean
        if variance > (0.1 * mean) ** 2:
            self._slope = max((self._nt / self._weight - mean * seconds) / variance, 0.01 * seconds / mean)
        self._slope = min(self._slope, seconds / mean)  # which an earlier picture that compiled shaders may have made too large
        return seconds - self._slope * mean
