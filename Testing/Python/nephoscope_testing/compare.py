# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How two pictures differ: one metric, with the pixels at the mesh's silhouette left out."""
import numpy as np

# A rasteriser places vertices on a grid of 1/256 pixel: nearer to an edge than this (pixels), the sliver between
# the edge and the pixel centre may be given to the neighbouring tetrahedron, or to none at the silhouette.
NEAR_EDGE = 0.01


def edge_mask(edges, view, distance=NEAR_EDGE):
    """True where a pixel centre lies within distance (pixels) of a projected edge; edges: (n,2,3) in the world."""
    mask = np.zeros((view.height, view.width), bool)
    smallest = 1e-6 * (view.far if not view.parallel else 1.0)
    for a, b in edges:
        za, zb = view.depth(a), view.depth(b)
        if not view.parallel:
            if max(za, zb) <= smallest:
                continue
            if za < smallest:
                a = b + (a - b) * (zb - smallest) / (zb - za)
            if zb < smallest:
                b = a + (b - a) * (za - smallest) / (za - zb)
        _mark(mask, view.pixels(a), view.pixels(b), distance)
    return mask


def _mark(mask, p, q, distance):
    size = np.array(mask.shape[::-1])
    low = np.clip(np.floor(np.minimum(p, q) - 1), 0, size).astype(int)
    high = np.clip(np.ceil(np.maximum(p, q) + 1), 0, size).astype(int)
    x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
    if not x.size:
        return
    d = q - p
    length2 = max(d @ d, 1e-300)
    u = np.clip(((x - p[0]) * d[0] + (y - p[1]) * d[1]) / length2, 0, 1)
    near = np.hypot(x - p[0] - u * d[0], y - p[1] - u * d[1]) <= distance
    mask[low[1]:high[1], low[0]:high[0]] |= near


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
