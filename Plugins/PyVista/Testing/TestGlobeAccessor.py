# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""mesh.nephoscope.globe and nephoscope.globe_surface: positions in closed form, arguments, errors."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkImageData

R = 6371000.0


def weather(step=30.0):
    """A global grid, levels 0 and 10 km, wind 20 m/s from the west."""
    grid = pyvista.RectilinearGrid(np.arange(0, 360, step), np.linspace(-90, 90, 7), [0.0, 10000.0])
    grid.point_data["u"] = np.full(grid.n_points, 20.0)
    grid.point_data["v"] = np.zeros(grid.n_points)
    grid.point_data["z"] = np.array(grid.points[:, 2])
    return grid


def globe(**options):
    return weather().nephoscope.globe(**{"level_units": "m", "mask_below_ground": False, **options})


class Globe(unittest.TestCase):
    def distance_to(self, grid, point):
        return np.linalg.norm(np.asarray(grid.points) - point, axis=1)

    def test_known_places(self):
        grid = globe(vertical_exaggeration=3)
        self.assertIsInstance(grid, pyvista.StructuredGrid)
        for place in ((R, 0, 0), (0, R, 0), (-R, 0, 0), (0, 0, R), (0, 0, -R), (R + 30000, 0, 0)):
            self.assertLess(self.distance_to(grid, place).min(), 1.0, place)

    def test_radius_and_seam(self):
        self.assertEqual(tuple(globe(radius=10.0, vertical_exaggeration=0).dimensions), (13, 7, 2))
        grid = globe(radius=10.0, vertical_exaggeration=0, close_seam=False)
        self.assertEqual(tuple(grid.dimensions), (12, 7, 2))
        np.testing.assert_allclose(np.linalg.norm(grid.points, axis=1), 10, rtol=1e-6)

    def test_map(self):
        grid = globe(projection="map", central_meridian=0)
        np.testing.assert_allclose(grid.bounds[2:], (-R * np.pi / 2, R * np.pi / 2, 0, 10000), rtol=1e-6)
        self.assertAlmostEqual(grid.bounds[0] / R, -np.pi, places=5)

    def test_wind_is_eastward(self):
        grid = globe()
        at = self.distance_to(grid, (R, 0, 0)).argmin()
        np.testing.assert_allclose(grid.point_data["Wind"][at], (0, 20, 0), atol=1e-4)
        self.assertNotIn("Wind", globe(wind=False).point_data)

    def test_usual_names_of_winds(self):
        flat = pyvista.RectilinearGrid(np.arange(0, 360, 30.0), np.linspace(-90, 90, 7), [100000.0, 50000.0])
        flat.clear_data()
        for names, units, upward in ((("u", "v", "w"), "", False), (("u", "v", "w"), "m s**-1", True), (("ua", "va", "wa"), "", True),
                                     (("ua", "va", "wa"), "Pa s-1", False), (("ua", "va", "wap"), "", False), (("U", "V", "W"), "", True),
                                     (("U", "V", "OMEGA"), "Pa/s", False), (("ua", "va"), "", None)):
            mesh = flat.copy()
            for name, value in zip(names, (20.0, 0.0, 1.0)):
                mesh[name] = np.full(mesh.n_points, value)
            if units:
                mesh.field_data[f"{names[2]}_units"] = [units]
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                grid = mesh.nephoscope.globe(mask_below_ground=False)
            at = self.distance_to(grid, (R, 0, 0)).argmin()
            wind = grid["Wind"][at]
            np.testing.assert_allclose(wind[1:], (20, 0), atol=1e-4)
            self.assertTrue(abs(wind[0] - 1) < 1e-4 if upward else abs(wind[0]) < 1e-4 if upward is None else wind[0] < 0, (names, units, wind))
        flat["U"] = flat.points
        flat["V"] = flat.points
        self.assertNotIn("Wind", flat.nephoscope.globe(level_units="Pa").array_names)

    def test_temperature_of_omega(self):
        mesh = pyvista.RectilinearGrid(np.arange(0, 360, 30.0), np.linspace(-90, 90, 7), [100000.0, 50000.0])
        for name, value in (("ua", 0.0), ("va", 0.0), ("wap", -1.0), ("ta", 300.0)):
            mesh[name] = np.full(mesh.n_points, value)
        grid = mesh.nephoscope.globe(mask_below_ground=False)
        at = self.distance_to(grid, (R, 0, 0)).argmin()
        np.testing.assert_allclose(grid["Wind"][at][0], 287.05 * 300 / (9.80665 * 100000), rtol=1e-3)

    def test_usual_names_of_heights(self):
        for name, units, factor, used in (("zg", "", 1.0, True), ("z", "m**2 s**-2", 9.80665, True), ("z", "m", 1.0, True), ("z", "", 1.0, False)):
            mesh = pyvista.RectilinearGrid(np.arange(0, 360, 30.0), np.linspace(-90, 90, 7), [100000.0, 50000.0])
            mesh[name] = np.where(mesh.points[:, 2] > 60000, 200.0, 5400.0) * factor
            if units:
                mesh.field_data[f"{name}_units"] = [units]
            heights = mesh.nephoscope.globe(mask_below_ground=False)["Height"]
            self.assertEqual(bool(abs(heights.max() - 5400) < 1), used, (name, units, heights.max()))

    def test_without_winds(self):
        """What needs them tells how to name them."""
        mesh = weather()
        mesh.rename_array("u", "eastwards")
        grid = mesh.nephoscope.globe(level_units="m")
        for call in (lambda: nephoscope.flow_volume(grid), lambda: nephoscope.flow_volume(grid, vectors="DisplayVelocity"),
                     lambda: nephoscope.advect_texture(grid), lambda: nephoscope.advect_texture(grid, vectors="Wind"),
                     lambda: nephoscope.add_splats(pyvista.Plotter(off_screen=True), grid, vectors="DisplayVelocity"),
                     lambda: nephoscope.add_cells(pyvista.Plotter(off_screen=True), grid, "Wind")):
            with self.assertRaisesRegex(MissingDataError, r'globe\(wind=\("ua", "va"\)\)'):
                call()

    def test_nothing_is_warned_of_that_was_not_asked_for(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            globe()
            globe(wind=False)
            nephoscope.globe_surface()
            nephoscope.globe_surface(projection="map")

    def test_a_warning_names_the_line_of_the_caller(self):
        twice_round = pyvista.RectilinearGrid(np.arange(0, 720, 30.0), [-10.0, 0, 10], [0.0, 10000])
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            twice_round.nephoscope.globe(level_units="m")
        self.assertEqual([warning.filename for warning in caught], [__file__])
        self.assertRegex(str(caught[0].message), "vtkGlobeGrid: The longitudes cover more than one turn")

    def test_plain_vtk_objects(self):
        plain = vtkImageData()
        plain.SetDimensions(36, 19, 2)
        plain.SetOrigin(0, -90, 0)
        plain.SetSpacing(10, 10, 1000)
        self.assertEqual(tuple(nephoscope.to_globe(plain, level_units="m").dimensions), (37, 19, 2))

    def test_height_array(self):
        mesh = weather()
        mesh.point_data["metres"] = np.full(mesh.n_points, 5000.0)
        grid = mesh.nephoscope.globe(height="metres", level_units="m", mask_below_ground=False)
        np.testing.assert_allclose(np.linalg.norm(grid.points, axis=1), R + 5000, rtol=1e-6)

    def test_input_is_not_changed(self):
        mesh = weather()
        names = mesh.array_names
        mesh.nephoscope.globe(level_units="m")
        self.assertEqual(mesh.array_names, names)

    def test_errors(self):
        mesh = weather()
        with self.assertRaisesRegex(MissingDataError, "height: no array 'gz'. Point arrays: 'u', 'v', 'z'"):
            mesh.nephoscope.globe(height="gz")
        with self.assertRaisesRegex(MissingDataError, "wind: no array 'w'"):
            mesh.nephoscope.globe(wind=("u", "v", "w"))
        with self.assertRaisesRegex(ValueError, "two or three arrays"):
            mesh.nephoscope.globe(wind=["u"])
        with self.assertRaisesRegex(ValueError, "projection is 'mercator'.*'globe', 'map'"):
            mesh.nephoscope.globe(projection="mercator")
        with self.assertRaisesRegex(ValueError, "radius is 0"):
            mesh.nephoscope.globe(radius=0)
        with self.assertRaisesRegex(ValueError, "vertical_exaggeration is -1"):
            mesh.nephoscope.globe(vertical_exaggeration=-1)
        with self.assertRaisesRegex(TypeError, "mesh is a PolyData"):
            pyvista.Sphere().nephoscope.globe()
        with self.assertRaisesRegex(TypeError, "surface is a PolyData"):
            mesh.nephoscope.globe(surface=pyvista.Sphere())

    def test_message_of_the_filter_is_raised(self):
        with warnings.catch_warnings(), self.assertRaisesRegex(RuntimeError, "vtkGlobeGrid: "):
            warnings.simplefilter("ignore")
            pyvista.RectilinearGrid([0, 1.0], [-500, 500.0], [0.0, 1.0]).nephoscope.globe(level_units="m")


class Surface(unittest.TestCase):
    def test_texture_coordinates_are_longitude_and_latitude(self):
        surface = nephoscope.globe_surface()
        self.assertIsNone(surface.active_scalars_name, "it is coloured by its texture coordinates")
        points, texture = np.asarray(surface.points, float), np.asarray(surface.active_texture_coordinates)
        radius = np.linalg.norm(points, axis=1)
        np.testing.assert_allclose(radius, R, rtol=1e-6)
        latitude = np.degrees(np.arcsin(points[:, 2] / radius))
        np.testing.assert_allclose(texture[:, 1], latitude / 180 + 0.5, atol=1e-3)
        away = np.abs(latitude) < 89.5  # the longitude of a pole is anything
        turns = np.degrees(np.arctan2(points[:, 1], points[:, 0]))[away] / 360 + 0.5 - texture[away, 0]
        np.testing.assert_allclose(turns - np.rint(turns), 0, atol=1e-5)

    def test_map_covers_what_the_weather_covers(self):
        for meridian in (0.0, 180.0):
            ours = nephoscope.globe_surface(projection="map", central_meridian=meridian).bounds
            theirs = globe(projection="map", central_meridian=meridian).bounds
            np.testing.assert_allclose(ours[2:4], theirs[2:4], rtol=1e-6)
            self.assertLess(abs(ours[0] - theirs[0]) / R, np.radians(31))
            self.assertLess(abs(ours[1] - theirs[1]) / R, np.radians(31))


if __name__ == "__main__":
    unittest.main()
