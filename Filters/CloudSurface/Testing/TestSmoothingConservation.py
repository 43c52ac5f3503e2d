# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conservative smoothing on uneven grids: sum of mass times field, the range, constants; and the masses themselves."""
import unittest

import cloud_grids as cg
import numpy as np

LATITUDES = np.linspace(-90, 90, 37)
# Rows half a step from the poles, as on a Gaussian grid, and uneven.
INNER = np.degrees(np.arcsin(np.polynomial.legendre.leggauss(32)[0]))
LEVELS = np.array([1000.0, 975, 950, 900, 850, 700, 500, 300, 200, 100])  # hPa, uneven
LONGITUDES = np.arange(36) * 10.0


def air_masses(longitudes, latitudes, levels):
    """Mass per point from the definition, [k, j, i]: longitude step, difference of sin at the edges, level step."""
    edges = np.concatenate([[-90], (latitudes[1:] + latitudes[:-1]) / 2, [90]])
    rows = np.diff(np.sin(np.radians(edges)))
    layers = np.abs(np.gradient(np.arange(len(levels)) * 0.0 + levels, edge_order=1))
    layers[[0, -1]] /= 2
    columns = np.full(len(longitudes), 2 * np.pi / len(longitudes))
    return layers[:, None, None] * rows[:, None] * columns


def total(field, mass):
    return np.sum(field.astype(np.longdouble) * mass)


class LongitudeLatitude(unittest.TestCase):
    def check(self, field, latitudes, mass):
        data = cg.rectilinear(LONGITUDES, latitudes, LEVELS, {"f": field})
        out = cg.smooth(data, 4, Periodic=0, Conservative=True, GenerateMassArray=True)
        after = cg.cube(out)
        np.testing.assert_allclose(cg.cube(out, "Mass"), mass, rtol=1e-12)
        scale = total(np.abs(field), mass)
        self.assertLess(abs(total(after, mass) - total(field, mass)) / scale, 1e-14)
        self.assertLessEqual(after.max(), field.max())
        self.assertGreaterEqual(after.min(), field.min())
        return after

    def test_sum_stays_with_rows_on_the_poles(self):
        rng = np.random.default_rng(1)
        field = rng.normal(size=(10, 37, 36)) + 3
        self.check(field, LATITUDES, air_masses(LONGITUDES, LATITUDES, LEVELS))

    def test_sum_stays_with_rows_beside_the_poles(self):
        field = np.random.default_rng(2).random((10, 32, 36))
        self.check(field, INNER, air_masses(LONGITUDES, INNER, LEVELS))

    def test_a_smooth_field(self):
        """sin^2(latitude): plain smoothing loses 1e-3 of its sum, so the test can tell."""
        field = np.broadcast_to(np.sin(np.radians(INNER))[:, None] ** 2, (10, 32, 36)).copy()
        mass = air_masses(LONGITUDES, INNER, LEVELS)
        self.check(field, INNER, mass)
        plain = cg.cube(cg.smooth(cg.rectilinear(LONGITUDES, INNER, LEVELS, {"f": field}), 4, Periodic=0))
        self.assertGreater(abs(total(plain, mass) / total(field, mass) - 1), 1e-3)

    def test_cosine_of_longitude(self):
        wave = np.broadcast_to(np.cos(np.radians(LONGITUDES)), (10, 32, 36)).copy()
        out = cg.cube(cg.smooth(cg.rectilinear(LONGITUDES, INNER, LEVELS, {"f": wave}), Periodic=0, Conservative=True))
        np.testing.assert_allclose(out, np.cos(np.pi / 36) ** 2 * wave, atol=1e-15)

    def test_constant(self):
        data = cg.rectilinear(LONGITUDES, LATITUDES, LEVELS, {"f": np.full((10, 37, 36), 0.1)})
        self.assertTrue((cg.values(cg.smooth(data, 7, Periodic=0, Conservative=True)) == 0.1).all())

    def test_falling_axes_are_the_same(self):
        field = np.random.default_rng(3).random((10, 37, 36))
        options = {"Periodic": 0, "Conservative": True}
        out = cg.cube(cg.smooth(cg.rectilinear(LONGITUDES, LATITUDES, LEVELS, {"f": field}), 2, **options))
        turned = cg.rectilinear(LONGITUDES, LATITUDES[::-1], -LEVELS, {"f": field[:, ::-1]})
        np.testing.assert_allclose(cg.cube(cg.smooth(turned, 2, **options))[:, ::-1], out, atol=1e-14)

    def test_coordinates_can_be_said(self):
        field = np.random.default_rng(4).random((10, 37, 36))
        data = cg.rectilinear(LONGITUDES, LATITUDES, LEVELS, {"f": field})
        automatic = cg.values(cg.smooth(data, Periodic=0, Conservative=True))
        np.testing.assert_array_equal(cg.values(cg.smooth(data, Conservative=True, Coordinates=2)), automatic)
        self.assertFalse(np.array_equal(cg.values(cg.smooth(data, Periodic=0, Conservative=True, Coordinates=1)), automatic))


class Cartesian(unittest.TestCase):
    def setUp(self):
        rng = np.random.default_rng(5)
        self.axes = [np.cumsum(rng.uniform(0.2, 3, n)) for n in (9, 8, 7)]
        self.field = rng.normal(size=(7, 8, 9))

    def check(self, data, volume, **settings):
        out = cg.smooth(data, 3, Conservative=True, GenerateMassArray=True, **settings)
        mass = cg.cube(out, "Mass")
        self.assertAlmostEqual(mass.sum() / volume, 1, places=12)
        scale = np.sum(mass * np.abs(cg.cube(data)))
        self.assertLess(abs(total(cg.cube(out), mass) - total(cg.cube(data), mass)) / scale, 1e-15 * mass.size)
        self.assertLessEqual(cg.cube(out).max(), cg.cube(data).max())
        return out

    def test_rectilinear(self):
        self.check(cg.rectilinear(*self.axes, {"f": self.field}), np.prod([a[-1] - a[0] for a in self.axes]))

    def test_curvilinear_agrees_with_rectilinear(self):
        grid = np.stack(np.meshgrid(*self.axes, indexing="ij"), -1).transpose(2, 1, 0, 3)
        volume = np.prod([a[-1] - a[0] for a in self.axes])
        out = self.check(cg.structured(grid, {"f": self.field}), volume)
        expected = self.check(cg.rectilinear(*self.axes, {"f": self.field}), volume)
        np.testing.assert_allclose(cg.cube(out, "Mass"), cg.cube(expected, "Mass"), rtol=1e-12)
        np.testing.assert_allclose(cg.cube(out), cg.cube(expected), atol=1e-13)
        mirrored = self.check(cg.structured(grid * [-1, 1, 1], {"f": self.field}), volume)
        np.testing.assert_allclose(cg.cube(mirrored), cg.cube(expected), atol=1e-13)

    def test_globe(self):
        """A shell between radii 1 and 1.3: polyhedra inside it, so the volume converges from below as h^2."""
        errors = []
        for n in (1, 2):
            positions = cg.globe_positions(24 * n, 12 * n + 1)
            field = cg.closed(np.random.default_rng(6).random(positions.shape[:2] + (24 * n,)))
            data = cg.structured(positions, {"f": field})
            out = cg.smooth(data, 2, Conservative=True, GenerateMassArray=True)
            mass = cg.cube(out, "Mass")
            # Noise at a pole is replaced by its mean, weighted: that too conserves.
            self.assertLess(abs(total(cg.cube(out), mass) / total(field, mass) - 1), 1e-14)
            errors.append(1 - mass.sum() / (4 / 3 * np.pi * (1.3 ** 3 - 1)))
        self.assertGreater(errors[1], 0)
        self.assertAlmostEqual(errors[0] / errors[1], 4, delta=0.1)

    def test_images_have_equal_masses_inside(self):
        out = cg.smooth(cg.image(self.field), Conservative=True)
        plain = cg.smooth(cg.image(self.field))
        inner = (slice(2, -2),) * 3
        np.testing.assert_allclose(cg.cube(out)[inner], cg.cube(plain)[inner], atol=1e-15)

    def test_flat_grids(self):
        x, y, _ = self.axes
        grid = np.stack(np.meshgrid(x, y, [0.0], indexing="ij"), -1).transpose(2, 1, 0, 3)
        field = self.field[:1]
        area = (x[-1] - x[0]) * (y[-1] - y[0])
        flat = self.check(cg.rectilinear(x, y, [0], {"f": field}), area)
        np.testing.assert_allclose(cg.cube(self.check(cg.structured(grid, {"f": field}), area)), cg.cube(flat), atol=1e-13)
        line = np.stack([x, 0 * x, 0 * x], -1)[None, None]
        self.check(cg.structured(line, {"f": field[:, :1]}), x[-1] - x[0])

    def test_given_masses(self):
        mass = np.random.default_rng(8).uniform(0.1, 5, self.field.shape)
        data = cg.image(self.field)
        cg.add(data, {"weight": mass})
        data.GetPointData().SetActiveScalars("f")
        out = cg.cube(cg.smooth(data, 3, Conservative=True, MassArrayName="weight"))
        self.assertLess(abs(total(out, mass) - total(self.field, mass)), 1e-11)

    def test_given_masses_count_a_place_once(self):
        positions = cg.globe_positions()
        mass = np.random.default_rng(9).uniform(0.1, 5, positions.shape[:3])
        data = cg.structured(positions, {"f": cg.closed(np.random.default_rng(10).random((4, 13, 24))), "weight": mass})
        out = cg.smooth(data, 2, Conservative=True, MassArrayName="weight", GenerateMassArray=True)
        written = cg.cube(out, "Mass")
        np.testing.assert_array_equal(written[:, :, :-1], mass[:, :, :-1])
        self.assertTrue((written[:, :, -1] == 0).all())
        self.assertAlmostEqual(total(cg.cube(out), written) / total(cg.cube(data), written), 1, places=14)

    def test_single_precision_loses_its_own_rounding_only(self):
        data = cg.rectilinear(*self.axes, {"f": (self.field + 5).astype("f4")})
        out = cg.smooth(data, 3, Conservative=True, GenerateMassArray=True)
        mass = cg.cube(out, "Mass")
        self.assertLess(abs(total(cg.cube(out), mass) / total(cg.cube(data), mass) - 1), 6e-8)


if __name__ == "__main__":
    unittest.main()
