# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference picture: every pixel's ray clipped against every cell in float64, segments sorted along that ray and
integrated by Gauss-Legendre quadrature of C a exp(-int a). Nothing here is shared with the mapper."""
import numpy as np

from .crossings import clip, crossings, dot, pixels_of_rectangles, rectangles

NODES, WEIGHTS = (0.5 * (v + o) for v, o in zip(np.polynomial.legendre.leggauss(16), (1.0, 0.0)))
DEEPEST = 45.0  # exp(-45) = 3e-20: nothing behind it is seen
CHUNK = 20000


def render(cells, view, transfer, opaque=None, integration="exact", split=True, begin=None):
    """RGBA (height, width, 4), colour premultiplied. opaque, begin: world length along each ray where it ends (or inf) and
    where it begins (or -inf)."""
    origins, directions, start, end = view.rays()
    if begin is not None:
        start = np.maximum(start, np.asarray(begin).ravel())
    if opaque is not None:
        end = np.minimum(end, np.asarray(opaque).ravel())
    pixel, t0, t1, s0, s1 = _segments(cells, view, origins, directions, start, end)
    order = np.lexsort((t1, t0, pixel))
    pixel, t0, t1, s0, s1 = (a[order] for a in (pixel, t0, t1, s0, s1))
    pixel, length, s0, s1 = _split(pixel, t1 - t0, s0, s1, transfer.breakpoints if split else [])
    depth, emission = integrate(length, s0, s1, transfer, integration, split)
    return composite(pixel, depth, emission, view)


def ray_segments(cells, view):
    """(pixel, t_in, t_out, cell) of every ray and cell, sorted by pixel and t_in: the true order."""
    origins, directions, start, end = view.rays()
    cell, pixel, t0, t1 = crossings(cells, view, origins, directions, start, end)
    order = np.lexsort((t0, pixel))
    return pixel[order], t0[order], t1[order], cell[order]


def between_planes(view, planes):
    """World lengths along every ray between which it lies in front of all planes, given as (origin, normal)."""
    origins, directions, _, _ = view.rays()
    everywhere = np.full(len(origins), np.inf)
    outward = [(*-np.asarray(normal, float), -np.dot(normal, origin)) for origin, normal in planes]
    return clip(outward, origins, directions, -everywhere, everywhere)


def _segments(cells, view, origins, directions, start, end):
    cell, p, t_in, t_out = crossings(cells, view, origins, directions, start, end)
    gradient, offset = cells.gradients[cell], cells.offsets[cell]
    base, slope = dot(origins[p], gradient) + offset, dot(directions[p], gradient)
    return p, t_in, t_out, base + slope * t_in, base + slope * t_out


def _split(pixel, length, s0, s1, breakpoints):
    """Cuts every segment where its scalar crosses a control point; pieces stay in order along the ray."""
    rise = s1 - s0
    cuts = [np.zeros_like(s0)]
    for b in breakpoints:
        u = np.divide(b - s0, rise, out=np.zeros_like(s0), where=rise != 0)
        cuts.append(np.clip(u, 0, 1))
    cuts = np.sort(np.stack(cuts + [np.ones_like(s0)], axis=1), axis=1)
    a, b = cuts[:, :-1], cuts[:, 1:]
    keep = b > a
    row = np.nonzero(keep)[0]
    a, b = a[keep], b[keep]
    return pixel[row], length[row] * (b - a), s0[row] + rise[row] * a, s0[row] + rise[row] * b


def integrate(length, s0, s1, transfer, integration, split):
    """Optical depth and emitted colour of each piece, seen from its front end."""
    a0, a1 = transfer.extinction(s0), transfer.extinction(s1)
    depth = 0.5 * (a0 + a1) * length
    if integration == "average":
        mean = 0.5 * (transfer.color(s0) + transfer.color(s1))
        return depth, -np.expm1(-depth)[:, None] * mean
    emission = np.zeros((len(length), 3))
    for first in range(0, len(length), CHUNK):
        part = slice(first, first + CHUNK)
        emission[part] = _quadrature(length[part], s0[part], s1[part], a0[part], a1[part], depth[part], transfer, split)
    return depth, emission


def _quadrature(length, s0, s1, a0, a1, depth, transfer, split):
    # u in [0, seen]: beyond DEEPEST the medium is black.
    with np.errstate(divide="ignore", invalid="ignore"):
        c = DEEPEST / length
        root = np.sqrt(np.maximum(a0 * a0 + 2 * (a1 - a0) * c, 0))
        seen = np.where(depth > DEEPEST, np.minimum(1, 2 * c / (a0 + root)), 1.0)
    panels = np.maximum(1, np.ceil(np.minimum(depth, DEEPEST))).astype(int)
    row = np.repeat(np.arange(len(length)), panels)
    number = np.arange(len(row)) - np.repeat(np.cumsum(panels) - panels, panels)
    step = (seen / panels)[row]
    u = (number[:, None] + NODES) * step[:, None]
    optical = length[row, None] * u * (a0[row, None] + 0.5 * (a1 - a0)[row, None] * u)
    if split:
        s = s0[row, None] + (s1 - s0)[row, None] * u
        extinction, color = transfer.extinction(s), transfer.color(s)
    else:
        extinction = a0[row, None] + (a1 - a0)[row, None] * u
        c0, c1 = transfer.color(s0)[row, None], transfer.color(s1)[row, None]
        color = c0 + (c1 - c0) * u[..., None]
    weight = WEIGHTS * step[:, None] * length[row, None] * extinction * np.exp(-optical)
    total = np.einsum("ij,ijk->ik", weight, color)
    return np.stack([np.bincount(row, total[:, k], len(length)) for k in range(3)], axis=1)


def composite(pixel, depth, emission, view):
    """RGBA of segments that are sorted by pixel and, at each, from front to back."""
    count = view.width * view.height
    total = np.bincount(pixel, depth, count)
    before = np.cumsum(depth) - depth
    first = np.searchsorted(pixel, np.arange(count))
    before -= (np.append(before, 0.0)[np.minimum(first, len(before))])[pixel]
    through = np.exp(-before)[:, None] * emission
    channels = [np.bincount(pixel, through[:, k], count) for k in range(3)]
    rgba = np.stack(channels + [-np.expm1(-total)], axis=1)
    return rgba.reshape(view.height, view.width, 4)


def over(rgba, background):
    """The layer laid over an opaque colour (one colour, or one per pixel)."""
    return rgba[..., :3] + (1 - rgba[..., 3:]) * np.asarray(background)


def opaque_distance(triangles, view):
    """World length along each ray to the nearest of (n,3,3) triangles, inf where there is none."""
    nearest = np.full(view.width * view.height, np.inf)
    pixel, t = triangle_hits(triangles, view)
    np.minimum.at(nearest, pixel, t)
    return nearest


def triangle_hits(triangles, view):
    """(pixel, world length) of all hits of rays with (n,3,3) triangles (Moeller-Trumbore)."""
    origins, directions, start, _ = view.rays()
    a, b, c = np.asarray(triangles, float).reshape(-1, 3, 3).swapaxes(0, 1)
    found = [(np.empty(0, int), np.empty(0))]
    for k, x, y in pixels_of_rectangles(*rectangles(np.stack([a, b, c], axis=1), view)):
        pixel = y * view.width + x
        direction, s, e1, e2 = directions[pixel], origins[pixel] - a[k], (b - a)[k], (c - a)[k]
        p, q = np.cross(direction, e2), np.cross(s, e1)
        det = dot(p, e1)
        with np.errstate(divide="ignore", invalid="ignore"):
            u, v, t = dot(s, p) / det, dot(direction, q) / det, dot(q, e2) / det
            hit = (det != 0) & (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= start[pixel])
        found.append((pixel[hit], t[hit]))
    return tuple(np.concatenate(parts) for parts in zip(*found))
