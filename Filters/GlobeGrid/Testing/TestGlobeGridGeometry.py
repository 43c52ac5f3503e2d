# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Positions, seam, order of the axes, regional and curvilinear grids."""
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

import globe_fields as gf

LATITUDES = np.array([-90.0, -71.0, -30.0, 0.0, 12.5, 60.0, 90.0])
LEVELS = [0.0, 1000.0, 7000.0]  # m


class Seam(unittest.TestCase):
    def check_closed(self, lon):
        for projection in (0, 1):
            out = gf.globe(gf.rectilinear(lon, LATITUDES, LEVELS), Projection=projection).GetOutput()
            self.assertEqual(gf.dimensions(out), (145, 7, 3))
            p = gf.cube(out, gf.points(out))
            if projection == 0:
                np.testing.assert_array_equal(p[:, :, 0], p[:, :, -1])
                steps = np.linalg.norm(np.diff(p[:, 3], axis=1), axis=2)  # equator
                np.testing.assert_allclose(steps, steps[0, 0] * np.ones_like(steps), rtol=2e-3)
                self.assertGreater(steps.min(), 1000.0)
            else:
                np.testing.assert_allclose(np.diff(p[0, 0, :, 0]), gf.RADIUS * np.radians(2.5), rtol=1e-9)
                self.assertAlmostEqual(np.ptp(p[..., 0]) / (2 * np.pi * gf.RADIUS), 1.0, 9)

    def test_global_grids_close_once(self):
        self.check_closed(np.arange(144) * 2.5)
        self.check_closed(np.arange(145) * 2.5)
        self.check_closed(np.arange(144) * 2.5 - 180.0)
        self.check_closed(np.arange(145) * 2.5 - 180.0)
        self.check_closed((np.arange(144) * 2.5)[::-1])
        self.check_closed(np.where(np.arange(144) * 2.5 > 180.0, np.arange(144) * 2.5 - 360.0, np.arange(144) * 2.5))

    def test_off_and_regional_stay_open(self):
        open_grid = gf.rectilinear(np.arange(144) * 2.5, LATITUDES, LEVELS)
        self.assertEqual(gf.dimensions(gf.globe(open_grid, CloseSeam=False).GetOutput()), (144, 7, 3))
        regional = gf.rectilinear(np.linspace(170.0, 200.0, 13), LATITUDES, LEVELS)
        self.assertEqual(gf.dimensions(gf.globe(regional).GetOutput()), (13, 7, 3))

    def test_central_meridian_rotates_the_columns(self):
        lon = np.arange(144) * 2.5
        x, _, _ = gf.mesh(lon, LATITUDES, LEVELS)
        for columns in (lon, np.append(lon, 360.0)):
            x, _, _ = gf.mesh(columns, LATITUDES, LEVELS)
            grid = gf.rectilinear(columns, LATITUDES, LEVELS, {"x": x})
            for meridian in (0.0, -100.0, 190.0):
                out = gf.globe(grid, Projection=1, UseCentralMeridian=True, CentralMeridian=meridian).GetOutput()
                self.assertEqual(gf.dimensions(out)[0], 145)
                degrees = np.degrees(gf.points(out)[:, 0] / gf.RADIUS)
                self.assertAlmostEqual(degrees.min(), meridian - 180.0, 6)
                self.assertAlmostEqual(degrees.max(), meridian + 180.0, 6)
                np.testing.assert_allclose(np.cos(np.radians(degrees - gf.values(out, "x"))), 1.0, atol=1e-12)
                self.assertTrue((np.diff(gf.cube(out, degrees), axis=2) > 0).all())


class Positions(unittest.TestCase):
    def test_globe_and_map(self):
        lon, lat = np.array([-30.0, 0.0, 17.0, 55.0]), LATITUDES
        x, y, z = gf.mesh(lon, lat, LEVELS)
        grid = gf.rectilinear(lon, lat, LEVELS)
        out = gf.globe(grid, VerticalExaggeration=30.0, PlanetRadius=1e6).GetOutput()
        up = gf.frame(x, y)[2]
        np.testing.assert_allclose(gf.points(out), up * (1e6 + 30.0 * z)[:, None], atol=1e-6)
        np.testing.assert_allclose(gf.values(out, "Height"), z)
        out = gf.globe(grid, VerticalExaggeration=30.0, Projection=1).GetOutput()
        flat = np.column_stack([gf.RADIUS * np.radians(x), gf.RADIUS * np.radians(y), 30.0 * z])
        np.testing.assert_allclose(gf.points(out), flat, atol=1e-6)

    def test_levels_of_pressure_in_every_guise(self):
        lon, lat = [0.0, 10.0, 20.0], [0.0, 10.0]
        table = [110.9, 5574.4, 11784.1]  # m at 1000, 500, 200 hPa: independent tables print 111, 5574, 11784
        for levels, units in (([1000, 500, 200], 0), ([-1000, -500, -200], 0), ([100000, 50000, 20000], 0),
                              ([200, 500, 1000], 0), ([1000, 500, 200], 1), ([100000, 50000, 20000], 2)):
            out = gf.globe(gf.rectilinear(lon, lat, levels), LevelUnits=units).GetOutput()
            np.testing.assert_allclose(np.unique(gf.values(out, "Height")), table, atol=0.6)
            self.assertTrue((gf.corner_determinants(out) > 0).all())
        out = gf.globe(gf.rectilinear(lon, lat, [0.5, 1, 2]), LevelUnits=4).GetOutput()
        np.testing.assert_allclose(np.unique(gf.values(out, "Height")), [500, 1000, 2000])

    def test_height_array_and_geopotential(self):
        lon, lat = [0.0, 10.0, 20.0], [0.0, 10.0]
        x, _, z = gf.mesh(lon, lat, gf.PRESSURES)
        heights = 16000.0 - 15.0 * z + x
        grid = gf.rectilinear(lon, lat, gf.PRESSURES, {"gh": heights})
        np.testing.assert_allclose(gf.values(gf.globe(grid).GetOutput(), "Height"), heights, rtol=1e-6)
        from vtkmodules.vtkCommonCore import vtkStringArray
        units = vtkStringArray()
        units.SetName("z_units")
        units.InsertNextValue("m**2 s**-2")
        grid = gf.rectilinear(lon, lat, gf.PRESSURES, {"z": 9.80665 * heights})
        grid.GetFieldData().AddArray(units)
        out = gf.globe(grid, HeightArrayName="z").GetOutput()
        np.testing.assert_allclose(gf.values(out, "Height"), heights, rtol=1e-6)

    def test_sigma_and_hybrid_levels(self):
        """Without heights: those over a ground at 1013.25 hPa, with a warning; with heights these, and air of their pressure."""
        lon, lat, levels = np.arange(8) * 45.0, np.linspace(-90, 90, 5), [-1.0, -0.5, -0.2233611]
        made = gf.globe(gf.rectilinear(lon, lat, levels), quiet=False)
        self.assertIn("sigma and hybrid", " ".join(made.messages))
        height = gf.cube(made.GetOutput(), gf.values(made.GetOutput(), "Height"))
        np.testing.assert_allclose(height[[0, 2], 2, 3], [0.0, 11000.0], atol=0.5)
        x, y, z = gf.mesh(lon, lat, levels)
        known = gf.rectilinear(lon, lat, levels, {"gh": 5000.0 * (1.0 + z) + 100.0 * np.cos(np.radians(x)) * np.cos(np.radians(y)), "u": 0 * x, "v": 0 * x,
                                                  "w": 0 * x - 1.0, "t": 0 * x + 280.0})
        made = gf.globe(known, quiet=False)
        self.assertEqual(made.messages, [])
        out = made.GetOutput()
        height, wind = gf.values(out, "Height"), gf.values(out, "Wind")
        self.assertAlmostEqual(height.max(), 5000.0 * (1 - 0.2233611) + 100.0, 1)
        pressure = 101325.0 * (1.0 - 0.0065 * height / 288.15) ** 5.25588  # standard atmosphere
        np.testing.assert_allclose(np.linalg.norm(wind, axis=1)[height > 0], (287.0529 * 280.0 / 9.80665 / pressure)[height > 0], rtol=2e-3)

    def test_single_level_image(self):
        image = vtkImageData()
        image.SetDimensions(144, 73, 1)
        image.SetSpacing(2.5, 2.5, 1.0)
        image.SetOrigin(0.0, -90.0, 0.0)
        out = gf.globe(image).GetOutput()
        self.assertEqual(gf.dimensions(out), (145, 73, 1))
        np.testing.assert_allclose(np.linalg.norm(gf.points(out), axis=1), gf.RADIUS)

    def test_curvilinear_across_the_dateline(self):
        """A rotated region whose longitudes jump from 180 to -180, as WRF writes them."""
        i, j, k = gf.mesh(np.arange(20), np.arange(12), np.arange(3))
        lon = 165.0 + 1.5 * i - 0.4 * j
        wrapped = np.where(lon > 180.0, lon - 360.0, lon)
        lat = -20.0 + 1.2 * j + 0.3 * i
        for projection in (0, 1):
            a, b = (gf.points(gf.globe(gf.structured(x, lat, 1000.0 * k, (20, 12, 3)), Projection=projection).GetOutput())
                    for x in (lon, wrapped))
            np.testing.assert_allclose(a, b, atol=1e-6)

    def test_polar_rows_are_points_and_the_rest_has_volume(self):
        out = gf.globe(gf.rectilinear(np.arange(36) * 10.0, LATITUDES, LEVELS)).GetOutput()
        p = gf.cube(out, gf.points(out))
        for j in (0, -1):
            self.assertEqual(np.ptp(p[:, j], axis=1).max(), 0.0)
        self.assertTrue((gf.corner_determinants(out)[:, 1:] > 0).all())


class Order(unittest.TestCase):
    def test_any_order_gives_the_same_grid(self):
        rng = np.random.default_rng(20111011)
        lon, lat = np.arange(24) * 15.0, LATITUDES
        reference = None
        for flips in range(8):
            axes = [a[::-1] if flips >> n & 1 else a for n, a in enumerate((lon, lat, gf.PRESSURES))]
            x, y, z = gf.mesh(*axes)
            tag = np.round(1000 * x + 7 * y + z)
            use_structured = rng.random() < 0.5
            sizes = [len(a) for a in axes]
            made = gf.structured(x, y, z, sizes, {"tag": tag}) if use_structured else gf.rectilinear(*axes, {"tag": tag})
            out = gf.globe(made, MaskBelowGround=False).GetOutput()
            both = np.column_stack([gf.points(out), gf.values(out, "tag")])
            if reference is None:
                reference = both
                self.assertTrue((gf.corner_determinants(out)[:, 1:] > 0).all())
            np.testing.assert_allclose(both, reference, atol=1e-6, err_msg=f"flips {flips}")


if __name__ == "__main__":
    unittest.main()
