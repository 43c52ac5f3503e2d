# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where rays enter and leave convex cells, in float64: every ray of a view against the half-spaces of every cell."""
import numpy as np

ASIDE = 1e-10 * np.array([0.6180339887, 0.7320508076, 0.2360679775])  # of the cell's size, in no plane of a lattice
ALONG = 1e-9  # sine of the angle between a ray and a plane that it is in, to within rounding
PAIRS = 30_000  # of a cell and a ray, at a time


def crossings(cells, view, origins, directions, start, end):
    """(cell, pixel, t_in, t_out) of every ray that crosses a cell, in the order of the cells."""
    sides = np.array([len(planes) for planes in cells.planes], int)
    low, high = rectangles(cells.corners, view)
    found = [(np.empty(0, int), np.empty(0, int), np.empty(0), np.empty(0))]
    for number in np.unique(sides[sides >= 4]):
        alike = np.nonzero(sides == number)[0]
        # Moved to the cell, so that huge coordinates cost no digits.
        base = np.array([cells.corners[i][0] for i in alike])
        aside = ASIDE * np.array([np.ptp(cells.corners[i], axis=0).max() for i in alike])[:, None]
        planes = np.array([cells.planes[i] for i in alike])
        planes[..., 3] -= np.einsum("ijk,ik->ij", planes[..., :3], base)
        for k, x, y in pixels_of_rectangles(low[alike], high[alike]):
            p = y * view.width + x
            t_in, t_out = clip(planes[k].swapaxes(0, 1), origins[p] - base[k], directions[p], start[p], end[p], aside[k])
            hit = t_out > t_in
            found.append((alike[k[hit]], p[hit], t_in[hit], t_out[hit]))
    cell, pixel, t_in, t_out = (np.concatenate(parts) for parts in zip(*found))
    order = np.argsort(cell, kind="stable")
    return cell[order], pixel[order], t_in[order], t_out[order]


def clip(planes, origins, directions, start, end, aside=(0, 0, 0)):
    """Entry and exit parameters of rays through the half-spaces n.x <= c; entry >= exit where a ray misses.

    planes: rows (n, c), each of all rays or with one for each ray. A ray in a plane, to within rounding, is moved aside, so that it
    belongs to one of the two cells at a face.
    """
    t_in, t_out = start.copy(), end.copy()
    lengths = np.sqrt(dot(directions, directions))
    for plane in np.asarray(planes, float):
        normal, c = plane[..., :3], plane[..., 3]
        gap, slope = c - dot(origins, normal), dot(directions, normal)
        inside = np.abs(slope) < ALONG * np.sqrt(dot(normal, normal)) * lengths
        gap = np.where(inside, gap - dot(normal, np.asarray(aside)), gap)
        with np.errstate(divide="ignore", invalid="ignore"):
            t = gap / slope
        t_out = np.where(slope > 0, np.minimum(t_out, t), t_out)
        t_in = np.where(slope < 0, np.maximum(t_in, t), t_in)
        t_out = np.where((slope == 0) & (gap < 0), -np.inf, t_out)
    return t_in, t_out


def dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def rectangles(corners, view):
    """Lowest pixel, and the one beyond the highest, of the bounding rectangle of each (k,3) of corners; all pixels where it reaches the eye."""
    size = np.array([view.width, view.height])
    if not len(corners):
        return np.empty((0, 2), int), np.empty((0, 2), int)
    points = np.concatenate(corners)
    first = np.cumsum([0] + [len(c) for c in corners[:-1]])
    with np.errstate(divide="ignore", invalid="ignore"):
        xy = view.pixels(points)
    low, high = (extreme.reduceat(xy, first, axis=0) for extreme in (np.minimum, np.maximum))
    if not view.parallel:
        depth = view.depth(points)
        behind = np.minimum.reduceat(depth, first) <= 1e-9 * np.maximum.reduceat(np.abs(depth), first)
        low[behind], high[behind] = 0, size
    return np.clip(np.floor(low) - 1, 0, size).astype(int), np.clip(np.ceil(high) + 1, 0, size).astype(int)


def pixels_of_rectangles(low, high):
    """(number of the rectangle, x, y) of every pixel of the rectangles [low, high), in chunks of about PAIRS."""
    width, height = np.maximum(high - low, 0).T
    ends = np.cumsum(width * height)
    begin = 0
    while begin < len(ends):
        passed = ends[begin - 1] if begin else 0
        stop = max(begin + 1, np.searchsorted(ends, passed + PAIRS, side="right"))
        k = np.repeat(np.arange(begin, stop), (width * height)[begin:stop])
        place = np.arange(len(k)) + passed - (ends - width * height)[k]
        if len(k):
            yield k, low[k, 0] + place % width[k], low[k, 1] + place // width[k]
        begin = stop
