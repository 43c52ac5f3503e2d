# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The finite-time Lyapunov exponent of the double gyre (ShaddenLekienMarsden2005), against two computations that share nothing with it.

Two vortices side by side in a box, whose border between them swings: it stirs, and the exponent has thin ridges. The references follow the exact
velocity: by differences of the end points on the same grid, and by the equation of the tangent map, which knows no grid.
"""
import unittest

import numpy as np
from nephoscope_testing.texture import advection, update
from nephoscope_testing.time_series import TimeSeries

AMPLITUDE, SWING, OMEGA = 0.1, 0.25, 2 * np.pi / 10
AGE = 10.0
SIZE = (201, 101, 2)
AXES = np.linspace(0, 2, SIZE[0]), np.linspace(0, 1, SIZE[1])


def velocity(x, y, time):
    a = SWING * np.sin(OMEGA * time)
    f, slope = a * x**2 + (1 - 2 * a) * x, 2 * a * x + 1 - 2 * a
    return np.stack([-np.pi * AMPLITUDE * np.sin(np.pi * f) * np.cos(np.pi * y),
                     np.pi * AMPLITUDE * np.cos(np.pi * f) * np.sin(np.pi * y) * slope], axis=-1)


def gradient(x, y, time):
    """Derivatives of the velocity: [..., component, axis]."""
    a = SWING * np.sin(OMEGA * time)
    f, slope, bend = a * x**2 + (1 - 2 * a) * x, 2 * a * x + 1 - 2 * a, 2 * a
    sin_f, cos_f, sin_y, cos_y = np.sin(np.pi * f), np.cos(np.pi * f), np.sin(np.pi * y), np.cos(np.pi * y)
    factor = np.pi * AMPLITUDE
    return factor * np.stack([np.stack([-np.pi * slope * cos_f * cos_y, np.pi * sin_f * sin_y], axis=-1),
                              np.stack([(bend * cos_f - np.pi * slope**2 * sin_f) * sin_y, np.pi * cos_f * cos_y * slope], axis=-1)], axis=-2)


def runge_kutta(rate, state, start, end, steps):
    h = (end - start) / steps
    for i in range(steps):
        t = start + i * h
        k1 = rate(state, t)
        k2 = rate(state + h / 2 * k1, t + h / 2)
        k3 = rate(state + h / 2 * k2, t + h / 2)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(state + h * k3, t + h))
    return state


def exponents_by_differences():
    """[y, x]"""
    x, y = np.meshgrid(*AXES)
    ends = runge_kutta(lambda p, t: velocity(p[..., 0], p[..., 1], t), np.stack([x, y], axis=-1), AGE, 0.0, 200)
    along = [np.gradient(ends, AXES[i], axis=1 - i) for i in (0, 1)]
    return np.log(np.linalg.svd(np.stack(along, axis=-1), compute_uv=False)[..., 0]) / AGE


def exponents_by_tangents(points):
    def rate(state, t):
        where, map_ = state[:, :2], state[:, 2:].reshape(-1, 2, 2)
        return np.concatenate([velocity(*where.T, t), (gradient(*where.T, t) @ map_).reshape(-1, 4)], axis=1)
    start = np.concatenate([points, np.tile(np.eye(2).ravel(), (len(points), 1))], axis=1)
    ends = runge_kutta(rate, start, AGE, 0.0, 800)
    return np.log(np.linalg.svd(ends[:, 2:].reshape(-1, 2, 2), compute_uv=False)[:, 0]) / AGE


class DoubleGyre(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        def wind(points, time):
            return np.column_stack([velocity(points[:, 0], points[:, 1], time), np.zeros(len(points))])
        source = TimeSeries(np.linspace(0, AGE, 201), wind, bounds=(0, 2, 0, 1, 0, 0.02), dimensions=SIZE)
        texture, cls.messages = update(advection(source, Period=2 * AGE, TimeStep=0.05, ComputeLyapunovExponent=True), AGE)
        layers = texture.point_array("FiniteTimeLyapunovExponent").reshape(SIZE[::-1])
        cls.layers, cls.found = layers, layers[1].astype(float)

    def test_layers_are_the_same(self):
        self.assertEqual(self.messages, [])
        self.assertLess(np.ptp(self.layers, axis=0).max(), 1e-5)

    def test_against_differences_of_exact_paths(self):
        inner = (slice(1, -1), slice(1, -1))
        expected = exponents_by_differences()[inner]
        difference = np.abs(self.found[inner] - expected)
        print(f"differences of exact paths: exponents {expected.min():.3f} to {expected.max():.3f}; off by {difference.mean():.2e} on average, "
              f"{np.quantile(difference, 0.99):.2e} at 99 %, {difference.max():.2e} at most")
        self.assertLess(difference.mean(), 5e-4)
        self.assertLess(np.quantile(difference, 0.99), 5e-3)

    def test_against_tangent_maps(self):
        rng = np.random.default_rng(1)
        i, j = rng.integers(5, SIZE[0] - 5, 400), rng.integers(5, SIZE[1] - 5, 400)
        expected = exponents_by_tangents(np.column_stack([AXES[0][i], AXES[1][j]]))
        resolved = expected < 0.3  # neighbours a cell of 0.01 apart come from within 0.2 of each other
        self.assertGreater(resolved.mean(), 0.7)
        difference = np.abs(self.found[j, i] - expected)[resolved]
        print(f"tangent maps: {resolved.mean():.0%} of the points; off by {np.median(difference):.2e} in the median, "
              f"{np.quantile(difference, 0.9):.2e} at 90 %")
        self.assertLess(np.median(difference), 1e-3)
        self.assertLess(np.quantile(difference, 0.9), 1e-2)


if __name__ == "__main__":
    unittest.main()
