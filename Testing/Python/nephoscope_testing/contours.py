# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference pictures with contour surfaces, layers and transfer functions that jump: per-ray quadrature in float64, everything
sorted along the ray. Only the clipping of rays and the compositing of sorted pieces are those of reference.py."""
from dataclasses import dataclass

import numpy as np

from . import reference
from .crossings import crossings, dot
from .transfer import Transfer

NARROW = 1e-13  # of the range: closer nodes than these are a jump


class Jumps(Transfer):
    """A transfer function whose rows may share a scalar: the first is the limit from below, the last that from above."""

    def pieces(self, s0, s1):
        """Extinction and colour at both ends of pieces that no control point divides, as limits from inside."""
        rate = self.opacity_scale / self.unit_distance
        values = [_limits(self.opacities, s0, s1, 1) * rate] + [_limits(self.colors, s0, s1, 1 + k) for k in range(3)]
        return values[0][0], values[0][1], np.stack([v[0] for v in values[1:]], 1), np.stack([v[1] for v in values[1:]], 1)


def _limits(rows, s0, s1, column):
    """The line of the interval that holds the middle, at both ends."""
    x, y = rows[:, 0], rows[:, column]
    low = np.searchsorted(x, 0.5 * (s0 + s1), side="right") - 1
    inside = (low >= 0) & (low < len(x) - 1)
    k = np.clip(low, 0, len(x) - 2) if len(x) > 1 else np.zeros(len(s0), int)
    if len(x) == 1:
        return np.full((2, len(s0)), y[0])
    width = x[k + 1] - x[k]
    slope = np.divide(y[k + 1] - y[k], width, out=np.zeros(len(k)), where=width > 0)
    outside = np.where(low < 0, y[0], y[-1])
    return np.stack([np.where(inside, y[k] + slope * (s - x[k]), outside) for s in (s0, s1)])


@dataclass
class Surface:
    """A contour; color None: of the transfer function. shading: (ambient, diffuse, specular, power), None: not lit."""
    value: float
    opacity: float = 0.3
    color: tuple = None
    shading: tuple = None


def render(cells, view, transfer, surfaces=(), contoured=None, layers=None, layer_of_cell=None):
    """RGBA as reference.render gives it. contoured: the cells with the contoured scalar, if that is another; layers: {number:
    transfer}, the number being that of layer_of_cell or, without, that of the values at or below the contoured scalar."""
    origins, directions, start, end = view.rays()
    contoured = contoured or cells
    values = sorted(s.value for s in surfaces)
    cell, p, t_in, t_out = crossings(cells, view, origins, directions, start, end)
    ends = origins[p] + directions[p] * t_in[:, None], origins[p] + directions[p] * t_out[:, None]
    s, c = ([dot(x, of.gradients[cell]) + of.offsets[cell] for x in ends] for of in (cells, contoured))
    events = []
    for surface in surfaces:
        hit = (c[0] >= surface.value) != (c[1] >= surface.value)
        u = (surface.value - c[0][hit]) / (c[1][hit] - c[0][hit])
        t = t_in[hit] + u * (t_out - t_in)[hit]
        at = s[0][hit] + u * (s[1] - s[0])[hit]
        events.append((p[hit], t, *_surface_light(surface, at, contoured.gradients[cell[hit]], directions[p[hit]], transfer)))
    columns = _cut((p, t_in, t_out, *s, *c, cell), values, (5, 6))
    breakpoints = np.unique(np.concatenate([f.breakpoints for f in [transfer, *(layers or {}).values()]]))
    columns = _cut(columns, breakpoints, (3, 4))
    if layers is None:
        number = np.full(len(columns[0]), -1)
    elif layer_of_cell is None:
        number = np.searchsorted(values, 0.5 * (columns[5] + columns[6]), side="right")
    else:
        number = np.asarray(layer_of_cell)[columns[7].astype(int)]
    pixel, t, depth, emission = _media(columns, number, transfer, layers or {})
    if events:
        more = [np.concatenate(x) for x in zip(*events)]
        pixel, t, depth, emission = (np.concatenate(x) for x in zip((pixel, t, depth, emission), more))
    order = np.lexsort((t, pixel))
    return reference.composite(pixel[order].astype(int), depth[order], emission[order], view)


def _cut(columns, values, which):
    """Cuts the segments where the scalars (columns `which`) cross values; columns 1 to 6 are linear along a segment."""
    f0, f1 = columns[which[0]], columns[which[1]]
    rise = f1 - f0
    with np.errstate(divide="ignore", invalid="ignore"):
        cuts = [np.clip(np.where(rise != 0, (v - f0) / rise, 0), 0, 1) for v in values]
    cuts = np.sort(np.stack([np.zeros_like(f0)] + cuts + [np.ones_like(f0)], axis=1), axis=1)
    a, b = cuts[:, :-1], cuts[:, 1:]
    keep = b > a
    row = np.nonzero(keep)[0]
    a, b = a[keep], b[keep]
    result = [columns[0][row]]
    for k in (1, 3, 5):
        low, change = columns[k][row], (columns[k + 1] - columns[k])[row]
        result += [low + change * a, low + change * b]
    return result + [columns[7][row]]


def _media(columns, number, transfer, layers):
    pixel, t0, t1, s0, s1 = columns[:5]
    length = t1 - t0
    a0, a1, c0, c1 = (np.zeros(s) for s in (len(pixel), len(pixel), (len(pixel), 3), (len(pixel), 3)))
    for n in np.unique(number):
        part = number == n
        f = layers.get(int(n), transfer)
        jumps = Jumps(f.colors, f.opacities, f.unit_distance, f.opacity_scale)
        a0[part], a1[part], c0[part], c1[part] = jumps.pieces(s0[part], s1[part])
    depth, emission = 0.5 * (a0 + a1) * length, np.zeros((len(pixel), 3))
    for first in range(0, len(length), reference.CHUNK):
        part = slice(first, first + reference.CHUNK)
        emission[part] = reference._quadrature(length[part], c0[part], c1[part], a0[part], a1[part], depth[part], _Ends, False)
    return pixel, t0 + 0.5 * length, depth, emission


class _Ends:
    """Stands for a transfer function whose "scalars" are colours already."""
    color = staticmethod(lambda c: c)


def _surface_light(surface, s, gradients, directions, transfer):
    """Optical depth and emission of a surface, lit by a headlight."""
    color = np.broadcast_to(surface.color, (len(s), 3)) if surface.color is not None else transfer.color(s)
    if surface.shading:
        ambient, diffuse, specular, power = surface.shading
        towards = np.abs(dot(directions, gradients)) / np.linalg.norm(gradients, axis=1)
        # The light shines along the view direction in a parallel projection, which is what this reference is for.
        color = np.minimum(color * (ambient + diffuse * towards)[:, None] + (specular * towards ** power)[:, None], 1)
    alpha = min(surface.opacity, 1 - 1e-12)
    return np.full(len(s), -np.log1p(-alpha)), alpha * color
