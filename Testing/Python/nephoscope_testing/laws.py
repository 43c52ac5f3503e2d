# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What earlier methods of drawing tetrahedra give, from the rays of the reference: their errors, predicted."""
import numpy as np

from . import crossings, reference

OPPOSITE_EDGES = (((0, 1), (2, 3)), ((0, 2), (1, 3)), ((0, 3), (1, 2)))


def linear_opacity(cells, view, transfer):
    """Shirley and Tuchman's triangles in a parallel projection: in each tetrahedron the opacity falls linearly from that of its
    thickest point to 0 on its silhouette, as thickness does, and the colour is the mean of front and back. For transfer
    functions without control points inside the range of the scalar."""
    assert view.parallel
    origins, directions, _, _ = view.rays()
    pixel, t0, t1, cell = reference.ray_segments(cells, view)
    thickest = np.array([_thickest(cells, i, view, transfer) for i in range(len(cells))])
    alpha = (t1 - t0) / thickest[cell, 0] * -np.expm1(-thickest[cell, 1])
    gradient, offset = (np.array([f[k] for f in cells.field]) for k in (0, 1))
    scalars = [np.einsum("ij,ij->i", origins[pixel] + t[:, None] * directions[pixel], gradient[cell]) + offset[cell]
               for t in (t0, t1)]
    color = 0.5 * (transfer.color(scalars[0]) + transfer.color(scalars[1]))
    return reference.composite(pixel, -np.log1p(-alpha), alpha[:, None] * color, view)


def _thickest(cells, i, view, transfer):
    """Length of the longest ray through a tetrahedron, and its optical depth with extinction linear along it."""
    corners = cells.corners[i]
    flat = np.stack([(corners - view.eye) @ view.right, (corners - view.eye) @ view.up], axis=1)
    places = list(flat) + [p for p in (_crossing(flat[list(a)], flat[list(b)]) for a, b in OPPOSITE_EDGES) if p is not None]
    places = np.array(places)
    origins = view.eye + places[:, :1] * view.right + places[:, 1:] * view.up
    directions = np.broadcast_to(view.forward, origins.shape)
    everywhere = np.full(len(places), 1e9)
    t0, t1 = crossings.clip(cells.planes[i], origins, directions, -everywhere, everywhere)
    best = np.argmax(t1 - t0)
    gradient, offset = cells.field[i]
    rates = [transfer.extinction(gradient @ (origins[best] + t[best] * view.forward) + offset) for t in (t0, t1)]
    length = t1[best] - t0[best]
    return length, 0.5 * (rates[0] + rates[1]) * length


def _crossing(p, q):
    """Where two segments in the plane cross, or None."""
    system = np.column_stack([p[1] - p[0], q[0] - q[1]])
    if abs(np.linalg.det(system)) < 1e-14:
        return None
    u, v = np.linalg.solve(system, q[0] - p[0])
    return p[0] + u * (p[1] - p[0]) if 0 <= u <= 1 and 0 <= v <= 1 else None
