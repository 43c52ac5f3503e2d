# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spherical harmonics against closed forms: single harmonics, derivatives, vectors across a pole."""
import unittest

import forecast_modules  # noqa: F401
import numpy as np
from forecast import barotropic, sphere


def mesh(harmonics):
    lon = 2.0 * np.pi * np.arange(harmonics.longitudes) / harmonics.longitudes
    return [a[..., None] for a in np.meshgrid(lon, harmonics.latitudes, indexing="ij")]


class Sphere(unittest.TestCase):
    def setUp(self):
        self.harmonics = barotropic.transform_grid(21)
        self.lon, self.lat = mesh(self.harmonics)

    def test_single_harmonics(self):
        """sin(lat) = sqrt(2/3) P[0, 1]; cos(lat)^2 cos(2 lon) = 2 sqrt(4/15) Re(P[2, 2] exp(2 i lon)) / 2."""
        for field, m, n, value in ((np.sin(self.lat) + 0 * self.lon, 0, 1, np.sqrt(2 / 3)),
                                   (np.cos(self.lat) ** 2 * np.cos(2 * self.lon), 2, 2, 0.5 * np.sqrt(16 / 15))):
            coefficients = self.harmonics.from_grid(field)[..., 0]
            self.assertAlmostEqual(coefficients[m, n], value, 13)
            coefficients[m, n] = 0.0
            self.assertLess(abs(coefficients).max(), 1e-14)

    def test_there_and_back(self):
        random = np.random.default_rng(1)
        coefficients = random.normal(size=(22, 22, 3)) + 1j * random.normal(size=(22, 22, 3))
        coefficients *= np.tri(22).T[..., None]
        coefficients[0] = coefficients[0].real
        again = self.harmonics.from_grid(self.harmonics.to_grid(coefficients))
        self.assertLess(abs(again - coefficients).max(), 1e-12)

    def test_gradient_and_divergence(self):
        x = np.cos(self.lat) * np.cos(self.lon)
        field = x**3 + 2.0 * x * np.sin(self.lat)
        slope = 3.0 * x**2 + 2.0 * np.sin(self.lat)  # of x; then that of sin(lat)
        east = -slope * np.sin(self.lon)
        north = -slope * np.sin(self.lat) * np.cos(self.lon) + 2.0 * x * np.cos(self.lat)
        made = self.harmonics.gradient(self.harmonics.from_grid(field))
        np.testing.assert_allclose(made[0], east, atol=1e-12)
        np.testing.assert_allclose(made[1], north, atol=1e-12)
        laplacian = self.harmonics.to_grid(self.harmonics.divergence(east, north))
        # On the sphere: that of x^3 is 6 x - 12 x^3, that of x sin(lat), of degree 2, -6 times itself.
        np.testing.assert_allclose(laplacian, 6.0 * x - 12.0 * x**3 - 12.0 * x * np.sin(self.lat), atol=1e-11)

    def test_power(self):
        field = np.sin(self.lat) + np.cos(self.lat) ** 2 * np.cos(2 * self.lon)
        power = self.harmonics.power(self.harmonics.from_grid(field))[:, 0]
        self.assertAlmostEqual(power[1], 1 / 3, 13)
        self.assertAlmostEqual(power[2], 4 / 15, 13)
        self.assertAlmostEqual(power.sum(), 9 / 15, 13)

    def test_rotation_about_an_axis_in_the_equator(self):
        """A wind over both poles, known on even rows: on Gaussian rows, and as vorticity 2 x per second."""
        rows = np.linspace(-np.pi / 2, np.pi / 2, 37)
        lon, lat = (a[..., None] for a in np.meshgrid(self.lon[:, 0, 0], rows, indexing="ij"))
        wind = (-np.sin(lat) * np.cos(lon), np.sin(lon) + 0 * lat)
        east, north = (sphere.to_latitudes(w, rows, self.harmonics.latitudes, -1.0) for w in wind)
        np.testing.assert_allclose(east, -np.sin(self.lat) * np.cos(self.lon), atol=1e-12)
        vorticity = self.harmonics.to_grid(self.harmonics.curl(east, north))
        np.testing.assert_allclose(vorticity, 2.0 * np.cos(self.lat) * np.cos(self.lon), atol=1e-11)
        self.assertLess(abs(self.harmonics.divergence(east, north)).max(), 1e-12)

    def test_rows_at_the_poles(self):
        """The wind at a pole is one vector, in the directions of each meridian."""
        at_poles = sphere.Harmonics(21, np.array([-np.pi / 2, np.pi / 2]), 64)
        x = np.cos(self.lat) * np.cos(self.lon)
        east, north = at_poles.gradient(self.harmonics.from_grid(x))
        lon = mesh(at_poles)[0]
        np.testing.assert_allclose(east, -np.sin(lon), atol=1e-6)
        np.testing.assert_allclose(north, np.cos(lon) * np.array([1.0, -1.0])[None, :, None], atol=1e-6)

    def test_too_few_longitudes(self):
        with self.assertRaises(ValueError):
            sphere.Harmonics(21, self.harmonics.latitudes, 42)


if __name__ == "__main__":
    unittest.main()
