# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Seams, poles, missing data, and rows near a pole that are smoothed more often."""
import unittest

import cloud_grids as cg
import numpy as np
from nephoscope_testing.weather import forecast_globe


class Seams(unittest.TestCase):
    def setUp(self):
        self.positions = cg.globe_positions()
        self.field = np.random.default_rng(1).normal(size=(4, 13, 24))
        self.data = cg.structured(self.positions, {"f": cg.closed(self.field)})

    def test_a_repeated_column_is_found(self):
        out = cg.cube(cg.smooth(self.data, 2))
        np.testing.assert_array_equal(out[:, :, 0], out[:, :, -1])
        open_ring = cg.structured(cg.globe_positions(repeat=False), {"f": self.field})
        np.testing.assert_array_equal(out[:, :, :-1], cg.cube(cg.smooth(open_ring, 2, Periodic=0)))
        unaware = cg.cube(cg.smooth(self.data, 2, FindSeam=False))
        self.assertGreater(np.abs(unaware[:, 1:-1, 0] - unaware[:, 1:-1, -1]).max(), 0.01)

    def test_it_does_not_matter_where_the_seam_is(self):
        out = cg.cube(cg.smooth(self.data, 3, Conservative=True))[:, :, :-1]
        turned = np.roll(self.positions[:, :, :-1], 7, 2)
        turned = cg.structured(np.concatenate([turned, turned[:, :, :1]], 2), {"f": cg.closed(np.roll(self.field, 7, 2))})
        turned = cg.cube(cg.smooth(turned, 3, Conservative=True))[:, :, :-1]
        np.testing.assert_allclose(turned, np.roll(out, 7, 2), atol=1e-14)

    def test_a_repeated_column_of_values_on_a_map(self):
        x = np.arange(25.0)
        data = cg.rectilinear(x, np.arange(13), np.arange(4), {"f": cg.closed(self.field)})
        out = cg.cube(cg.smooth(data, 2, Periodic=0))
        np.testing.assert_array_equal(out[:, :, 0], out[:, :, -1])
        ring = cg.rectilinear(x[:-1], np.arange(13), np.arange(4), {"f": self.field})
        np.testing.assert_array_equal(out[:, :, :-1], cg.cube(cg.smooth(ring, 2, Periodic=0)))

    def test_longitudes_from_0_to_360(self):
        lat = np.linspace(-80, 80, 13)
        data = cg.rectilinear(np.arange(25) * 15, lat, np.arange(4), {"f": cg.closed(self.field)})
        ring = cg.rectilinear(np.arange(24) * 15, lat, np.arange(4), {"f": self.field})
        out = cg.smooth(data, 2, Coordinates=2, Conservative=True, GenerateMassArray=True)
        expected = cg.smooth(ring, 2, Coordinates=2, Conservative=True, GenerateMassArray=True)
        np.testing.assert_allclose(cg.cube(out)[:, :, :-1], cg.cube(expected), atol=1e-14)
        np.testing.assert_allclose(cg.cube(out, "Mass")[:, :, :-1], cg.cube(expected, "Mass"), rtol=1e-12)
        self.assertTrue((cg.cube(out, "Mass")[:, :, -1] == 0).all())
        regional = cg.rectilinear(np.arange(24) * 5, lat, np.arange(4), {"f": self.field})
        np.testing.assert_array_equal(cg.cube(cg.smooth(regional, Coordinates=2)), cg.cube(cg.smooth(regional)))

    def test_the_globe_of_the_forecast(self):
        globe = forecast_globe()
        globe.GetPointData().SetActiveScalars("cloud_fraction")
        out = cg.smooth(globe, 3)
        field = cg.cube(out, "cloud_fraction")
        np.testing.assert_array_equal(field[:, :, 0], field[:, :, -1])
        hidden = cg.cube(out, "vtkGhostType") != 0
        for j in (0, -1):
            rows = np.where(hidden[:, j], np.nan, field[:, j])
            rows = rows[np.isfinite(rows).all(axis=1)]
            self.assertTrue(len(rows) > 10 and (rows == rows[:, :1]).all())
        np.testing.assert_array_equal(field[hidden], cg.cube(globe, "cloud_fraction")[hidden])
        self.assertTrue((field >= 0).all() and (field <= 1).all())


class Poles(unittest.TestCase):
    def test_a_row_at_a_pole_takes_its_mean(self):
        field = np.random.default_rng(2).normal(size=(4, 13, 24))
        grids = {"globe": (cg.structured(cg.globe_positions(), {"f": cg.closed(field)}), {}),
                 "degrees": (cg.rectilinear(np.arange(24) * 15, np.linspace(90, -90, 13), np.arange(4), {"f": field}), {"Periodic": 0})}
        for name, (data, settings) in grids.items():
            out = cg.cube(cg.smooth(data, **settings))[:, :, :24]
            for j, next_to in ((0, 1), (-1, -2)):
                self.assertTrue((out[:, j] == out[:, j, :1]).all(), name)
                # Weights 3 : 1 of the pole's mean and the next row's, along the meridians, then 1 2 1 in the levels.
                line = 0.75 * field[:, j].mean(-1) + 0.25 * field[:, next_to].mean(-1)
                padded = np.pad(line, 1, mode="edge")
                np.testing.assert_allclose(out[:, j, 0], (padded[:-2] + 2 * line + padded[2:]) / 4, atol=1e-14, err_msg=name)

    def test_a_hemisphere_has_one_pole(self):
        field = np.random.default_rng(2).normal(size=(2, 7, 24))
        out = cg.cube(cg.smooth(cg.rectilinear(np.arange(24) * 15, np.linspace(0, 90, 7), [0, 1], {"f": field}), Periodic=0))
        self.assertTrue((out[:, -1] == out[:, -1, :1]).all())
        self.assertGreater(np.ptp(out[:, 0], axis=1).min(), 0.1)

    def test_a_sector_with_the_pole(self):
        """Not all longitudes: the row at the pole is one point all the same."""
        positions = cg.globe_positions()[:, :, :9]
        field = np.random.default_rng(3).normal(size=positions.shape[:3])
        out = cg.cube(cg.smooth(cg.structured(positions, {"f": field})))
        self.assertTrue((out[:, 0] == out[:, 0, :1]).all())

    def test_a_constant_stays_at_the_pole(self):
        data = cg.structured(cg.globe_positions(), {"f": np.full((4, 13, 25), 0.1)})
        for settings in ({}, {"Conservative": True}, {"Isotropic": True, "Conservative": True}):
            self.assertTrue((cg.values(cg.smooth(data, 3, **settings)) == 0.1).all(), settings)


class Missing(unittest.TestCase):
    def setUp(self):
        self.field = np.random.default_rng(4).normal(size=(5, 6, 7))
        self.gaps = np.random.default_rng(5).random(self.field.shape) < 0.2

    def expected(self):
        """Pass by pass, in numpy: exchange between points that are there."""
        f, m = np.where(self.gaps, 0, self.field), (~self.gaps).astype(float)
        for axis in (2, 1, 0):
            new = f.copy()
            for step in (-1, 1):
                neighbor, there = np.roll(f, step, axis), np.roll(m, step, axis)
                edge = [slice(None)] * 3
                edge[axis] = 0 if step == 1 else -1
                there[tuple(edge)] = 0
                new += 0.25 * there * m * (neighbor - f)
            f = new
        return f

    def check(self, data, expect=()):
        out = cg.cube(cg.smooth(data, expect=expect))
        np.testing.assert_allclose(out[~self.gaps], self.expected()[~self.gaps], atol=1e-15)
        return out

    def test_not_a_number(self):
        for value in (np.nan, np.inf, 9.97e36):
            field = np.where(self.gaps, value, self.field)
            out = self.check(cg.image(field), [f"{self.gaps.sum()} values of the array 'f' are not finite"])
            np.testing.assert_array_equal(out[self.gaps], field[self.gaps])

    def test_hidden_points(self):
        data = cg.image(np.where(self.gaps, 1e6, self.field))
        ghosts = cg.array("vtkGhostType", np.where(self.gaps, cg.HIDDEN_POINT, 0).astype(np.uint8).ravel())
        data.GetPointData().AddArray(ghosts)
        self.assertTrue((self.check(data)[self.gaps] == 1e6).all())

    def test_what_is_missing_conserves_the_rest(self):
        axes = [np.cumsum(np.random.default_rng(6).uniform(0.5, 2, n)) for n in (7, 6, 5)]
        data = cg.rectilinear(*axes, {"f": np.where(self.gaps, np.nan, self.field)})
        out = cg.smooth(data, 5, Conservative=True, GenerateMassArray=True, expect=["not finite"])
        mass = np.where(self.gaps, 0, cg.cube(out, "Mass"))
        before, after = (np.sum(mass * np.where(self.gaps, 0, f)) for f in (self.field, cg.cube(out)))
        self.assertAlmostEqual(before, after, places=11)

    def test_nothing_there(self):
        self.assertTrue(np.isnan(cg.values(cg.smooth(cg.image(np.full((3, 3, 3), np.nan)), expect=["27 values"]))).all())


class Isotropic(unittest.TestCase):
    def spread(self, latitude, **settings):
        """Standard deviations in degrees of arc, east and north, of a point after smoothing at that latitude."""
        lon, lat = np.arange(180) * 2.0, np.arange(-89, 90, 2.0)
        field = np.zeros((1, 90, 180))
        j = np.abs(lat - latitude).argmin()
        field[0, j, 90] = 1
        out = cg.cube(cg.smooth(cg.rectilinear(lon, lat, [0], {"f": field}), Periodic=0, **settings))[0]
        east = (np.arange(180) - 90) * 2 * np.cos(np.radians(lat[j]))
        north = (np.arange(90) - j) * 2.0
        return np.sqrt(np.sum(out[j] / out[j].sum() * east ** 2)), np.sqrt(np.sum(out.sum(1) / out.sum() * north ** 2))

    def test_the_same_reach_in_both_directions(self):
        for latitude in (1, 31, 61, 75):
            east, north = self.spread(latitude, Isotropic=True)
            self.assertAlmostEqual(east / north, 1, delta=1e-6)
        east, north = self.spread(75)
        self.assertAlmostEqual(east / north, np.cos(np.radians(75)), delta=1e-6)

    def test_on_the_globe(self):
        """The same filter in positions as in degrees, but for chords in place of arcs."""
        lon, lat = np.arange(72) * 5.0, np.linspace(-90, 90, 37)
        field = np.random.default_rng(7).normal(size=(1, 37, 72))
        flat = cg.cube(cg.smooth(cg.rectilinear(lon, lat, [0], {"f": field}), Periodic=0, Isotropic=True))
        data = cg.structured(cg.globe_positions(72, 37, (1.0,)), {"f": cg.closed(field)})
        out = cg.cube(cg.smooth(data, Isotropic=True))[:, :, :-1]
        np.testing.assert_allclose(out, flat, atol=2e-3)

    def test_bounds_and_sums(self):
        field = np.random.default_rng(8).random((4, 13, 24))
        data = cg.structured(cg.globe_positions(), {"f": cg.closed(field)})
        out = cg.smooth(data, 2, Isotropic=True, Conservative=True, GenerateMassArray=True)
        mass = cg.cube(out, "Mass")
        self.assertAlmostEqual(np.sum(mass * cg.cube(out)) / np.sum(mass * cg.cube(data)), 1, places=13)
        self.assertLessEqual(cg.cube(out).max(), field.max())
        self.assertGreaterEqual(cg.cube(out).min(), field.min())


if __name__ == "__main__":
    unittest.main()
