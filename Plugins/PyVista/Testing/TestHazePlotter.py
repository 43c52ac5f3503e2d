# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_haze: every argument arrives, the ground is that of the mesh, and the picture of a plotter is hazed."""
import os
import unittest

import nephoscope
import numpy as np
import pyvista

FILE = os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc")


class Arguments(unittest.TestCase):
    def add(self, *args, **options):
        plotter = pyvista.Plotter(off_screen=True)
        haze = nephoscope.add_haze(plotter, *args, **options)
        self.assertIs(nephoscope.vtkHaze.GetHaze(plotter.renderer), haze)
        plotter.close()
        return haze

    def test_defaults_are_those_of_the_class(self):
        self.assertEqual(str(self.add()).split("Enabled:")[1], str(nephoscope.vtkHaze()).split("Enabled:")[1])

    def test_every_argument_arrives(self):
        haze = self.add(visibility=1e5, scale_height=2000, color="red", background=False, vertical_exaggeration=30, projection="map",
                        radius=2.0, center=(1, 2, 3), up=(0, 2, 0), base_level=-4)
        self.assertEqual((haze.GetVisibility(), haze.GetScaleHeight(), haze.GetVerticalExaggeration()), (1e5, 2000, 30))
        self.assertEqual((haze.GetColor(), haze.GetBackground(), haze.GetProjection()), ((1, 0, 0), False, 1))
        self.assertEqual((haze.GetPlanetRadius(), haze.GetCenter()), (2, (1, 2, 3)))
        self.assertEqual((haze.GetUpDirection(), haze.GetBaseLevel()), ((0, 2, 0), -4))

    def test_the_ground_is_that_of_the_mesh(self):
        weather = nephoscope.read_cf(FILE)
        globe = weather.nephoscope.globe(vertical_exaggeration=40, radius=1000.0)
        haze = self.add(globe)
        self.assertEqual((haze.GetProjection(), haze.GetVerticalExaggeration(), haze.GetPlanetRadius()), (0, 40, 1000))
        haze = self.add(weather.nephoscope.globe(projection="map", vertical_exaggeration=25))
        self.assertEqual((haze.GetProjection(), haze.GetVerticalExaggeration()), (1, 25))
        self.assertEqual(self.add(globe, vertical_exaggeration=2).GetVerticalExaggeration(), 2)

    def test_out_of_range(self):
        for options in ({"visibility": 0}, {"scale_height": -1}, {"vertical_exaggeration": np.nan}, {"radius": 0}, {"up": (0, 0, 0)},
                        {"center": (0, 0)}, {"projection": "moon"}, {"base_level": np.inf}):
            with self.assertRaisesRegex(ValueError, next(iter(options))):
                self.add(**options)


class Picture(unittest.TestCase):
    def test_clear_removes_the_haze(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 40))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Sphere())
        nephoscope.add_haze(plotter, visibility=0.5)
        hazy = plotter.screenshot(return_img=True)
        plotter.clear()
        self.assertIsNone(nephoscope.vtkHaze.GetHaze(plotter.renderer))
        plotter.add_mesh(pyvista.Sphere())
        other = pyvista.Plotter(off_screen=True, window_size=(60, 40))
        self.addCleanup(other.close)
        other.clear()  # which removes the lights too
        other.add_mesh(pyvista.Sphere())
        clear = other.screenshot(return_img=True)
        self.assertGreater(np.abs(hazy.astype(int) - clear).max(), 20)
        np.testing.assert_allclose(plotter.screenshot(return_img=True).astype(int), clear, atol=1)

    def test_thick_haze_is_all_that_is_seen(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        plotter.add_mesh(pyvista.Sphere(), color="red", lighting=False)
        plotter.add_mesh(pyvista.Cube(center=(1.5, 0, 0)), color="blue", opacity=0.5)
        nephoscope.add_haze(plotter, visibility=1e-3, scale_height=1e3, projection="map", color=(0.2, 0.6, 0.4), base_level=-100)
        picture = plotter.screenshot(return_img=True)
        plotter.close()
        np.testing.assert_allclose(picture[..., :3].reshape(-1, 3), np.tile((51, 153, 102), (3600, 1)), atol=2)


AMBIENT = 2 * (0.2 + 0.15)  # of ground and sky, times the sine of the sun's elevation


def exposed(light):
    """As a display shows it: above 0.75 of white its range is compressed, and the hue is kept."""
    most = light.max()
    above = (most - 0.75) / 0.25
    return light * (0.75 + 0.25 * above / (1 + above)) / most if most > 0.75 else light


class Sun(unittest.TestCase):
    """Haze of a vertical optical depth of 1 over flat black ground, in closed form, and on a globe."""

    def picture(self, sun, camera, asymmetry=0.0, ground=True, depth=1.0, parallel=True, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("black")
        if ground:
            plotter.add_mesh(pyvista.Plane(i_size=400, j_size=400), color="black", lighting=False)
        nephoscope.add_haze(plotter, **{"visibility": 3.912 / depth, "scale_height": 1, "projection": "map", "color": (0.9, 0.6, 0.3), "vertical_exaggeration": 1,
                                        "base_level": 1e-9, **options}, sun=sun, asymmetry=asymmetry)
        plotter.camera_position = camera
        if parallel:
            plotter.enable_parallel_projection()
            plotter.camera.parallel_scale = 1
        return plotter.screenshot(return_img=True)[..., :3] / 255

    def expect(self, found, light):
        np.testing.assert_allclose(found, exposed(np.array((0.9, 0.6, 0.3)) * light), atol=0.012)

    def scattered(self, depth, slant, weight=1.0):
        """Looking straight down, the integral over the transparency of what each layer scatters: the beam in closed form, the rest by the rule of Simpson."""
        u = np.linspace(0, depth, 2001)  # from the top
        diffuse = 1 / (1 + 0.75 * slant * u)
        rest = (weight * (diffuse - np.exp(-slant * u)) + AMBIENT / slant * diffuse) * np.exp(-u)
        weights = np.where(np.arange(2001) % 2, 4, 2)
        weights[[0, -1]] = 1
        return (1 - np.exp(-(1 + slant) * depth)) / (1 + slant) + (weights * rest).sum() * depth / 6000

    def test_from_above(self):
        """Light that reaches exp(-u) of the way down and of the way up again, and what has been scattered before."""
        down = [(0, 0, 50), (0, 0, 0), (0, 1, 0)]
        for depth in (0.2, 1.0, 3.0):
            self.expect(self.picture((0, 0, 1), down, depth=depth)[30, 30], self.scattered(depth, 1.0))
            slant = 2.0  # of a sun 30 degrees high
            self.expect(self.picture((np.sqrt(3), 0, 1), down, depth=depth)[30, 30], self.scattered(depth, slant))
            slant = 5.0  # less high than 30 degrees
            self.expect(self.picture((np.sqrt(24), 0, 1), down, depth=depth)[30, 30], self.scattered(depth, slant, 0.4))
        self.expect(self.picture((0, 0, -1), down)[30, 30], 0)

    def test_noon_is_bright_in_thick_haze(self):
        """A level look across the sun: half as bright as haze without a sun, at least, up to a vertical optical depth of 1."""
        for depth in (0.1, 0.5, 1.0):
            found = self.picture((0, 1, 2), [(0, 0, 0.05), (100, 0, 0.05), (0, 0, 1)], asymmetry=0.5, ground=False, depth=depth, base_level=0.05)[30, 30]
            self.assertGreater(found[0], 0.5 * 0.9)

    def test_phase_function(self):
        """A level look through all of the haze, towards a sun 30 degrees high and away from it: what is left of the sun, times the phase function."""
        for x in (1, -1):
            found = self.picture((np.sqrt(3) * x, 0, 1), [(0, 0, 0.05), (100, 0, 0.05), (0, 0, 1)], asymmetry=0.3, ground=False, depth=0.5, base_level=0.05)
            cosine = x * np.sqrt(0.75)
            self.expect(found[30, 30], np.exp(-1) * (1 - 0.09) / (1.09 - 0.6 * cosine) ** 1.5 + (1 + 0.5 * AMBIENT) / (1 + 0.75 * 0.7) - np.exp(-1))

    def test_the_horizon_away_from_the_sun_is_bright_by_day(self):
        """Compared with the brightness of haze without a sun. No setting but the sun is given."""
        for elevation, least in ((35, 0.55), (60, 0.8), (15, 0.3)):
            a = np.radians(elevation)
            plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
            self.addCleanup(plotter.close)
            plotter.set_background("black")
            plotter.add_mesh(pyvista.Plane(i_size=9000, j_size=9000), color="darkgreen")
            plotter.add_mesh(pyvista.Sphere(radius=400, center=(0, 0, 900)))
            nephoscope.add_haze(plotter, sun=(-np.cos(a), 0, np.sin(a)), color="white")
            plotter.camera_position = [(-5000, 0, 200), (0, 0, 200), (0, 0, 1)]
            picture = plotter.screenshot(return_img=True)[..., :3] / 255
            self.assertGreater(picture[:, 3].min(axis=1).max(), least, f"sun {elevation} degrees high")

    def test_haze_around_the_sun_is_not_white(self):
        """Nothing is set: the colour of the haze stays, and so does the way in which it becomes brighter towards the sun."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(90, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("black")
        plotter.add_mesh(pyvista.Plane(i_size=9000, j_size=9000), color="darkgreen")
        plotter.add_mesh(pyvista.Sphere(radius=400, center=(0, 3000, 900)))
        nephoscope.add_haze(plotter, sun=(1, 0, 0.2))
        plotter.camera_position = [(-5000, 0, 200), (0, 0, 700), (0, 0, 1)]
        row = plotter.screenshot(return_img=True)[20].astype(int)
        self.assertTrue((np.diff(row[:45, 0]) >= 0).all() and row[44, 0] > row[0, 0] + 10, row[:, 0])
        self.assertLess(row[:, 0].max(), 0.85 * row[45, 2])

    def test_night_of_a_globe(self):
        row = self.picture((1, 0, 0), [(0, -3e7, 0), (0, 0, 0), (0, 0, 1)], ground=False, projection="globe", scale_height=8e3, vertical_exaggeration=20, visibility=1e6,
                           base_level=0, parallel=False)[30].max(axis=1)
        self.assertGreater(row[35:50].max(), 0.2)
        self.assertLess(row[:20].max(), 0.02)

    def test_forms_of_the_sun(self):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        globe = nephoscope.read_cf(FILE).nephoscope.globe()
        self.assertEqual(nephoscope.add_haze(plotter, globe, sun=(0, 0, 2)).GetSunDirection(), (0, 0, 1))
        noon = nephoscope.add_haze(plotter, globe, sun="2011-03-21 12:08").GetSunDirection()
        np.testing.assert_allclose(noon, (1, 0, 0), atol=0.02)
        np.testing.assert_allclose(nephoscope.add_haze(plotter, sun={"time": "2011-03-21 12:08", "place": (0, 0)}).GetSunDirection(), (0, 0, 1), atol=0.02)
        with self.assertRaisesRegex(ValueError, "sun is True, but no mesh with light"):
            nephoscope.add_haze(pyvista.Plotter(off_screen=True), sun=True)
        ball = pyvista.Sphere()
        ball.field_data["SunDirection"] = [(0.0, 0.6, 0.8)]
        plotter.add_mesh(globe)  # has none, and comes before
        plotter.add_mesh(ball)
        self.assertEqual(nephoscope.add_haze(plotter, sun=True).GetSunDirection(), (0, 0.6, 0.8))
        for text, options in ((r"sun is \(0, 1\)", {"sun": (0, 1)}), ("asymmetry is 2", {"asymmetry": 2})):
            with self.assertRaisesRegex(ValueError, text):
                nephoscope.add_haze(plotter, globe, **options)


if __name__ == "__main__":
    unittest.main()
