#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""add_cells(sun=...): exposure and contrast with nothing set, names and units of water, messages."""
import contextlib
import importlib
import unittest
import warnings
from datetime import datetime, timedelta, timezone

import nephoscope
import numpy as np
import pyvista
from nephoscope._dates import options_of
from nephoscope.light import automatic_white, lit
from nephoscope.weather.roles import ROLES

pyvista.OFF_SCREEN = True


def slab(**water):
    """Water of 0.3 g/kg between 1 and 2 km, over 6 x 6 km."""
    mesh = pyvista.ImageData(dimensions=(7, 7, 13), spacing=(1000, 1000, 250))
    height = mesh.points[:, 2]
    mesh["t"], mesh["p"] = 288 - 0.0065 * height, 1e5 * np.exp(-height / 8000)
    for name, scale in water.items():
        mesh[name] = np.where((height >= 1000) & (height <= 2000), 3e-4 * scale, 0.0)
    return mesh


def lumps():
    mesh = pyvista.ImageData(dimensions=(41, 41, 21), spacing=(50, 50, 50))
    x, y, z = mesh.points.T
    mesh["Extinction"] = np.where(np.hypot(np.hypot(x - 1000, y - 1000), z - 500) < 350, 0.05, 0.0)
    return mesh


def ball(points):
    """A smooth one with as many points along each side, on a cube of 2 km."""
    mesh = pyvista.ImageData(dimensions=(points, points, points // 2 + 1), spacing=(2000 / (points - 1),) * 3)
    radius = np.linalg.norm(mesh.points - (1000, 1000, 500), axis=1)
    mesh["Extinction"] = 0.02 * np.clip(1 - (radius / 450) ** 2, 0, 1) ** 2
    return mesh


def picture(mesh=None, add=nephoscope.add_cells, **options):
    plotter = pyvista.Plotter(window_size=(120, 120))
    plotter.set_background("black")
    add(plotter, lumps() if mesh is None else mesh, **{"sun": (1, 0, 0.3), "show_scalar_bar": False, **options})
    plotter.camera_position = [(1000, -3500, 500), (1000, 1000, 500), (0, 0, 1)]
    image = plotter.screenshot(return_img=True).astype(float).max(axis=2)
    plotter.close()
    return image


class SunOfScene(unittest.TestCase):
    """What else is in the view is lit by the same sun, unless there are scene lights."""

    def lights(self, add, sun, own=()):
        plotter = pyvista.Plotter()
        for light in own:
            plotter.add_light(light)
        add(plotter, lumps(), sun=sun, show_scalar_bar=False)
        lights = list(plotter.renderer.lights)
        plotter.close()
        return lights

    def test_one_light_from_the_sun(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            (light,) = self.lights(add, (3, 0, 4))
            self.assertTrue(light.is_scene_light)
            np.testing.assert_allclose(np.subtract(light.position, light.focal_point), (0.6, 0, 0.8), atol=1e-9)

    def test_scene_lights_stay(self):
        lights = self.lights(nephoscope.add_cells, (3, 0, 4), [pyvista.Light(position=(0, 1, 0), light_type="scene light")])
        self.assertNotIn((0.6, 0, 0.8), [tuple(np.round(light.position, 6)) for light in lights])

    def test_other_subplots_keep_their_lights(self):
        plotter = pyvista.Plotter(shape=(1, 3))
        self.addCleanup(plotter.close)
        before = [list(renderer.lights) for renderer in plotter.renderers]
        for column, sun in ((0, (3, 0, 4)), (2, (0, 0, 1))):
            plotter.subplot(0, column)
            nephoscope.add_cells(plotter, lumps(), sun=sun, show_scalar_bar=False)
        self.assertEqual(list(plotter.renderers[1].lights), before[1])
        for column, sun in ((0, (0.6, 0, 0.8)), (2, (0, 0, 1))):
            (light,) = plotter.renderers[column].lights
            np.testing.assert_allclose(light.position, sun, atol=1e-9)

    def test_no_sun_no_change(self):
        plotter = pyvista.Plotter()
        before = len(plotter.renderer.lights)
        nephoscope.add_cells(plotter, lumps())
        self.assertEqual(len(plotter.renderer.lights), before)
        self.assertFalse(any(light.is_scene_light for light in plotter.renderer.lights))
        plotter.close()


class SunOfMap(unittest.TestCase):
    """A date on a map of `to_globe`, without a place: the sun of its middle."""

    def grid(self, west, east):
        mesh = pyvista.RectilinearGrid(np.linspace(west, east, 5), np.linspace(30, 40, 5), np.linspace(0, 8000, 3))
        mesh["Extinction"] = np.zeros(mesh.n_points)
        metres = np.radians(1) * 6.371e6
        mesh.x, mesh.y = mesh.x * metres, mesh.y * metres
        mesh.field_data["GlobeGridProjection"], mesh.field_data["PlanetRadius"] = [1.0], [6.371e6]
        return mesh

    def test_noon_is_where_it_belongs(self):
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", ".*below the horizon", RuntimeWarning)
            for west, hour in ((130, 3), (490, 3), (-230, 3), (-5, 12), (-125, 20)):  # longitudes may be given with whole turns
                for later, day in ((0, True), (12, False)):
                    time = f"2011-10-11 {(hour + later) % 24:02}:00"
                    mesh = self.grid(west, west + 10)
                    sun = nephoscope.sunlight(mesh, time).field_data["SunDirection"][0]
                    self.assertEqual(sun[2] > 0.7, day, (west, time, sun))
                    plotter = pyvista.Plotter(off_screen=True)
                    self.addCleanup(plotter.close)
                    np.testing.assert_allclose(nephoscope.add_haze(plotter, mesh, sun=time).GetSunDirection(), sun, atol=1e-6)

    def test_a_wide_map_has_the_sun_of_its_middle(self):
        with self.assertWarnsRegex(RuntimeWarning, "A map has one sun: .* longitude 140 and latitude 35. Give place"):
            nephoscope.sunlight(self.grid(110, 170), "2011-10-11 03:00")


class Blocks(unittest.TestCase):
    def test_blocks_shade_one_another(self):
        """A ball cut in two; and one whose shadow falls on another, across a gap."""
        mesh = ball(41)
        halves = pyvista.MultiBlock([mesh.extract_subset((0, 20, 0, 40, 0, 20)), mesh.extract_subset((20, 40, 0, 40, 0, 20))])
        whole, together = (nephoscope.sunlight(data, (1, 0, 0.3)) for data in (mesh, halves))
        np.testing.assert_allclose(together["SunTransmittance"], together.sample(whole)["SunTransmittance"], atol=0.03)
        apart = ball(41)
        apart.origin = (2500, 0, 0)
        alone, shaded = (nephoscope.sunlight(data, (1, 0, 0), multiple_scattering=False) for data in (mesh, pyvista.MultiBlock([mesh, apart])))
        self.assertGreater(alone["SunTransmittance"].max(), 0.999)
        beside = np.argmin(np.linalg.norm(shaded.points - (1600, 1000, 500), axis=1))
        self.assertAlmostEqual(-np.log(shaded["SunTransmittance"][beside]), 0.02 * 450 * 16 / 15, delta=0.15)

    def test_volumes_shade_one_way(self):
        """A cloud in a volume of its own has the shadow of another, lit before, as `clouds`: the same shadow as in one mesh. The other has none of it."""
        mesh, apart = ball(41), ball(41)
        apart.origin = (2500, 0, 0)
        together = nephoscope.sunlight(pyvista.MultiBlock([mesh, apart]), (1, 0, 0), multiple_scattering=False)
        first = nephoscope.sunlight(apart, (1, 0, 0), multiple_scattering=False)
        second = nephoscope.sunlight(mesh, clouds=first, multiple_scattering=False)
        self.assertGreater(first["SunTransmittance"].max(), 0.999)
        np.testing.assert_allclose(second["SunTransmittance"], second.sample(together)["SunTransmittance"], atol=0.03)
        beside = np.argmin(np.linalg.norm(second.points - (1600, 1000, 500), axis=1))
        self.assertAlmostEqual(-np.log(second["SunTransmittance"][beside]), 0.02 * 450 * 16 / 15, delta=0.15)
        plotter = pyvista.Plotter()
        self.addCleanup(plotter.close)
        volume = nephoscope.add_cells(plotter, mesh, sun={"clouds": first, "multiple_scattering": False})
        np.testing.assert_allclose(volume.mapper.dataset["SunTransmittance"], second["SunTransmittance"], atol=1e-6)

    def test_optics_of_blocks(self):
        mesh = slab(clwc=1)
        halves = pyvista.MultiBlock([mesh.extract_subset((0, 3, 0, 6, 0, 12)), mesh.extract_subset((3, 6, 0, 6, 0, 12))])
        a, b = (nephoscope.cloud_optics(data)["Extinction"] for data in (mesh, halves))
        self.assertAlmostEqual(a.max(), b.max(), delta=1e-6 * a.max())


class Up(unittest.TestCase):
    def test_periodic(self):
        """A ball in the corner of a model with periodic boundaries is lit as the same ball in its middle."""
        mesh = ball(41)
        corner = mesh.copy()
        corner["Extinction"] = np.roll(mesh["Extinction"].reshape(21, 41, 41)[:, :-1, :-1], (20, 20), (1, 2))[:, np.arange(41) % 40][..., np.arange(41) % 40].ravel()
        for options in ({"direction": (1, 0, 0.3)}, {"direction": (1, -2, 1)}):
            light = [nephoscope.sunlight(one, periodic=True, **options)["Sunlight"].reshape(21, 41, 41)[:, :-1, :-1] for one in (mesh, corner)]
            self.assertLess(np.abs(np.roll(light[0], (20, 20), (1, 2)) - light[1]).max(), 0.005)
        with self.assertWarnsRegex(RuntimeWarning, "periodic needs an image.*pyvista.create_grid"):
            nephoscope.sunlight(mesh.threshold(-1, scalars="Extinction"), periodic=True)

    def test_open_sides(self):
        """A tall cloud that fills its mesh is darker without mirrors at its sides. Messages name the arguments."""
        mesh = pyvista.ImageData(dimensions=(9, 9, 25), spacing=(50, 50, 50))
        mesh["Extinction"] = np.full(mesh.n_points, 0.02)
        with self.assertWarnsRegex(RuntimeWarning, r"Turn open_sides on for clouds that end there, or periodic"):
            mirrors = nephoscope.sunlight(mesh, (1, 0, 1))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            opened = nephoscope.sunlight(mesh, (1, 0, 1), open_sides=True)
        self.assertLess(opened["Sunlight"].mean(), 0.8 * mirrors["Sunlight"].mean())
        with self.assertWarnsRegex(RuntimeWarning, "periodic and open_sides are both on"):
            nephoscope.sunlight(mesh, (1, 0, 1), periodic=True, open_sides=True)
        plotter = pyvista.Plotter()
        self.addCleanup(plotter.close)
        volume = nephoscope.add_cells(plotter, mesh, sun={"direction": (1, 0, 1), "open_sides": True})
        np.testing.assert_array_equal(volume.mapper.dataset["Sunlight"], opened["Sunlight"])

    def test_default_sun_turns_with_the_axis(self):
        upright = ball(21)
        turned = upright.cast_to_structured_grid().rotate_x(-90)  # z becomes y
        expected = nephoscope.sunlight(upright)
        for up in ("y", "+y", (0, 3, 0)):
            found = nephoscope.sunlight(turned, up=up)
            np.testing.assert_allclose(found.field_data["SunDirection"][0] * np.sqrt(3), (1, 1, 1), atol=1e-12)
            np.testing.assert_allclose(found["Sunlight"], expected["Sunlight"], atol=1e-4)
        below = nephoscope.sunlight(upright, up="-z", multiple_scattering=False)
        np.testing.assert_allclose(below.field_data["SunDirection"][0] * np.sqrt(3), (1, 1, -1), atol=1e-12)

    def test_up_of_add_cells(self):
        plotter = pyvista.Plotter()
        nephoscope.add_cells(plotter, ball(11), sun={"up": "x", "direction": (1, 0.2, 0)})
        with self.assertWarnsRegex(RuntimeWarning, r"Up is \(1, 0, 0\): set sun\['up'\]"):
            nephoscope.add_cells(plotter, ball(11), sun={"up": "x", "direction": (-1, 0.2, 0)})
        plotter.close()

    def test_no_axis(self):
        for up, sentence in (("north", "'north'; it must be an axis, such as 'y'"), ((0, 0, 0), "longer than 0"), ((1, 2), "three numbers")):
            with self.assertRaisesRegex(ValueError, f"up.*{sentence}"):
                nephoscope.sunlight(ball(5), up=up)


class Exposure(unittest.TestCase):
    def test_shading_without_white(self):
        image = picture()
        lit_side, dark_side = np.percentile(image[image > 10], 95), image[55:65, 40:45].mean()
        self.assertLess(dark_side, 0.6 * lit_side)
        self.assertGreater(lit_side, 140)
        self.assertLess((image > 250).mean(), 0.01)

    def test_exposure_is_that_of_the_light(self):
        self.assertLess(picture(exposure=0.5).mean(), 0.8 * picture(exposure=1.0).mean())
        self.assertGreater(picture(exposure=1.0, tone_mapping="linear")[55:65, 40:45].mean(), 1.2 * picture(exposure=1.0)[55:65, 40:45].mean())

    def test_white(self):
        mesh = pyvista.ImageData(dimensions=(101, 1, 1))
        mesh["Sunlight"], mesh["ScaledExtinction"] = np.linspace(0, 0.5, 101), np.ones(101)
        self.assertAlmostEqual(automatic_white(mesh), 1.1 * 0.49, delta=1e-6)
        mesh["Sunlight"] = mesh["Sunlight"] * 1e-3
        self.assertEqual(automatic_white(mesh), 0.15)
        mesh["ScaledExtinction"] = np.zeros(101)
        self.assertEqual(automatic_white(mesh), 0.6)

    def test_a_time_needs_a_place(self):
        with self.assertWarnsRegex(RuntimeWarning, "time is a date and time without a place: .* Give place,"):
            at_zero = lumps().nephoscope.sunlight(time="2024-06-21 12:00").field_data["SunDirection"]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            told = lumps().nephoscope.sunlight(time="2024-06-21 12:00", place=(0, 0)).field_data["SunDirection"]
        np.testing.assert_array_equal(at_zero, told)
        with self.assertWarnsRegex(RuntimeWarning, r"sun is a date and time without a place: .* Give sun\['place'\],"):
            nephoscope.add_cells(pyvista.Plotter(off_screen=True), lumps(), sun="2024-06-21 12:00")

    def test_time_in_place_of_the_direction(self):
        mesh = pyvista.ImageData(dimensions=(4, 4, 4))
        mesh["Extinction"] = np.full(mesh.n_points, 0.5)
        lit = nephoscope.sunlight(mesh, "2011-10-11 10:00")
        np.testing.assert_array_equal(lit["Sunlight"], nephoscope.sunlight(mesh, time="2011-10-11 10:00")["Sunlight"])
        with self.assertRaisesRegex(ValueError, "direction is '2011.*; it must be three numbers"):
            nephoscope.sunlight(mesh, "2011-10-11 10:00", time="2011-10-11 11:00")


class Dates(unittest.TestCase):
    def test_dates_of_libraries(self):
        """Each is the same sun as the text; those with a time zone are converted to UTC, the others are in UTC."""
        dates = [datetime(2024, 6, 21, 16, 30), datetime(2024, 6, 21, 18, 30, tzinfo=timezone(timedelta(hours=2))), np.datetime64("2024-06-21T16:30"), np.array("2024-06-21T16:30:00", "M8[ns]")]
        for library, name, options in (("pandas", "Timestamp", {}), ("pandas", "Timestamp", {"tz": "UTC"}), ("cftime", "DatetimeGregorian", {})):
            with contextlib.suppress(ImportError):
                dates.append(getattr(importlib.import_module(library), name)(2024, 6, 21, 16, 30, **options))
        mesh, text, place = lumps(), "2024-06-21 16:30:00", {"place": (11, 48), "multiple_scattering": False}
        expected = mesh.nephoscope.sunlight(text, **place).field_data["SunDirection"]
        for date in dates:
            with self.subTest(repr(date)), warnings.catch_warnings():
                warnings.filterwarnings("ignore", "sun is a date and time without a place", RuntimeWarning)
                for lit_mesh in (mesh.nephoscope.sunlight(date, **place), nephoscope.sunlight(mesh, time=date, **place), lit(mesh, {"time": date, **place})):
                    np.testing.assert_array_equal(lit_mesh.field_data["SunDirection"], expected)
                np.testing.assert_array_equal(lit(mesh, date).field_data["SunDirection"], lit(mesh, text).field_data["SunDirection"])
                one, other = (nephoscope.add_haze(pyvista.Plotter(), mesh, sun=sun).GetSunDirection() for sun in (date, text))
                self.assertEqual(one, other)
                self.assertEqual(options_of(date), {"time": text})  # of satellite_image and plot

    def test_no_date(self):
        with self.assertRaisesRegex(ValueError, "sun is 'NaT'; it must be a date and time"):
            lit(lumps(), np.datetime64("NaT"))


class Splats(unittest.TestCase):
    def test_same_picture_as_cells(self):
        """They differ by the reconstruction between the samples: with the square of their distance."""
        worst = []
        for points in (21, 41):
            pictures = [picture(ball(points), add, exposure=1.0) for add in (nephoscope.add_cells, nephoscope.add_splats)]
            worst.append(np.abs(pictures[0] - pictures[1]).mean())
            self.assertGreater(pictures[1].max(), 120)
        self.assertLess(worst[0], 0.25)
        self.assertLess(worst[1], worst[0] / 3)

    def test_exposure_and_tone(self):
        mesh = lumps()
        for options in ({}, {"exposure": 0.5}, {"exposure": 1.0, "tone_mapping": "linear"}):
            with self.subTest(**options):
                cells, splats = (picture(mesh, add, **options) for add in (nephoscope.add_cells, nephoscope.add_splats))
                self.assertLess(abs(splats.mean() / cells.mean() - 1), 0.05)

    def test_points_with_light(self):
        """Particles have the light that was sampled at them; without any there is a remedy."""
        lit_mesh = ball(21).nephoscope.sunlight((1, 0, 0.3))
        points = pyvista.PolyData(lit_mesh.points)
        with self.assertRaisesRegex(ValueError, r"mesh\.nephoscope\.sunlight\(\), sample it at the points, and pass sun=True"):
            nephoscope.add_splats(pyvista.Plotter(), points, sun=(0, 0, 1))
        for name in ("Sunlight", "ScaledExtinction"):
            points[name] = lit_mesh[name]
        grid, particles = picture(lit_mesh, nephoscope.add_splats, sun=True), picture(points, nephoscope.add_splats, sun=True, radius=155.6228)
        self.assertLess(np.abs(grid - particles)[20:-20, 20:-20].mean(), 3)
        with self.assertRaisesRegex(ValueError, "color and sun are both given"):
            nephoscope.add_splats(pyvista.Plotter(), lit_mesh, sun=True, color="red")


class Smoke(unittest.TestCase):
    def test_lit_from_above(self):
        """Thick smoke in an overhead sun: bright above, dark below; dimmed where a cloud is above; of the colour asked for."""
        wind = pyvista.ImageData(dimensions=(9, 5, 5), spacing=(2.5, 2, 2), origin=(-10, -4, -4))
        wind["wind"] = np.tile((1.0, 0, 0), (wind.n_points, 1))
        smoke = wind.nephoscope.flow_volume(center=(-8, 0, 0), radius=1, n_sides=40, duration=16, time_step=0.5)
        cloud = pyvista.ImageData(dimensions=(41, 17, 21), spacing=(0.5, 0.5, 0.5), origin=(-10, -4, -4))
        cloud["Extinction"] = np.where((np.abs(cloud.points[:, 0]) < 2) & (cloud.points[:, 2] > 3), 2.0, 0.0)
        sun = {"clouds": cloud.nephoscope.sunlight((0, 0, 1))}

        def picture(**options):
            plotter = pyvista.Plotter(window_size=(120, 120))
            plotter.set_background("black")
            nephoscope.add_smoke(plotter, smoke, optical_depth=8, **options)
            plotter.camera_position = [(0, -20, 0), (0, 0, 0), (0, 0, 1)]
            plotter.enable_parallel_projection()
            plotter.camera.parallel_scale = 8
            return plotter.screenshot(return_img=True).astype(float)
        overhead = picture(sun=(0, 0, 1))
        self.assertGreater(overhead[54:57, 20].mean(), 1.3 * overhead[63:66, 20].mean())
        shaded = picture(sun=sun, exposure=1.0) / np.maximum(picture(sun=(0, 0, 1), exposure=1.0), 1)
        self.assertLess(shaded[57:63, 60].mean(), 0.75)
        self.assertGreater(shaded[57:63, 8:11].mean(), 0.99)  # the shadow dims diffuse light some radii beyond its edge
        red = picture(sun=(0, 0, 1), color="red")[60, 60]
        self.assertTrue(red[0] > 50 and red[1] == red[2] == 0, red)

    def test_messages(self):
        smoke = pyvista.ImageData(dimensions=(3, 3, 3)).cast_to_unstructured_grid()
        smoke["Density"] = np.ones(smoke.n_cells)
        for text, options in (("scalars and sun are both given", {"scalars": "Density", "sun": (0, 0, 1)}), ("without the array 'SunTransmittance'", {"sun": {"clouds": smoke}}),
                              ("sun has no option 'cloud'", {"sun": {"cloud": smoke}})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                nephoscope.add_smoke(pyvista.Plotter(), smoke, **options)


class CloudTexture(unittest.TestCase):
    def picture(self, mesh, camera=((0, -10, 0), (0, 0, 0), (0, 0, 1)), **options):
        plotter = pyvista.Plotter(window_size=(120, 120))
        plotter.set_background("black")
        nephoscope.add_cloud_texture(plotter, mesh, **{"coverage": 1.0, "relief": 0.0, "thin_color": "white", "optical_depth": 50, **options})
        plotter.camera_position = camera
        return plotter.screenshot(return_img=True).astype(float)

    def test_day_and_night(self):
        """A globe in the sun from the right: bright there, dark on the left."""
        globe = pyvista.Sphere(radius=6.4e6, theta_resolution=60, phi_resolution=60)
        globe.field_data["GlobeGridProjection"], globe.field_data["PlanetRadius"] = [0], [6.371e6]
        row = self.picture(globe, ((0, -3e7, 0), (0, 0, 0), (0, 0, 1)), sun=(1, 0, 0))[60, :, 0]
        seen = np.flatnonzero(row > 3)
        self.assertGreater(row.max(), 200)
        self.assertLess(abs(seen.min() - 60), 3)
        tinted = self.picture(globe, ((0, -3e7, 0), (0, 0, 0), (0, 0, 1)), sun=(1, 0, 0), color="red")[60, 80]
        self.assertTrue(tinted[0] > 100 and tinted[1] < 3, tinted)

    def test_slopes(self):
        """On a ball over flat ground light is that of Lambert, on a base of 0.4 that comes from all around; a light of the user's stays."""
        ball = pyvista.Sphere(theta_resolution=90, phi_resolution=90)
        picture = self.picture(ball, ((0, -3, 0), (0, 0, 0), (0, 0, 1)), sun=(1, -1, 0), tone_mapping="linear")[60, :, 0]
        facing, away = picture[60 + int(0.5 * 34)], picture[60 - int(0.9 * 34)]
        self.assertGreater(facing, 1.8 * away)
        self.assertGreater(away, 0.3 * facing)

    def test_shadows(self):
        """The array Sunlight of a lit grid comes with its surface; clouds shade a surface without."""
        lit_grid = lumps().nephoscope.sunlight((1, 0, 0.3))
        surface = lit_grid.contour([0.02], "Extinction")
        surface.field_data["SunDirection"] = lit_grid.field_data["SunDirection"]
        carried = self.picture(surface, ((1000, -3500, 500), (1000, 1000, 500), (0, 0, 1)), sun=True)[..., 0]
        self.assertGreater(carried[50:70, 70:76].mean(), 1.5 * carried[50:70, 44:50].mean())
        cloud = pyvista.ImageData(dimensions=(5, 5, 9), spacing=(0.5, 0.5, 0.5), origin=(-2, -1, 0))
        cloud["Extinction"] = np.where((cloud.points[:, 0] <= 0) & (cloud.points[:, 2] > 2), 3.0, 0.0)
        sheet = pyvista.Plane(i_resolution=40, j_resolution=40, i_size=3, j_size=1.5).translate((0, 0, 0.5))
        row = self.picture(sheet, ((0, 0, 6), (0, 0, 0), (0, 1, 0)), sun={"clouds": cloud.nephoscope.sunlight((0, 0, 1))})[60, :, 0]
        self.assertGreater(row[75:90].mean(), 200)
        self.assertLess(row[35:50].mean(), 20)

    def test_shadows_on_the_ground(self):
        """A surface gets the light that clouds leave of the same sun: all of it beside them, and what the cloud's depth lets through below."""
        cloud = pyvista.ImageData(dimensions=(9, 9, 5), spacing=(0.25, 0.25, 0.25), origin=(-1, -1, 1))
        cloud["Extinction"] = np.full(cloud.n_points, 1.5)
        ground = pyvista.Plane(i_resolution=60, j_resolution=60, i_size=6, j_size=6)
        shaded = ground.nephoscope.sunlight(clouds=cloud.nephoscope.sunlight((0, 0, 1), multiple_scattering=False))
        x, y, _ = np.abs(ground.points.T)
        below = shaded["SunTransmittance"][(x < 0.95) & (y < 0.95)]
        np.testing.assert_allclose(below, np.exp(-1.5), rtol=0.02)
        np.testing.assert_allclose(shaded["SunTransmittance"][(x > 1.05) | (y > 1.05)], 1, rtol=1e-5)
        self.assertNotIn("SunTransmittance", ground.point_data)
        with self.assertRaisesRegex(RuntimeError, "There is no array 'Extinction'"):
            ground.nephoscope.sunlight()

    def test_messages(self):
        sheet = pyvista.Plane()
        sheet["a"] = np.ones(sheet.n_points)
        for text, options in (("scalars and sun are both given", {"scalars": "a", "sun": (0, 0, 1)}), (r"sun is \(0, 1\); it must be three numbers", {"sun": (0, 1)}),
                              ("tone_mapping is 'dark'", {"sun": (0, 0, 1), "tone_mapping": "dark"})):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                nephoscope.add_cloud_texture(pyvista.Plotter(), sheet, **options)


class Water(unittest.TestCase):
    def test_names_of_the_weather_reader(self):
        """Every name that the reader of weather knows, also in capitals, gives the same extinction."""
        for role in ("cloud_water", "cloud_ice", "rain", "snow"):
            names = set(ROLES[role].names) - {"clwmr"}
            least = {}
            for name in sorted(names | {name.upper() for name in names} - {"LWC", "IWC"}):
                least[name] = slab(**{name: 1}).nephoscope.cloud_optics()["Extinction"].max()
            self.assertEqual(len(set(least.values())), 1, f"{role}: {least}")
            self.assertGreater(min(least.values()), 0)

    def test_liquid_of_gfs_beside_its_ice(self):
        alone, both = (slab(**water).nephoscope.cloud_optics()["Extinction"].max() for water in ({"icmr": 1}, {"icmr": 1, "clwmr": 1}))
        self.assertGreater(both, 1.5 * alone)

    def test_units_and_names_in_sun(self):
        expected = lit(slab(qc=1), {"direction": (0, 0, 1)})["ScaledExtinction"]
        found = lit(slab(mine=1000), {"direction": (0, 0, 1), "liquid": "mine", "units": "g/kg"})["ScaledExtinction"]
        np.testing.assert_allclose(found, expected, rtol=1e-5)

    def test_messages_name_what_add_cells_has(self):
        for error, text, mesh, sun in (
                (RuntimeError, r"sun\['water'\], or by sun\['liquid'\]", slab(), True),
                (RuntimeError, r"as sun\['ice'\] says", slab(qc=1), {"ice": "no"}),
                (RuntimeError, r"Set sun\['units'\] to g/kg", slab(qc=1000), True),
                (RuntimeError, r"name one by sun\['extinction'\]", slab(qc=1), {"extinction": "no"}),
                (ValueError, "^sun is 'tomorrow'; it must be a date", slab(qc=1), "tomorrow"),
                (ValueError, r"^sun\['time'\] is 'tomorrow'", slab(qc=1), {"time": "tomorrow"}),
                (ValueError, r"sun\['ground_albedo'\]", slab(qc=1), {"ground_albedo": 3}),
                (ValueError, "sun has no option 'directions'", slab(qc=1), {"directions": (0, 0, 1)})):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                nephoscope.add_cells(pyvista.Plotter(), mesh, sun=sun)

    def test_water_without_temperature(self):
        """The message also says how an extinction is named."""
        mesh = pyvista.ImageData(dimensions=(6, 6, 6))
        mesh["qc"], mesh["ext"] = np.full(mesh.n_points, 1e-3), np.full(mesh.n_points, 0.1)
        with self.assertRaisesRegex(RuntimeError, r"density of the air.* name an array of the extinction coefficient.* by sun\['extinction'\]"):
            nephoscope.add_cells(pyvista.Plotter(), mesh, "qc", sun=(1, 0, 1))
        nephoscope.add_cells(pyvista.Plotter(), mesh, "qc", sun={"direction": (1, 0, 1), "extinction": "ext"})

    def test_data_without_water(self):
        """The message names an array of the mesh as the extinction, in a sun that draws it; no class that the user has not called."""
        mesh = pyvista.ImageData(dimensions=(6, 6, 6))
        mesh["v"], mesh["f"] = mesh.points, np.linspace(0, 1, mesh.n_points)
        cells = pyvista.ImageData(dimensions=(6, 6, 6))
        cells["f"] = np.linspace(0, 1, cells.n_cells)
        suns = ((1, 0, 1), np.array([1, 0, 1]), "2011-10-11 18:30", True, {"direction": [1, 0, 1]})
        cases = [(nephoscope.add_cells, mesh, sun) for sun in suns] + [(nephoscope.add_splats, cells, (1, 0, 1)), (nephoscope.add_cells, mesh.cast_to_unstructured_grid(), True)]
        for add, data, sun in cases:
            with self.subTest(add=add.__name__, sun=sun), self.assertRaisesRegex(RuntimeError, "^sun needs an extinction") as caught:
                add(pyvista.Plotter(), data, "f", sun=sun)
            remedy = str(caught.exception).split("the mesh: sun=")[1].split("}")[0] + "}"
            self.assertIn("'extinction': 'f'", remedy)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", RuntimeWarning)  # of a date without a place
                add(pyvista.Plotter(), data, "f", sun=eval(remedy))
        with self.assertRaisesRegex(RuntimeError, r"Give it one: mesh\['Extinction'\] = "):
            nephoscope.add_cells(pyvista.Plotter(), pyvista.ImageData(dimensions=(3, 3, 3)), sun=(1, 0, 1))

    def test_a_cloud_fraction_alone(self):
        """The message gives it a scale, as a fraction and as percent, by which it is lit."""
        for whole in (1.0, 100.0):
            mesh = pyvista.ImageData(dimensions=(6, 6, 6), spacing=(1e3, 1e3, 1e3))
            mesh["cloud_fraction"] = np.linspace(0, whole, mesh.n_points)
            with self.assertRaisesRegex(RuntimeError, "If the cloud fraction is all that you have") as caught:
                nephoscope.add_cells(pyvista.Plotter(), mesh, sun=(0.123456789, 0, 1))
            remedy = eval(str(caught.exception).split("overcast: sun=")[1].split("}")[0] + "}")
            self.assertEqual(remedy["direction"], (0.1235, 0.0, 1.0))
            self.assertAlmostEqual(remedy["extinction_scale"] * whole, 0.01)
            volume = nephoscope.add_cells(pyvista.Plotter(), mesh, sun=remedy)
            self.assertAlmostEqual(float(np.max(volume.mapper.dataset["ScaledExtinction"])), 0.01 * (1 - 0.85 ** 2), places=6)  # of droplets, g = 0.85

    def test_wrong_suns_come_first(self):
        """A direction without length and a time that is none are a ValueError, whatever else is missing."""
        smoke, surface = lumps(), pyvista.Sphere()
        adds = {"cells": lambda p, sun: nephoscope.add_cells(p, slab(), sun=sun), "splats": lambda p, sun: nephoscope.add_splats(p, slab(), sun=sun),
                "with extinction": lambda p, sun: nephoscope.add_cells(p, smoke, sun=sun), "surface": lambda p, sun: nephoscope.add_cloud_texture(p, surface, sun=sun),
                "haze": lambda p, sun: nephoscope.add_haze(p, sun=sun), "satellite": lambda p, sun: nephoscope.satellite_image(slab(), sun=sun)}
        for what, add in adds.items():
            for sun, text in (((0, 0, 0), r"is \(0, 0, 0\); it must be the direction towards the sun, such as"), ("noon", "is 'noon'; it must be a date and time in UTC"),
                              ("2011-40-11", "must be a date and time"), ({"direction": (0, 0, 0)}, r"\['direction'\] is \(0, 0, 0\)"),
                              ({"time": "noon"}, r"\['time'\] is 'noon'"), ((1, 0), "must be three numbers"), ((np.nan, 0, 1), "must be a finite number")):
                with self.subTest(what, sun=sun), self.assertRaisesRegex(ValueError, "^sun.*" + text), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    warnings.filterwarnings("ignore", category=DeprecationWarning)
                    add(pyvista.Plotter(), sun)
        for sun in ((0, 0, 0), "noon"):
            with self.assertRaisesRegex(ValueError, "^direction is|^time is"), warnings.catch_warnings():
                warnings.simplefilter("error", RuntimeWarning)
                smoke.nephoscope.sunlight(sun)

    def test_true_is_a_sun_in_the_south_east(self):
        """On flat data, as the documentation says; so are the steps that take the light away."""
        plotter = pyvista.Plotter()
        usual = len(plotter.renderer.lights)
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            volume = add(plotter, lumps(), sun=True)
            np.testing.assert_allclose(volume.mapper.dataset.field_data["SunDirection"][0], np.divide((1, -1, 1), 3 ** 0.5))
            self.assertEqual([light.is_scene_light for light in plotter.renderer.lights], [True])
            plotter.remove_actor(volume)
            plotter.remove_all_lights()
            plotter.enable_lightkit()
            self.assertEqual([len(plotter.renderer.lights), any(light.is_scene_light for light in plotter.renderer.lights)], [usual, False])

    def test_messages_of_plotter_functions_name_no_class(self):
        for sun, kind in (({"direction": (0, 0, -1)}, "warning"), ({"extinction": "no"}, "error"), ({"ice": "no"}, "error")):
            with self.subTest(kind, sun=sun), warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always", RuntimeWarning)
                try:
                    nephoscope.add_cells(pyvista.Plotter(), slab(qc=1), sun=sun)
                except RuntimeError as problem:
                    caught.append(problem)
            told = [str(getattr(one, "message", one)) for one in caught]
            self.assertTrue(told)
            self.assertFalse([text for text in told if "vtk" in text], told)


if __name__ == "__main__":
    unittest.main()
