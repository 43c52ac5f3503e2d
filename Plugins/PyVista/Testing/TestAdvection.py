# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.advect_texture against uniform winds and rotations, series in every form, arguments that arrive, errors."""
import gc
import unittest
import warnings
import weakref

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

DAY = 86400.0


def box(speed=1.0):
    mesh = pyvista.ImageData(dimensions=(9, 7, 5))
    mesh.point_data["wind"] = np.tile((speed, 0.0, 0.0), (mesh.n_points, 1))
    mesh.point_data["other"] = np.zeros((mesh.n_points, 3))
    mesh.point_data["speed"] = np.full(mesh.n_points, speed)
    return mesh


def globe(turns_a_day=1.0):
    """A planet that turns about its axis."""
    weather = pyvista.RectilinearGrid(np.arange(36) * 10.0, np.linspace(-90, 90, 19), [0.0, 5000.0, 10000.0])
    weather.point_data["gh"] = weather.points[:, 2]
    weather.point_data["u"] = 2 * np.pi * turns_a_day / DAY * (6371000.0 + weather.points[:, 2]) * np.cos(np.radians(weather.points[:, 1]))
    weather.point_data["v"] = np.zeros(weather.n_points)
    return weather.nephoscope.globe(height="gh", wind=("u", "v"))


BOX = dict(vectors="wind", period=8, time_step=1)


class Steady(unittest.TestCase):
    def test_uniform_wind(self):
        mesh = box()
        moved = mesh.nephoscope.advect_texture(3, **BOX)
        self.assertIsInstance(moved, pyvista.ImageData)
        np.testing.assert_allclose(moved.field_data["TextureAges"], [3, 7])
        np.testing.assert_allclose(moved.field_data["TextureWeights"], [0.75, 0.25])
        for name, age in (("TextureCoordinates1", 3), ("TextureCoordinates2", 7)):
            np.testing.assert_allclose(moved.point_data[name], (mesh.points - (age, 0, 0)) / 8, atol=1e-6)
        self.assertNotIn("TextureCoordinates1", mesh.point_data)

    def test_rotation_of_a_globe(self):
        moved = globe().nephoscope.advect_texture(0.25 * DAY)
        away = moved.point_data["TextureCoordinates1"] - moved.nephoscope.advect_texture(0.0).point_data["TextureCoordinates1"]
        inner = np.abs(moved.point_data["TextureCoordinates1"][:, 1]) < 0.24
        np.testing.assert_allclose(away[inner, 0], -0.25, atol=3e-5)
        np.testing.assert_allclose(away[inner, 1], 0, atol=3e-5)

    def test_every_argument_arrives(self):
        plain = globe(3).nephoscope.advect_texture(5 * 3600.0)
        for options, name in (({"period": 40000.0}, "TextureCoordinates2"), ({"integrator": "euler"}, "TextureCoordinates1"),
                              ({"time_step": 7200.0, "integrator": "euler"}, "TextureCoordinates1"), ({"time_scale": 2.0}, "TextureCoordinates1"),
                              ({"cartesian_coordinates": True}, "TextureCoordinates1"), ({"grid": "cartesian"}, "TextureCoordinates1"),
                              ({"key_frame_interval": 7000.0}, "TextureCoordinates1")):
            other = globe(3).nephoscope.advect_texture(5 * 3600.0, **options)
            self.assertFalse(np.array_equal(other.point_data[name], plain.point_data[name]), options)
        self.assertIn("FiniteTimeLyapunovExponent", globe().nephoscope.advect_texture(3600.0, lyapunov=True).point_data)
        self.assertIn("TextureWeights", globe().nephoscope.advect_texture(3600.0, maximum_stretch=2).point_data)
        lengths = box().nephoscope.advect_texture(0, texture_length=2, **BOX).point_data["TextureCoordinates1"]
        np.testing.assert_allclose(lengths.max(axis=0), [4, 3, 2])

    def test_points(self):
        cloud = pyvista.PolyData([(4.0, 3, 2), (5, 3, 2)])
        moved = box().nephoscope.advect_texture(2, points=cloud, **BOX)
        np.testing.assert_allclose(moved.point_data["TextureCoordinates1"], (cloud.points - (2, 0, 0)) / 8, atol=1e-6)


class Series(unittest.TestCase):
    times = [0.0, 1.0, 2.0, 3.0]

    def expected(self, time):
        return -(time + time**2 / 2)  # of a wind 1 + t

    def test_grids_and_functions_are_the_same(self):
        grids, read = [box(1 + t) for t in self.times], []

        def field(time):
            read.append(time)
            return box(1 + time)

        for series in (grids, field):
            moved = list(nephoscope.advect_texture(series, [0.5, 1.5, 3.0], times=self.times, **BOX))
            for time, mesh in zip((0.5, 1.5, 3.0), moved):
                away = mesh.point_data["TextureCoordinates1"][:, 0] * 8 - mesh.points[:, 0]
                np.testing.assert_allclose(away, self.expected(time), atol=1e-5)
                np.testing.assert_allclose(mesh.point_data["speed"], 1 + time)
        self.assertEqual(read, self.times, "every field is read once")

    def test_time_scale(self):
        grids = [box(1 + t) for t in self.times]
        hours = nephoscope.advect_texture(grids, 1.5 / 3600, times=[t / 3600 for t in self.times], time_scale=3600, **BOX)
        seconds = nephoscope.advect_texture(grids, 1.5, times=self.times, **BOX)
        np.testing.assert_allclose(hours.point_data["TextureCoordinates1"], seconds.point_data["TextureCoordinates1"], atol=1e-6)


class Memory(unittest.TestCase):
    def test_meshes_are_not_kept(self):
        """Those of a wind, steady or not, are freed when the caller has done with them, as in a film of many steps."""
        def steady(mesh):
            return nephoscope.advect_texture(mesh, 1, **BOX)

        def unsteady(mesh):
            return nephoscope.advect_texture([mesh, box()], 1, times=[0, 3], **BOX)

        def function(mesh):
            return nephoscope.advect_texture(lambda time: mesh, 1, times=[0, 3], **BOX)

        def smoke(mesh):
            return nephoscope.flow_volume([mesh, box()], times=[0, 3], time=1, vectors="wind", radius=0.1)

        for draw in (steady, unsteady, function, smoke):
            with self.subTest(draw.__name__):
                mesh = box()
                kept, result = weakref.ref(mesh), draw(mesh)
                del mesh
                gc.collect()
                self.assertIsNone(kept())
                self.assertTrue(result.n_points)


class Periods(unittest.TestCase):
    def test_follow_size_and_speed(self):
        """The fastest air crosses a quarter of the diagonal, whatever the units; steps are 1/24 of it."""
        for length, speed in ((1e-3, 0.3), (1.0, 1.0), (1.0, 1e-3), (1e7, 40.0)):
            mesh = box(speed)
            mesh.spacing = (length,) * 3
            mesh["wind"][0] = (0, 2 * speed, 0)
            period = mesh.length / (2 * speed) / 4
            moved = mesh.nephoscope.advect_texture(vectors="wind")
            np.testing.assert_allclose(moved.field_data["TextureAges"], [period / 2, 0], rtol=1e-6, atol=1e-6 * period)
            given = mesh.nephoscope.advect_texture(vectors="wind", period=period, time_step=period / 24)
            np.testing.assert_array_equal(moved["TextureCoordinates1"], given["TextureCoordinates1"])
        mesh = box()
        for name in ("wind", "other"):
            mesh.point_data.pop(name)
        mesh.cell_data["only"] = np.tile((0.5, 0.0, 0.0), (mesh.n_cells, 1))
        np.testing.assert_allclose(mesh.nephoscope.advect_texture().field_data["TextureAges"][0], mesh.length / 0.5 / 8)

    def test_a_day_on_a_globe_and_where_air_is_calm(self):
        for mesh, options in ((globe(30), {}), (box(0.0), {"vectors": "wind"})):
            np.testing.assert_allclose(mesh.nephoscope.advect_texture(**options).field_data["TextureAges"], [DAY / 2, 0], atol=1e-6)

    def test_too_long(self):
        with self.assertWarnsRegex(RuntimeWarning, r"period is 1000 s, .* crosses the data 93 times.* give about 2\.7") as caught:
            box().nephoscope.advect_texture(0, vectors="wind", period=1000, time_step=100)
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            box().nephoscope.advect_texture(0, **BOX)
            globe().nephoscope.advect_texture(0, period=DAY)


class Errors(unittest.TestCase):
    def test_numbers_and_choices(self):
        for options in ({"period": 0}, {"time_step": -1}, {"tolerance": 0}, {"time_scale": np.nan}, {"key_frame_interval": -1},
                        {"integrator": "midpoint"}, {"grid": "torus"}, {"texture_length": -1}, {"planet_radius": np.inf}):
            with self.assertRaisesRegex(ValueError, next(iter(options)), msg=options):
                nephoscope.advect_texture(box(), 1, **{**BOX, **options})
        with self.assertRaisesRegex(RuntimeError, "maximum_stretch"):
            nephoscope.advect_texture(box(), 1, maximum_stretch=0.5, **BOX)

    def test_arrays(self):
        with self.assertRaisesRegex(MissingDataError, "'nothing'.*'wind'"):
            nephoscope.advect_texture(box(), 1, vectors="nothing")
        with self.assertRaisesRegex(MissingDataError, "pressure"):
            nephoscope.advect_texture(box(), 1, pressure="p", omega="w", **BOX)

    def test_series(self):
        with self.assertRaisesRegex(ValueError, "2 grids and 1 times"):
            nephoscope.advect_texture([box(), box()], 1, **BOX)
        with self.assertRaisesRegex(ValueError, "empty"):
            nephoscope.advect_texture([], 1, times=[], **BOX)
        with self.assertRaisesRegex(RuntimeError, "Times must increase"):
            nephoscope.advect_texture([box(), box()], 1, times=[1, 0], **BOX)
        with self.assertRaisesRegex(TypeError, "mesh is a MultiBlock; it must be a dataset, not blocks"):
            nephoscope.advect_texture(pyvista.MultiBlock([pyvista.ImageData(dimensions=(3, 3, 3))] * 2), 1)
        with self.assertRaisesRegex(TypeError, "must be a dataset"):
            nephoscope.advect_texture(lambda time: pyvista.MultiBlock([box()]), 1, times=[0], **BOX)

    def test_a_function_that_fails(self):
        def field(time):
            if time > 1:
                raise OSError("disk is gone")
            return box()

        with self.assertRaisesRegex(OSError, "disk is gone"):
            nephoscope.advect_texture(field, 3, times=[0, 1, 2, 3], **BOX)


if __name__ == "__main__":
    unittest.main()
