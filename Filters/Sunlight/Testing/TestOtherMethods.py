#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods of other_methods.py, and the scattering of scaled_media.py: closed forms, exact solutions and Monte Carlo of one scattering. It needs numpy alone."""
import json
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import doubling  # noqa: E402
import monte_carlo  # noqa: E402
import other_methods  # noqa: E402
import scaled_media  # noqa: E402

LEVEL = monte_carlo.Cloud(np.full((33, 4), 8.0), 0.1, 0.25 / 32)  # optical depth 2


class TwoStream(unittest.TestCase):
    def test_by_hand(self):
        """g = 0.85, depth 10, no absorption, overhead sun: scaled depth 2.775, g' = 0.85 / 1.85, so (1.125 - (1 - exp(-2.775)) / 4) / 2.125."""
        self.assertAlmostEqual(float(other_methods.two_stream(10, 1, 1)), 0.41910, places=5)

    def test_exact(self):
        """Delta-Eddington agrees with doubling to 0.03."""
        for albedo in (1, 0.99):
            for depth in (2, 10, 18):
                for sun in (1, 0.5):
                    exact = doubling.reflected_fraction(depth, monte_carlo.ASYMMETRY, sun, albedo)
                    self.assertAlmostEqual(float(other_methods.two_stream(depth, sun, albedo)), exact, delta=0.03)

    def test_little_absorption(self):
        """Both closed forms meet, for thick clouds too."""
        depths = np.array((0.1, 2, 18, 1e4))
        np.testing.assert_allclose(other_methods.two_stream(depths, 0.5, 1 - 1e-9), other_methods.two_stream(depths, 0.5, 1), atol=3e-4)

    def test_columns(self):
        """Between levels the extinction is linear."""
        cloud = monte_carlo.Cloud(np.linspace(0, 16, 33)[:, None].repeat(4, 1), 0.1, 0.25 / 32)
        np.testing.assert_allclose(other_methods.independent_columns(cloud, (0, 0, 1), 1), other_methods.two_stream(2, 1, 1))


class Octaves(unittest.TestCase):
    def closed_form(self, sun, view, scale=1.0):
        """Single scattering of LEVEL, with the extinction and the asymmetry times `scale`."""
        g, cosine = scale * monte_carlo.ASYMMETRY, -np.dot(sun, view)
        phase = (1 - g * g) / (1 + g * g - 2 * g * cosine) ** 1.5
        return 0.9 * phase / (4 * (sun[2] + view[2])) * (1 - np.exp(-2 * scale * (1 / sun[2] + 1 / view[2])))

    def test_one_octave(self):
        for zenith in (0, 60):
            for view in ((0, 0, 1), monte_carlo.sun_of(50, 70)):
                sun = monte_carlo.sun_of(zenith, 180)
                np.testing.assert_allclose(other_methods.radiance(LEVEL, sun, 0.9, view, octaves=1), self.closed_form(sun, view), rtol=1e-4)

    def test_sum(self):
        """With a = b, octaves differ from single scattering by the scaled extinction and asymmetry alone."""
        sun, view = monte_carlo.sun_of(60, 180), (0, 0, 1)
        expected = sum(self.closed_form(sun, view, 0.5**i) for i in range(8))
        np.testing.assert_allclose(other_methods.radiance(LEVEL, sun, 0.9, view), expected, rtol=1e-4)

    def test_shadows_between_columns(self):
        """One octave above every column of the step cloud, against the Monte Carlo of one scattering. Its table is relative to a surface that faces the sun."""
        for case in ("step 0", "step 60"):
            name, zenith, azimuth, albedo = monte_carlo.CASES[case]
            sun, table = monte_carlo.sun_of(zenith, azimuth), json.loads(monte_carlo.TABLE.read_text())[case + " once"]
            found = sun[2] * other_methods.radiance(monte_carlo.CLOUDS[name], sun, albedo, (0, 0, 1), octaves=1)
            np.testing.assert_allclose(found, table["reflectance"], rtol=0.01)

    def test_flux(self):
        """One octave of a thin cloud sends up what the phase function sends backwards."""
        thin, cosines, g = monte_carlo.Cloud(np.full((33, 4), 4e-4), 0.1, 0.25 / 32), (np.arange(1000) + 0.5) / 1000, monte_carlo.ASYMMETRY
        backward = ((1 - g * g) / (1 + g * g + 2 * g * cosines) ** 1.5).mean() / 2
        np.testing.assert_allclose(other_methods.flux_of_octaves(thin, np.array((0, 0, 1)), 1, octaves=1), 1e-4 * backward, rtol=0.002)

    def test_sun_only(self):
        """With the whole extinction towards the eye, octaves are darker; one octave is the same."""
        sun, view = monte_carlo.sun_of(60, 180), (0, 0, 1)
        one, same = (other_methods.radiance(LEVEL, sun, 1, view, octaves=1, sun_only=only) for only in (False, True))
        np.testing.assert_array_equal(one, same)
        self.assertTrue((other_methods.nadir_of_sun_only(LEVEL, sun, 1) < other_methods.nadir_of_octaves(LEVEL, sun, 1)).all())


class ScaledMedia(unittest.TestCase):
    def test_scattering(self):
        """The first two Legendre coefficients of the angles of scattering are those of the phase function; unit directions stay so."""
        self.addCleanup(setattr, monte_carlo, "scattered", monte_carlo.scattered)
        before = np.array((0.6, 0, -0.8))[:, None].repeat(400000, 1)
        for name, (f, phase) in scaled_media.MEDIA.items():
            with self.subTest(name):
                scaled_media.use_phase(phase)
                after = monte_carlo.scattered(before, np.random.default_rng(3))
                np.testing.assert_allclose((after**2).sum(0), 1, atol=1e-9)
                cosine = (before * after).sum(0)
                for found, legendre in ((cosine.mean(), scaled_media.COSINES), (1.5 * (cosine**2).mean() - 0.5, 1.5 * scaled_media.COSINES**2 - 0.5)):
                    self.assertAlmostEqual(found, np.average(legendre, weights=phase), delta=0.004)
        self.assertAlmostEqual(np.average(scaled_media.COSINES, weights=scaled_media.henyey_greenstein(0.6)), 0.6, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
