# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The barotropic vorticity equation against its known solutions and invariants."""
import os
import unittest

import forecast_modules
import numpy as np
from forecast import barotropic, gfs, model, sphere

RADIUS, ROTATION = sphere.EARTH_RADIUS, sphere.EARTH_ROTATION
HOUR = 3600.0


def rossby_haurwitz(lon, lat, wave=4, rate=7.848e-6, strength=7.848e-6):
    """(vorticity, angular speed of the pattern) of test case 6 of Williamson et al. (1992), an exact solution."""
    cosine = np.cos(lat)
    vorticity = 2.0 * rate * np.sin(lat) - strength * (wave**2 + 3 * wave + 2) * cosine**wave * np.sin(lat) * np.cos(wave * lon)
    speed = (wave * (3 + wave) * rate - 2.0 * ROTATION) / ((1 + wave) * (2 + wave))
    return vorticity, speed


def run(equation, vorticity, hours, seconds=1800.0, divergence=None):
    divergence = np.zeros_like(vorticity) if divergence is None else divergence
    equation.start(vorticity)
    for _ in range(round(hours * HOUR / seconds)):
        vorticity, divergence = equation.step(vorticity, divergence, seconds)
    return vorticity, divergence


class KnownSolutions(unittest.TestCase):
    def setUp(self):
        self.harmonics = barotropic.transform_grid(21)
        lon = 2.0 * np.pi * np.arange(self.harmonics.longitudes) / self.harmonics.longitudes
        self.lon, self.lat = (a[..., None] for a in np.meshgrid(lon, self.harmonics.latitudes, indexing="ij"))

    def test_rossby_haurwitz_wave(self):
        equation = barotropic.Barotropic(self.harmonics, diffusion_hours=0.0)
        first, speed = rossby_haurwitz(self.lon, self.lat)
        made, _ = run(equation, self.harmonics.from_grid(first), 48)
        expected = rossby_haurwitz(self.lon - speed * 48 * HOUR, self.lat)[0]
        difference = abs(self.harmonics.to_grid(made) - expected).max() / abs(expected).max()
        angle = np.angle(made[4, 5, 0] / self.harmonics.from_grid(first)[4, 5, 0]) / -4.0
        print("Rossby-Haurwitz wave 4, 48 h: turned %.6f degrees, exact %.6f; largest difference %.1e of the vorticity" % (
            np.degrees(angle), np.degrees(speed * 48 * HOUR), difference))
        self.assertGreater(abs(np.degrees(speed * 48 * HOUR)), 20.0)
        self.assertLess(difference, 1e-6)

    def test_rotation_about_the_axis_is_steady(self):
        equation = barotropic.Barotropic(self.harmonics, diffusion_hours=0.0)
        first = self.harmonics.from_grid(2.0 * 1e-5 * np.sin(self.lat) + 0 * self.lon)
        made, _ = run(equation, first, 48)
        self.assertLess(abs(made - first).max() / abs(first).max(), 1e-12)

    def test_rotation_over_the_poles_is_steady_on_a_planet_at_rest(self):
        equation = barotropic.Barotropic(self.harmonics, diffusion_hours=0.0, rotation=0.0)
        first = self.harmonics.from_grid(2.0 * 1e-5 * np.cos(self.lat) * np.cos(self.lon))
        made, _ = run(equation, first, 48)
        self.assertLess(abs(made - first).max() / abs(first).max(), 1e-12)

    def test_winds_are_those_of_the_rotation(self):
        equation = barotropic.Barotropic(self.harmonics)
        east, north = equation.rotational_wind(self.harmonics.from_grid(2.0 * 1e-5 * np.sin(self.lat) + 0 * self.lon))
        np.testing.assert_allclose(east, 1e-5 * RADIUS * np.cos(self.lat) + 0 * self.lon, rtol=1e-12)
        self.assertLess(abs(north).max(), 1e-9)

    def test_divergence_is_carried(self):
        """By a rotation about the axis, through a quarter of a turn."""
        equation = barotropic.Barotropic(self.harmonics, diffusion_hours=0.0)
        vorticity = self.harmonics.from_grid(2.0 * 1e-5 * np.sin(self.lat) + 0 * self.lon)
        pattern = self.harmonics.from_grid(1e-6 * np.cos(self.lat) ** 3 * np.cos(3 * self.lon))
        _, made = run(equation, vorticity, 0.5 * np.pi / 1e-5 / HOUR, 0.5 * np.pi / 1e-5 / 100, pattern)
        turned = self.harmonics.from_grid(1e-6 * np.cos(self.lat) ** 3 * np.cos(3 * (self.lon - 0.5 * np.pi)))
        self.assertLess(abs(made - turned).max() / abs(turned).max(), 1e-5)


class Weather(unittest.TestCase):
    """The analysis itself, at three levels."""

    @classmethod
    def setUpClass(cls):
        cls.analysis = gfs.Analysis(os.path.join(forecast_modules.DATA, "gfs_2p5deg_2011101100.nc"))
        cls.harmonics = barotropic.transform_grid(42)
        wind = model.wind_on(cls.harmonics, cls.analysis, [850, 500, 250])
        cls.vorticity, cls.divergence = barotropic.Barotropic(cls.harmonics).analyse(*wind)

    def drift(self, **settings):
        equation = barotropic.Barotropic(self.harmonics, **settings)
        made, _ = run(equation, self.vorticity, 48)
        return [measure(made) / measure(self.vorticity) - 1.0 for measure in (equation.kinetic_energy, equation.enstrophy)]

    def test_invariants(self):
        energy, enstrophy = self.drift(diffusion_hours=0.0)
        print("48 h without diffusion: energy", energy, "enstrophy", enstrophy)
        self.assertLess(abs(energy).max(), 1e-4)
        self.assertLess(abs(enstrophy).max(), 2e-3)
        energy, enstrophy = self.drift()
        print("48 h with diffusion: energy", energy, "enstrophy", enstrophy)
        self.assertTrue((energy < 0.0).all() and (enstrophy < energy).all())  # it takes, and from the highest degrees most

    def test_what_is_held_stays(self):
        """With all degrees held every state is steady."""
        equation = barotropic.Barotropic(self.harmonics, hold=42, diffusion_hours=0.0)
        made, _ = run(equation, self.vorticity, 6)
        self.assertLess(abs(made - self.vorticity).max() / abs(self.vorticity).max(), 1e-12)

    def test_first_wind(self):
        """All of the wind but what the truncation takes: less of it the higher the degree."""
        errors = []
        weight = np.cos(self.analysis.latitudes)[None, :, None]
        for truncation in (42, 85, 106):
            harmonics = barotropic.transform_grid(truncation)
            equation = barotropic.Barotropic(harmonics)
            state = equation.analyse(*model.wind_on(harmonics, self.analysis, [850, 500, 250]))
            output = sphere.Harmonics(truncation, self.analysis.latitudes, 288)
            made = [a + b for a, b in zip(equation.rotational_wind(state[0], output), equation.divergent_wind(state[1], output))]
            square = sum((m[::2] - self.analysis.on_levels(n, [850, 500, 250])) ** 2 for m, n in zip(made, "uv"))
            errors.append(np.sqrt((square * weight).mean() / weight.mean()))
        print("rms vector error of the first wind at T42, T85, T106: %.2f %.2f %.2f m/s" % tuple(errors))
        self.assertGreater(errors[0], errors[1])
        self.assertLess(errors[1], 0.95)
        self.assertLess(errors[2], 0.55)


if __name__ == "__main__":
    unittest.main()
