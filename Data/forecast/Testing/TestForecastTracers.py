# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the wind carries: a hill over both poles against its exact turn, bounds, the distribution of areas."""
import unittest

import forecast_modules  # noqa: F401
import numpy as np
from forecast import sphere, tracers

RATE = 2.0 * np.pi / (12 * 86400.0)  # radians per second: a turn in 12 days


def grid(carrier):
    lon = 2.0 * np.pi * np.arange(carrier.longitudes) / carrier.longitudes
    return [a[..., None] for a in np.meshgrid(lon, carrier.latitudes, indexing="ij")]


def over_the_poles(lon, lat):
    """Wind of a rotation about the x axis, m/s."""
    speed = RATE * sphere.EARTH_RADIUS
    return -speed * np.sin(lat) * np.cos(lon), speed * np.sin(lon) + 0 * lat


def hill(carrier, angle, radius=0.6):
    """A cosine bell that began at 90 E on the equator, turned about the x axis."""
    centre = np.array([0.0, np.cos(angle), np.sin(angle)])
    distance = np.arccos(np.clip((carrier.points[..., 0] * centre[:, None, None]).sum(axis=0), -1.0, 1.0))
    return np.where(distance < radius, 0.5 * (1.0 + np.cos(np.pi * distance / radius)), 0.0)[..., None]


def even(longitudes, rows):
    return tracers.Carrier(np.linspace(-np.pi / 2, np.pi / 2, rows), longitudes)


class Tracers(unittest.TestCase):
    def turn(self, carrier, hours=144):
        """Half a turn, over the north pole, in steps of an hour: (made, exact)."""
        lon, lat = grid(carrier)
        field, wind = hill(carrier, 0.0), over_the_poles(lon, lat)
        for _ in range(hours):
            field, = carrier.carry([field], *wind, 3600.0)
            self.assertGreaterEqual(field.min(), 0.0)
            self.assertLessEqual(field.max(), 1.0)
        return field, hill(carrier, RATE * hours * 3600.0)

    def test_over_the_pole(self):
        errors = []
        for carrier in (even(72, 37), even(144, 73)):
            made, exact = self.turn(carrier)
            weight = sphere.area_weights(carrier.latitudes)[None, :, None]
            errors.append(np.sqrt((weight * (made - exact) ** 2).mean() / (weight * exact**2).mean()))
        print("hill over the pole, half a turn: relative rms error %.4f at 5 degrees, %.4f at 2.5" % tuple(errors))
        self.assertLess(errors[1], 0.06)
        self.assertGreater(errors[0] / errors[1], 3.0)

    def test_gaussian_rows(self):
        carrier = tracers.Carrier(sphere.gaussian_latitudes(72)[0], 144)
        made, exact = self.turn(carrier)
        self.assertLess(abs(made - exact).max(), 0.08)

    def test_departures_are_exact_for_a_rotation(self):
        carrier = even(144, 73)
        departures = carrier.departures(*over_the_poles(*grid(carrier)), 3600.0)[..., 0]
        c, s = np.cos(RATE * 3600.0), np.sin(RATE * 3600.0)
        x, y, z = carrier.points[..., 0]
        exact = np.stack((x, c * y + s * z, c * z - s * y))
        self.assertLess(abs(departures - exact).max(), 1e-5)  # 64 m

    def test_a_constant_stays(self):
        carrier = even(36, 19)
        field, = carrier.carry([np.full((36, 19, 1), 0.3)], *over_the_poles(*grid(carrier)), 3600.0)
        np.testing.assert_allclose(field, 0.3, rtol=1e-14)

    def test_levels_are_apart(self):
        carrier = even(36, 19)
        wind = over_the_poles(*grid(carrier))
        both = np.concatenate((hill(carrier, 0.0), hill(carrier, 1.0)), axis=2)
        winds = [np.concatenate((w, 0 * w), axis=2) for w in wind]
        made, = carrier.carry([both], *winds, 3600.0)
        alone, = carrier.carry([both[..., :1]], *wind, 3600.0)
        np.testing.assert_array_equal(made[..., :1], alone)
        np.testing.assert_allclose(made[..., 1], both[..., 1], atol=1e-12)


class Distribution(unittest.TestCase):
    def setUp(self):
        self.carrier = even(144, 73)
        lon, lat = grid(self.carrier)
        self.field = np.maximum(0.0, np.cos(lat) * np.sin(3 * lon) * np.cos(4 * lat) - 0.2)
        self.distribution = tracers.AreaDistribution(self.field, self.carrier.latitudes)
        self.areas = sphere.area_weights(self.carrier.latitudes)[None, :, None] / 2.0

    def mean(self, field):
        return (field * self.areas).sum(axis=(0, 1))[0] / self.field.shape[0]

    def test_itself_stays(self):
        np.testing.assert_allclose(self.distribution.restore(self.field), self.field, atol=1e-12)

    def test_restored(self):
        smooth = self.field.copy()
        for _ in range(60):
            smooth = 0.5 * smooth + 0.25 * (np.roll(smooth, 1, 0) + np.roll(smooth, -1, 0))
        self.assertLess(smooth.max(), 0.8 * self.field.max())
        made = self.distribution.restore(smooth)
        self.assertAlmostEqual(made.max(), self.field.max(), 2)
        self.assertEqual(made.min(), 0.0)
        self.assertAlmostEqual(self.mean(made) / self.mean(self.field), 1.0, 3)
        for value in (0.05, 0.15, 0.5):
            self.assertAlmostEqual(self.mean(made > value), self.mean(self.field > value), 2)
        order = np.argsort(smooth.ravel(), kind="stable")
        inner = order[(order % 73 > 0) & (order % 73 < 72)]  # a row at a pole is one point
        self.assertTrue((np.diff(made.ravel()[inner]) >= -1e-15).all())

    def test_carried_and_restored_keeps_the_mean(self):
        field, wind = self.field, over_the_poles(*grid(self.carrier))
        for _ in range(48):
            field, = self.carrier.carry([field], *wind, 3600.0)
            field = self.distribution.restore(field)
        self.assertLess(abs(self.mean(field) / self.mean(self.field) - 1.0), 1e-3)


if __name__ == "__main__":
    unittest.main()
