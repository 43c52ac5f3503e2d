# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How two pictures differ: one metric, with the pixels at the mesh's silhouette left out."""
import numpy as np

from .crossings import pixels_of_rectangles

# A rasteriser places vertices on a grid of 1/256 pixel: nearer to an edge than this (pixels), the sliver between
# the edge and the pixel centre may be given to the neighbouring tetrahedron, or to none at the silhouette.
NEAR_EDGE = 0.01


def edge_mask(edges, view, distance=NEAR_EDGE):
    """True where a pixel centre lies within distance (pixels) of a projected edge; edges: (n,2,3) in the world."""
    mask = np.zeros((view.height, view.width), bool)
    ends = _before_the_eye(np.asarray(edges, float).reshape(-1, 2, 3), view)
    p, q = view.pixels(ends[:, 0]), view.pixels(ends[:, 1])
    size = (view.width, view.height)
    low = np.clip(np.floor(np.minimum(p, q) - 1), 0, size).astype(int)
    high = np.clip(np.ceil(np.maximum(p, q) + 1), 0, size).astype(int)
    d = q - p
    length2 = np.maximum((d * d).sum(axis=1), 1e-300)
    for k, x, y in pixels_of_rectangles(low, high):
        along, across = x + 0.5 - p[k, 0], y + 0.5 - p[k, 1]
        u = np.clip((along * d[k, 0] + across * d[k, 1]) / length2[k], 0, 1)
        near = np.hypot(along - u * d[k, 0], across - u * d[k, 1]) <= distance
        mask[y[near], x[near]] = True
    return mask


def _before_the_eye(edges, view):
    """The edges without what lies behind the eye."""
    if view.parallel:
        return edges
    smallest = 1e-6 * view.far
    depth = view.depth(edges)
    seen = depth.max(axis=1) > smallest
    edges, depth = edges[seen].copy(), depth[seen]
    for end in (0, 1):
        behind = depth[:, end] < smallest
        a, b, za, zb = edges[behind, end], edges[behind, 1 - end], depth[behind, end], depth[behind, 1 - end]
        edges[behind, end] = b + (a - b) * ((zb - smallest) / (zb - za))[:, None]
    return edges


class Difference:
    """maximum, percentile (99.5th of the pixels that either picture covers), mean; where the maximum is."""

    def __init__(self, image, expected, mask=None):
        image, expected = np.asarray(image, float), np.asarray(expected, float)
        if image.shape != expected.shape:
            raise ValueError(f"the picture is {image.shape}, the reference {expected.shape}")
        error = np.where(np.isfinite(image), np.abs(image - expected), np.inf).max(axis=2)
        if mask is not None:
            error = np.where(mask, 0, error)
        covered = (np.abs(expected).max(axis=2) > 0) | (np.abs(image).max(axis=2) > 0)
        values = error[covered] if covered.any() else np.zeros(1)
        self.maximum = float(error.max())
        self.percentile = float(np.percentile(values, 99.5))
        self.mean = float(values.mean())
        self.masked = 0 if mask is None else int(mask.sum())
        self.covered = int(covered.sum())
        self.where = tuple(int(i) for i in np.unravel_index(np.argmax(error), error.shape)[::-1])
        self.got = image[self.where[1], self.where[0]]
        self.expected = expected[self.where[1], self.where[0]]

    def __str__(self):
        return (f"max {self.maximum:.3g} ({255 * self.maximum:.2f}/255) at pixel {self.where}: got "
                f"{np.round(self.got, 6)}, expected {np.round(self.expected, 6)}; 99.5 % {self.percentile:.3g}, "
                f"mean {self.mean:.3g}; {self.covered} pixels covered, {self.masked} masked")
