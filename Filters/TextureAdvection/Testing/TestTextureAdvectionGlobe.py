# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texture coordinates on globes, in winds whose paths are known: poles, seam, levels, ground, map, pieces of time."""
import unittest

import numpy as np
from nephoscope_testing.texture import DAY, RADIUS, Globe, advection, of_place, rotation, turned, update

RATE = 2 * np.pi / (12 * DAY)
AXES = {"equator": (1, 0, 0), "oblique": (1, 2, 0.5), "axis": (0, 0, 1)}




def distance_km(coordinates, expected):
    return RADIUS / 1000 * np.linalg.norm(of_place(coordinates) - expected, axis=1)


def unit_vectors(output):
    points = np.array([output.GetPoint(i) for i in range(output.GetNumberOfPoints())])
    return points / np.linalg.norm(points, axis=1)[:, None]


class Rotations(unittest.TestCase):
    def check(self, limit, axis, time=0.5 * DAY, settings=(), **grid):
        texture, messages = update(advection(Globe(rotation(axis, RATE), **grid).grid(0), **dict(settings)), time)
        self.assertEqual(messages, [])
        start, axis = unit_vectors(texture.output), np.asarray(axis) / np.linalg.norm(axis)
        worst = 0
        for coordinates, age in zip(texture.sets, texture.ages):
            worst = max(worst, distance_km(coordinates, turned(start, axis, -RATE * age)).max())
        self.assertLess(worst, limit)
        return worst

    def test_poles_and_seam(self):
        """Half a circumference of single precision is 3 m, so 5 m."""
        for name, axis in AXES.items():
            for time in (0.25 * DAY, 0.999 * DAY):
                with self.subTest(name, time=time):
                    self.check(5e-3, axis, time)

    def test_rows_that_end_before_the_poles(self):
        for axis in AXES.values():
            self.check(5e-3, axis, poles=False)

    def test_columns_that_do_not_close(self):
        self.check(5e-3, AXES["oblique"], closed=False)

    def test_one_level(self):
        self.check(5e-3, AXES["oblique"], levels=(0.0,))

    def test_adaptive(self):
        self.check(5e-3, AXES["oblique"], settings=dict(Integrator=2))

    def test_euler_is_of_first_order(self):
        errors = [self.check(100, AXES["equator"], settings=dict(Integrator=0, TimeStep=h)) for h in (7200, 3600)]
        self.assertAlmostEqual(errors[0] / errors[1], 2, delta=0.1)

    def test_cartesian_coordinates(self):
        texture, _ = update(advection(Globe(rotation(AXES["oblique"], RATE)).grid(0), CartesianCoordinates=True), 0.4 * DAY)
        axis = np.array(AXES["oblique"]) / np.linalg.norm(AXES["oblique"])
        start = np.array([texture.output.GetPoint(i) for i in range(texture.output.GetNumberOfPoints())])
        expected = turned(start, axis, -RATE * texture.ages[0]) / (2 * np.pi * RADIUS)
        np.testing.assert_allclose(texture.sets[0], expected, atol=3e-8)
        self.assertEqual(texture.field_array("TextureFrame")[0], 1)


class Unwrapped(unittest.TestCase):
    def test_no_jump_inside_a_cell(self):
        """Westerlies that go round more than once: u falls below 0 and no cell sees a jump."""
        source = Globe(rotation((0, 0, 1), 2 * np.pi / DAY * 1.6))
        texture, _ = update(advection(source.grid(0), TimeStep=300), 0.45 * DAY)
        u = texture.sets[1][:, 0].reshape(3, 37, 73)
        np.testing.assert_allclose(np.diff(u[:, 1:-1], axis=2), 1 / 72, atol=1e-6)
        np.testing.assert_allclose(u[:, 1:-1, 0], -1.6 * texture.ages[1] / DAY, atol=1e-6)

    def test_oblique_winds_jump_at_the_poles_only(self):
        texture, _ = update(advection(Globe(rotation((1, 2, 8), RATE)).grid(0)), 0.4 * DAY)
        u = texture.sets[0][:, 0].reshape(3, 37, 73)[:, 3:-3]
        self.assertLess(np.abs(np.diff(u, axis=2)).max(), 0.1)
        self.assertLess(np.abs(np.diff(u, axis=1)).max(), 0.1)


class Levels(unittest.TestCase):
    def test_height_is_followed(self):
        rise = 0.02
        motion = lambda unit, height, time: (np.zeros(3), rise * (1 - height / 10000))
        texture, _ = update(advection(Globe(motion).grid(0)), 0.4 * DAY)
        height = texture.sets[0][:, 2].reshape(3, -1) * 2 * np.pi * RADIUS
        age = texture.ages[0]
        expected = np.maximum(10000 - (10000 - np.array([0, 5000, 10000])) * np.exp(rise / 10000 * age), 0)
        np.testing.assert_allclose(height, np.broadcast_to(expected[:, None], height.shape), atol=5)

    def test_sloping_levels_that_move_do_not_move_the_air(self):
        """Without a vertical wind the height stays, whatever the levels do; the wind depends on height alone."""
        heights = lambda unit, height, time: height + 900 * unit[:, 0] * unit[:, 2] + 400 * np.sin(2 * np.pi * time / DAY)
        motion = lambda unit, height, time: (np.cross([0, 0, RATE * 3], unit), 0.0)
        source = Globe(motion, times=np.arange(0, 30) * 3600.0, heights=heights, levels=np.linspace(0, 12000, 9))
        texture, _ = update(advection(source), 26 * 3600)
        z = np.linalg.norm(np.array([texture.output.GetPoint(i) for i in range(texture.output.GetNumberOfPoints())]), axis=1) - RADIUS
        gone = texture.sets[1][:, 2] * 2 * np.pi * RADIUS - z
        inside = (z > 2000) & (z < 10000)
        self.assertLess(np.abs(gone[inside]).max(), 4)

    def test_the_ground_is_not_crossed(self):
        ground = lambda unit: 4000 * np.exp(-((unit[:, 0] - 1) ** 2 + unit[:, 2] ** 2) / 0.02)
        source = Globe(lambda unit, height, time: (np.cross([0, 0, RATE], unit), 0.03), levels=np.linspace(0, 12000, 25),
                       hidden=lambda unit, height: height < ground(unit))
        texture, messages = update(advection(source.grid(0)), 0.4 * DAY)
        self.assertEqual(messages, [])
        for coordinates in texture.sets:
            height = coordinates[:, 2] * 2 * np.pi * RADIUS
            visible = texture.point_array("vtkGhostType") == 0
            self.assertGreater((height - ground(of_place(coordinates)))[visible].min(), -600)
            self.assertTrue(np.isfinite(coordinates).all())

    def test_pressure_is_followed_on_hybrid_levels(self):
        """omega as a chain of p: air keeps the pressure that its history says, on levels that slope and move."""
        times = np.arange(0, 30) * 3600.0
        surface = lambda unit, t: 1e5 + 3000 * unit[:, 0] * unit[:, 2] + 2000 * np.sin(2 * np.pi * t / DAY)

        class Hybrid(Globe):
            def grid(self, time):
                grid = super().grid(time)
                points = np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])
                length = np.linalg.norm(points, axis=1)
                unit, sigma = points / length[:, None], 1 - (length - RADIUS) / 15000
                from nephoscope_testing.texture import add
                add(grid, (sigma * surface(unit, time)).astype(np.float32), "p")
                add(grid, np.full(len(points), 0.1, np.float32), "omega")
                return grid
        source = Hybrid(rotation((0, 0, 1), 3 * RATE), times=times, levels=np.linspace(0, 12000, 13))
        texture, messages = update(advection(source, PressureArrayNames=("p", "omega")), 26 * 3600)
        self.assertEqual(messages, [])
        age = texture.ages[1]
        start = unit_vectors(texture.output)
        end = turned(start, (0, 0, 1), -3 * RATE * age)
        pressure = texture.point_array("p") - 0.1 * age
        expected = 15000 * (1 - pressure / surface(end, 26 * 3600 - age))
        z = np.linalg.norm(np.array([texture.output.GetPoint(i) for i in range(len(expected))]), axis=1) - RADIUS
        inside = (z > 2500) & (expected < 10500)  # neither the ground nor the top is met on the way
        gone = texture.sets[1][:, 2] * 2 * np.pi * RADIUS - expected
        self.assertGreater(inside.sum(), 10000)
        self.assertLess(np.abs(gone[inside]).max(), 30)  # of levels that are 1000 m apart, on cells of 5 degrees


class Maps(unittest.TestCase):
    def test_the_map_gives_what_the_globe_gives(self):
        import nephoscope
        from nephoscope_testing import meshes
        from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
        from vtkmodules.util.numpy_support import numpy_to_vtk
        lon, lat, lev = np.arange(0, 360, 5.0), np.linspace(-90, 90, 37), np.array([0.0, 5000, 10000])
        data = vtkRectilinearGrid()
        data.SetDimensions(len(lon), len(lat), len(lev))
        for put, axis in ((data.SetXCoordinates, lon), (data.SetYCoordinates, lat), (data.SetZCoordinates, lev)):
            put(numpy_to_vtk(axis, deep=True))
        _, phi, lam = np.meshgrid(lev, np.radians(lat), np.radians(lon), indexing="ij")
        u0, alpha = RATE * RADIUS, 0.7
        u = u0 * (np.cos(phi) * np.cos(alpha) + np.sin(phi) * np.cos(lam) * np.sin(alpha))
        v = -u0 * np.sin(lam) * np.sin(alpha)
        for name, values in (("u", u), ("v", v), ("w", 0 * u)):
            meshes.add_array(data.GetPointData(), values.ravel(), name)
        sets = []
        for projection in (0, 1):
            globe = nephoscope.vtkGlobeGrid()
            globe.SetInputData(data)
            globe.SetProjection(projection)
            globe.SetVerticalExaggeration(40)
            texture, messages = update(advection(globe), 0.4 * DAY)
            self.assertEqual(messages, [])
            sets.append(texture.sets)
        for globe, flat in zip(*sets):
            self.assertLess(np.linalg.norm(of_place(globe) - of_place(flat), axis=1).max(), 2e-6)
            np.testing.assert_allclose(globe[:, 2], flat[:, 2], atol=1e-7)
            middle = np.abs(globe[:, 1]) < 0.2
            np.testing.assert_allclose(globe[middle], flat[middle], atol=2e-6)


if __name__ == "__main__":
    unittest.main()
