# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of splats by quadrature: the kernel is integrated numerically along every ray, without its closed form."""
import functools

import numpy as np

INNER, OUTER = 0.889392, 1.556228


def with_vectors(style, placement, array="v"):
    """Sets the vectors of a mapper."""
    def set_vectors(mapper):
        mapper.SetVectorArrayName(array)
        mapper.SetVectorStyle(style)
        mapper.SetVectorPlacement(placement)
    return set_vectors


def cubic(r):
    """The reconstruction kernel of Crawfis and Max (1993), table 1; r in cells."""
    near = 0.557526 + r * r * (0.671033 * r - 1.157743)
    rest = np.maximum(OUTER - r, 0)
    return np.where(r <= INNER, near, rest * rest * (0.067599 + 0.282474 * rest))


def gaussian(r):
    """The Gaussian of the same variance; along a ray it is not cut off."""
    return np.exp(-0.5 * r**2 / 0.199406) / (2 * np.pi * 0.199406)**1.5


@functools.lru_cache(maxsize=None)
def quadrature(nodes):
    """Places and weights on -1 ... 1. To find 192 of them takes longer than to use them."""
    return np.polynomial.legendre.leggauss(nodes)


def optical_depths(view, position, jacobian, stop=None, nodes=192, begin=None, kernel=cubic, radius=OUTER):
    """Integral of the kernel along every ray (world length), from the world length `begin` to `stop`."""
    origins, directions, _, _ = view.rays()
    inverse = np.linalg.inv(jacobian)
    reach = radius * np.linalg.norm(jacobian, 2)
    middle = np.einsum("ij,ij->i", position - origins, directions)
    x, w = quadrature(nodes)
    low = middle - reach
    high = middle + reach if stop is None else np.clip(stop, low, middle + reach)
    low = low if begin is None else np.clip(begin, low, high)
    low = np.maximum(low, 0.0) if not view.parallel else low
    half = 0.5 * np.maximum(high - low, 0)
    near = np.abs(middle) < np.inf
    total = np.zeros(len(middle))
    # Rays that pass at a distance have nothing to integrate.
    miss = np.linalg.norm(np.cross(position - origins, directions), axis=1) > reach
    rows = np.flatnonzero(near & ~miss)
    # In units of the kernel: a ray passes at a distance of sqrt(least), and moves away from there by sqrt(speed2) per world length.
    start, along = (origins - position) @ inverse.T, directions @ inverse.T
    speed2 = np.einsum("ij,ij->i", along, along)
    nearest = -np.einsum("ij,ij->i", start, along) / speed2
    least = np.sum((start + nearest[:, None] * along) ** 2, axis=1)
    for chunk in np.array_split(rows, max(1, len(rows) // 4096)):
        away = (low + half - nearest)[chunk, None] + half[chunk, None] * x
        total[chunk] = half[chunk] * (kernel(np.sqrt(least[chunk, None] + speed2[chunk, None] * away**2)) @ w)
    return total


def render(view, positions, jacobians, colors, extinctions, stop=None, begin=None):
    """(height, width, 4) premultiplied: splats over each other, nearest to the eye last; what lies between two world lengths."""
    if view.parallel:
        order = np.argsort(-((positions - view.eye) @ view.forward), kind="stable")
    else:
        order = np.argsort(-np.linalg.norm(positions - view.eye, axis=1), kind="stable")
    image = np.zeros((view.height * view.width, 4))
    for i in order:
        alpha = -np.expm1(-extinctions[i] * optical_depths(view, positions[i], jacobians[i], stop, begin=begin))
        image = np.concatenate([alpha[:, None] * colors[i], alpha[:, None]], axis=1) + (1 - alpha[:, None]) * image
    return image.reshape(view.height, view.width, 4)


def lattice_jacobians(points, dimensions):
    """Central differences of (n, 3) points of a structured grid, x fastest; one-sided at its faces."""
    p = points.reshape(dimensions[::-1] + (3,))
    columns = [np.gradient(p, axis=2 - axis) for axis in range(3)]
    return np.stack(columns, axis=-1).reshape(-1, 3, 3)


def lattice_shares(dimensions, jacobians=None):
    """The part of every point's cell that lies in the grid, x fastest: half at each end of an axis, and there, with the points' own Jacobians, as long and
    wide as a quarter of the way to the next point."""
    ends = [np.where((np.arange(n) % (n - 1) == 0), 0.5, 1.0) if n > 1 else np.ones(1) for n in dimensions]
    shares = np.einsum("i,j,k->kji", *ends)
    if jacobians is not None:
        lengths = np.linalg.norm(jacobians, axis=1).reshape(tuple(dimensions)[::-1] + (3,))
        for along, size in enumerate(dimensions):
            for end, beside in ((0, 1), (size - 1, size - 2)) if size > 1 else ():
                at, nearby = ([slice(None)] * 3 for _ in range(2))
                at[2 - along], nearby[2 - along] = end, beside
                across = [axis for axis in range(3) if axis != along]
                growth = 0.75 + 0.25 * lengths[tuple(nearby)] / lengths[tuple(at)]
                shares[tuple(at)] *= growth[..., across].prod(axis=-1)
    return shares.ravel()
