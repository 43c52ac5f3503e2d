# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference picture of several media that may overlap: along every ray their extinctions add, and each emits in proportion to its own.
Rays are cut at every cell of every medium and at every control point, and integrated by Gauss-Legendre quadrature in float64."""
import numpy as np

from . import reference

NODES, WEIGHTS = reference.NODES, reference.WEIGHTS
PANELS = 4
PLACES = np.concatenate([(panel + NODES) / PANELS for panel in range(PANELS)])  # in an interval, from 0 to 1
SHARES = np.tile(WEIGHTS / PANELS, PANELS)
SHORTEST = 1e-9  # shorter pieces are rounding where a ray meets an edge; _linear would take one for the cell that begins with it


def render(media, view, opaque=None, begin=None):
    """RGBA (height, width, 4), colour premultiplied. media: (cells, transfer) or (cells, transfer, planes) of each, whose cells do not
    overlap one another, with the clipping planes of that medium as (origin, normal). opaque, begin: world lengths along the rays."""
    origins, directions, start, end = view.rays()
    start = start if begin is None else np.maximum(start, np.ravel(begin))
    end = end if opaque is None else np.minimum(end, np.ravel(opaque))
    pieces = []
    for cells, transfer, *planes in media:
        first, last = start, end
        if planes:
            between = reference.between_planes(view, planes[0])
            first, last = np.maximum(start, between[0]), np.minimum(end, between[1])
        pieces.append(_pieces(cells, transfer, view, origins, directions, first, last))
    pixel, t0, t1 = _intervals(pieces)
    rate, source = _linear(media, pieces, pixel, t0, t1)
    length = (t1 - t0)[:, None]
    optical = length * (rate[:, :1] * PLACES + 0.5 * (rate[:, 1:] - rate[:, :1]) * PLACES ** 2)
    moments = np.exp(-optical) @ (SHARES[:, None] * PLACES[:, None] ** (0, 1, 2))
    emission = np.einsum("ij,ijk->ik", length * moments, source)
    return reference.composite(pixel, length[:, 0] * rate.mean(axis=1), emission, view)


def _pieces(cells, transfer, view, origins, directions, start, end):
    """(pixel, t0, t1, s0, s1), sorted, of each cell that a ray crosses, cut at the control points."""
    pixel, t0, t1, s0, s1 = reference._segments(cells, view, origins, directions, start, end)
    cuts = [np.zeros_like(t0), np.ones_like(t0)]
    for b in transfer.breakpoints:
        cuts.append(np.clip(np.divide(b - s0, s1 - s0, out=np.zeros_like(s0), where=s1 != s0), 0, 1))
    cuts = np.sort(np.stack(cuts, axis=1), axis=1)
    a, b = cuts[:, :-1], cuts[:, 1:]
    row, column = np.nonzero((b - a) * (t1 - t0)[:, None] > SHORTEST * max(1, np.abs(t1).max(initial=0)))
    a, b = a[row, column], b[row, column]
    mix = lambda low, high, u: low[row] + (high - low)[row] * u
    parts = (pixel[row], mix(t0, t1, a), mix(t0, t1, b), mix(s0, s1, a), mix(s0, s1, b))
    order = np.lexsort((parts[1], parts[0]))
    return [p[order] for p in parts]


def _intervals(pieces):
    """Along every ray between all places where a piece of any medium ends."""
    pixel = np.concatenate([p for part in pieces for p in (part[0], part[0])])
    t = np.concatenate([p for part in pieces for p in (part[1], part[2])])
    order = np.lexsort((t, pixel))
    pixel, t = pixel[order], t[order]
    keep = (pixel[1:] == pixel[:-1]) & (t[1:] > t[:-1])
    return pixel[:-1][keep], t[:-1][keep], t[1:][keep]


def _linear(media, pieces, pixel, t0, t1):
    """In each interval: the extinction of all media at its two ends, between which it is linear, and the coefficients of extinction times colour, which is
    quadratic, in the place from 0 to 1: (intervals, 3 powers, 3 colours)."""
    rate, source = np.zeros((len(t0), 2)), np.zeros((len(t0), 3, 3))
    middle = 0.5 * (t0 + t1)
    far = 4 * max([1.0] + [np.abs(part[2]).max() for part in pieces if len(part[2])])
    for (_, transfer, *_), (at, begin, end, s0, s1) in zip(media, pieces):
        if not len(at):
            continue
        number = np.searchsorted(at * far + begin, pixel * far + middle, side="right") - 1
        inside = (number >= 0) & (at[number] == pixel) & (end[number] > middle)
        n = number[inside]
        a0, a1, c0, c1 = transfer.extinction(s0)[n], transfer.extinction(s1)[n], transfer.color(s0)[n], transfer.color(s1)[n]
        low, high = ((t[inside] - begin[n]) / (end - begin)[n] for t in (t0, t1))
        e, de = (a0 + (a1 - a0) * low)[:, None], ((a1 - a0) * (high - low))[:, None]
        c, dc = c0 + (c1 - c0) * low[:, None], (c1 - c0) * (high - low)[:, None]
        rate[inside] += np.concatenate([e, e + de], axis=1)
        source[inside] += np.stack([e * c, e * dc + de * c, de * dc], axis=1)
    return rate, source
