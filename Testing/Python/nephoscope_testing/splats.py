# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of splats by quadrature: the kernel is integrated numerically along every ray, without its closed form."""
import numpy as np

INNER, OUTER = 0.889392, 1.556228


def cubic(r):
    """The reconstruction kernel of Crawfis and Max (1993), table 1; r in cells."""
    near = 0.557526 - 1.157743 * r**2 + 0.671033 * r**3
    rest = np.maximum(OUTER - r, 0)
    return np.where(r <= INNER, near, 0.067599 * rest**2 + 0.282474 * rest**3)


def gaussian(r):
    """The Gaussian of the same variance; along a ray it is not cut off."""
    return np.exp(-0.5 * r**2 / 0.199406) / (2 * np.pi * 0.199406)**1.5


def optical_depths(view, position, jacobian, stop=None, nodes=192, begin=None, kernel=cubic, radius=OUTER):
    """Integral of the kernel along every ray (world length), from the world length `begin` to `stop`."""
    origins, directions, _, _ = view.rays()
    inverse = np.linalg.inv(jacobian)
    reach = radius * np.linalg.norm(jacobian, 2)
    middle = np.einsum("ij,ij->i", position - origins, directions)
    x, w = np.polynomial.legendre.leggauss(nodes)
    low = middle - reach
    high = middle + reach if stop is None else np.clip(stop, low, middle + reach)
    low = low if begin is None else np.clip(begin, low, high)
    low = np.maximum(low, 0.0) if not view.parallel else low
    half = 0.5 * np.maximum(high - low, 0)
    t = (low + half)[:, None] + half[:, None] * x
    near = np.abs(middle) < np.inf
    total = np.zeros(len(middle))
    # Rays that pass at a distance have nothing to integrate.
    miss = np.linalg.norm(np.cross(position - origins, directions), axis=1) > reach
    rows = np.flatnonzero(near & ~miss)
    for chunk in np.array_split(rows, max(1, len(rows) // 4096)):
        points = origins[chunk, None] + t[chunk, :, None] * directions[chunk, None] - position
        total[chunk] = half[chunk] * (kernel(np.linalg.norm(points @ inverse.T, axis=2)) @ w)
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
