# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangles between points on the globe that have no cells: Delaunay's, which on a sphere are the convex hull of the points."""
from __future__ import annotations

import numpy as np

from .extras import need
from .horizontal import GridError
from .section_rows import is_line

NEAREST = 3  # whose distance is the spacing at a point
FARTHEST = 6.0  # an edge, in spacings of its triangle; longer ones bridge a gap or go round a region
WIDEST = np.radians(30.0)  # any edge: a longer chord is deep below the ground

_last: dict = {"places": None, "found": None}  # of the steps of a series


def triangulated(places: np.ndarray, dim: str) -> np.ndarray:
    """The triangles (n, 3) between unit vectors; those that would bridge a gap are left out."""
    if _last["places"] is None or not np.array_equal(_last["places"], places, equal_nan=True):
        _last.update(places=places, found=_triangles(places, dim))
    return _last["found"]


def _triangles(places: np.ndarray, dim: str) -> np.ndarray:
    need("scipy", "drawing a list of points without cells")
    there = np.flatnonzero(np.isfinite(places).all(axis=1))
    there = there[np.unique(np.round(places[there] * 5e6).astype(np.int64), axis=0, return_index=True)[1]]  # stations that are listed twice
    points = places[there]
    found = _hull(points) if len(points) > 3 else np.empty((0, 3), int)
    found = found[_small(points, found)] if len(found) else found
    if not len(found):
        if is_line(places):
            raise GridError(f"The {len(points)} points of ({dim}) lie along a line, so the data are a section, which has no area to draw from outside. Draw it by distance and height: dataset.nephoscope.plot().")
        raise GridError(f"The {len(points)} points of ({dim}) are a list without cells, too few or too far from one another for triangles between them. Give the mesh file: "
                        "nephoscope.open(DATA, mesh=GRID).")
    return there[found]


def _hull(points: np.ndarray) -> np.ndarray:
    from scipy.spatial import ConvexHull, QhullError
    try:
        return ConvexHull(points).simplices
    except QhullError:  # all on one circle
        return np.empty((0, 3), int)


def _small(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    from scipy.spatial import cKDTree
    near = cKDTree(points).query(points, NEAREST + 1)[0][:, -1]
    corners = points[triangles]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1).max(axis=1)
    return longest < np.minimum(FARTHEST * near[triangles].mean(axis=1), 2 * np.sin(WIDEST / 2))
