# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference picture: every pixel's ray clipped against every cell in float64, segments sorted along that ray and
integrated by Gauss-Legendre quadrature of C a exp(-int a). Nothing here is shared with the mapper."""
import numpy as np

NODES, WEIGHTS = (0.5 * (v + o) for v, o in zip(np.polynomial.legendre.leggauss(16), (1.0, 0.0)))
DEEPEST = 45.0  # exp(-45) = 3e-20: nothing behind it is seen
CHUNK = 20000
ASIDE = 1e-10 * np.array([0.6180339887, 0.7320508076, 0.2360679775])  # of the cell's size, in no plane of a lattice
ALONG = 1e-9  # sine of the angle between a ray and a plane that it is in, to within rounding


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
    parts = [(p, a, b, np.full(len(p), i)) for i, p, a, b in _clipped(cells, view, origins, directions, start, end)]
    pixel, t0, t1, cell = (np.concatenate(x) for x in zip(*parts))
    order = np.lexsort((t0, pixel))
    return pixel[order], t0[order], t1[order], cell[order]


def _candidates(corners, view):
    """Indices of the pixels that the cell's bounding rectangle covers; all of them when it reaches the eye."""
    if not view.parallel and view.depth(corners).min() <= 1e-9 * np.abs(view.depth(corners)).max():
        return np.arange(view.width * view.height)
    xy = view.pixels(corners)
    size = (view.width, view.height)
    low = np.clip(np.floor(xy.min(axis=0)).astype(int) - 1, 0, size)
    high = np.clip(np.ceil(xy.max(axis=0)).astype(int) + 1, 0, size)
    return (np.arange(low[1], high[1])[:, None] * view.width + np.arange(low[0], high[0])).ravel()


def clip(planes, origins, directions, start, end, aside=(0, 0, 0)):
    """Entry and exit parameters of rays through the half-spaces n.x <= c; entry >= exit where a ray misses.

    A ray in a plane, to within rounding, is moved aside, so that it belongs to one of the two cells at a face.
    """
    t_in, t_out = start.copy(), end.copy()
    lengths = np.linalg.norm(directions, axis=1)
    for nx, ny, nz, c in planes:
        normal = np.array([nx, ny, nz])
        gap, slope = c - origins @ normal, directions @ normal
        gap = np.where(np.abs(slope) < ALONG * np.linalg.norm(normal) * lengths, gap - normal @ np.asarray(aside), gap)
        with np.errstate(divide="ignore", invalid="ignore"):
            t = gap / slope
        t_out = np.where(slope > 0, np.minimum(t_out, t), t_out)
        t_in = np.where(slope < 0, np.maximum(t_in, t), t_in)
        t_out = np.where((slope == 0) & (gap < 0), -np.inf, t_out)
    return t_in, t_out


def between_planes(view, planes):
    """World lengths along every ray between which it lies in front of all planes, given as (origin, normal)."""
    origins, directions, _, _ = view.rays()
    everywhere = np.full(len(origins), np.inf)
    outward = [(*-np.asarray(normal, float), -np.dot(normal, origin)) for origin, normal in planes]
    return clip(outward, origins, directions, -everywhere, everywhere)


def _clipped(cells, view, origins, directions, start, end):
    for i in range(len(cells)):
        if len(cells.planes[i]) < 4:
            continue
        p = _candidates(cells.corners[i], view)
        if not len(p):
            continue
        # Moved to the cell, so that huge coordinates cost no digits.
        base = cells.corners[i][0]
        planes = cells.planes[i].copy()
        planes[:, 3] -= planes[:, :3] @ base
        aside = ASIDE * np.ptp(cells.corners[i], axis=0).max()
        t_in, t_out = clip(planes, origins[p] - base, directions[p], start[p], end[p], aside)
        hit = t_out > t_in
        if hit.any():
            yield i, p[hit], t_in[hit], t_out[hit]


def _segments(cells, view, origins, directions, start, end):
    parts = [(np.empty(0, int),) + (np.empty(0),) * 4]
    for i, p, t_in, t_out in _clipped(cells, view, origins, directions, start, end):
        gradient, offset = cells.field[i]
        base, slope = origins[p] @ gradient + offset, directions[p] @ gradient
        parts.append((p, t_in, t_out, base + slope * t_in, base + slope * t_out))
    return [np.concatenate(x) for x in zip(*parts)]


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
    start = view.rays()[2]
    nearest = np.full(len(start), np.inf)
    for hit, t in triangle_hits(triangles, view):
        nearest = np.where(hit, np.minimum(nearest, t), nearest)
    return nearest


def triangle_hits(triangles, view):
    """For each of (n,3,3) triangles: which rays hit it, and at what world length (Moeller-Trumbore)."""
    origins, directions, start, _ = view.rays()
    for a, b, c in np.asarray(triangles, float):
        e1, e2 = b - a, c - a
        p = np.cross(directions, e2)
        det = p @ e1
        with np.errstate(divide="ignore", invalid="ignore"):
            s = origins - a
            u = np.einsum("ij,ij->i", s, p) / det
            q = np.cross(s, e1)
            v = np.einsum("ij,ij->i", directions, q) / det
            t = (q @ e2) / det
        yield (det != 0) & (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= start), t
